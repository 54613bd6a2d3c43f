//! The page: head, sections, the documents behind them.

use std::fmt::Write;

use super::GENERATOR;
use super::document::{Document, Shown};
use crate::plot::pen::escaped;

pub(super) const STYLE: &str = include_str!("style.css");
/// What draws and turns the wing.
pub(super) const VIEWER_FILES: &str = concat!(
    include_str!("viewer/plain.js"),
    include_str!("viewer/wing.js"),
    include_str!("viewer/measured.js"),
    include_str!("viewer/camera.js"),
    include_str!("viewer/mesh.js"),
    include_str!("viewer/webgl.js"),
    include_str!("viewer/painter.js"),
    include_str!("viewer/legend.js"),
    include_str!("viewer/cursor.js"),
    include_str!("viewer/controls.js"),
    include_str!("viewer/hands.js"),
    include_str!("viewer/start.js"),
);
/// What starts it in a report.
const BEGIN: &str = include_str!("viewer/begin.js");

/// A part of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Where links lead to.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// What stands in it.
    pub html: String,
}

/// A page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Page {
    /// Name of the wing or study.
    pub title: String,
    /// What stands above all sections.
    pub lead: String,
    /// The sections; those without anything in them are left out.
    pub sections: Vec<Section>,
    /// The documents that the numbers come from.
    pub documents: Vec<Document>,
}

impl Page {
    /// Adds a section.
    pub fn section(&mut self, id: &'static str, title: &'static str, html: String) {
        self.sections.push(Section { id, title, html });
    }

    /// The file.
    pub fn html(&self) -> String {
        let title = escaped(&self.title);
        let shown = || self.sections.iter().filter(|section| !section.html.is_empty());
        let mut html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             {GENERATOR}{}\">\n<title>{title} – washout</title>\n\
             <link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>{title}</h1>\n{}</header>\n",
            env!("CARGO_PKG_VERSION"),
            self.lead
        );
        html.push_str("<nav aria-label=\"Sections\">\n");
        // Writing to a String cannot fail.
        for Section { id, title, .. } in shown() {
            let _ = writeln!(html, "<a href=\"#{id}\">{title}</a>");
        }
        html.push_str("</nav>\n<main>\n");
        for Section {
            id,
            title,
            html: body,
        } in shown()
        {
            let _ = writeln!(html, "<section id=\"{id}\">\n<h2>{title}</h2>\n{body}</section>");
        }
        html.push_str("</main>\n");
        for document in &self.documents {
            html.push_str(&document.element());
        }
        if html.contains("id=\"wing-data\"") {
            let _ = writeln!(
                html,
                "<script>\n(function () {{\n\"use strict\";\n{VIEWER_FILES}{BEGIN}}})();\n</script>"
            );
        }
        html.push_str("</body>\n</html>\n");
        html
    }
}

/// The numbers above all: name, number, unit; those that there are not are left out.
pub fn headline(entries: &[(&str, Shown, &str)]) -> String {
    let mut html = String::new();
    for (name, shown, unit) in entries.iter().filter(|(_, shown, _)| !shown.html.is_empty()) {
        let _ = writeln!(
            html,
            "<div><dt>{}</dt><dd>{} <small>{}</small></dd></div>",
            escaped(name),
            shown.html,
            escaped(unit)
        );
    }
    if html.is_empty() {
        return html;
    }
    format!("<dl class=\"headline\">\n{html}</dl>\n")
}

/// What a reader must mind, set apart; nothing if there is nothing.
pub fn mind(lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    format!(
        "<div class=\"mind\" role=\"note\"><strong>Notes</strong>\n{}</div>\n",
        super::table::list(lines)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_needs_nothing_from_outside_and_a_title_stays_text() {
        let mut page = Page {
            title: "<b>wing</b>".to_string(),
            ..Page::default()
        };
        page.section("data", "Data", "<p id=\"wing-data\"></p>".to_string());
        page.section("empty", "Empty", String::new());
        let html = page.html();
        assert!(html.contains("<h1>&lt;b&gt;wing&lt;/b&gt;</h1>"), "{html}");
        assert!(!html.contains("Empty"), "{html}");
        for outside in ["src=", "href=\"http", "url(", "@import", "fetch(", "import("] {
            assert!(!html.contains(outside), "{outside}");
        }
        for code in [VIEWER_FILES, BEGIN] {
            assert!(!code.contains("</"), "the viewer would end its own script");
        }
    }
}
