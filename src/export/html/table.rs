//! Tables of a page.

use std::fmt::Write;

use super::document::Shown;
use crate::plot::pen::escaped;

/// A table: a head, rows, numbers to the right and words to the left.
#[derive(Debug, Clone, Default)]
pub struct HtmlTable {
    caption: String,
    head: Vec<String>,
    rows: Vec<(&'static str, Vec<Shown>)>,
}

impl HtmlTable {
    /// A table with these heads.
    pub fn new(head: &[&str]) -> HtmlTable {
        HtmlTable {
            head: head.iter().map(|name| name.to_string()).collect(),
            ..HtmlTable::default()
        }
    }

    /// With a caption.
    pub fn caption(mut self, text: &str) -> HtmlTable {
        self.caption = text.to_string();
        self
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<Shown>) {
        self.rows.push(("", cells));
    }

    /// Adds a row of a class of its own.
    pub fn marked(&mut self, class: &'static str, cells: Vec<Shown>) {
        self.rows.push((class, cells));
    }

    /// Rows besides the head.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The table; nothing if it has no rows. Columns in which nothing stands are left out.
    pub fn html(&self) -> String {
        if self.is_empty() {
            return String::new();
        }
        let cells = |column: usize| self.rows.iter().filter_map(move |(_, row)| row.get(column));
        let kept: Vec<(usize, bool)> = (0..self.head.len())
            .filter(|&column| cells(column).any(|cell| !cell.html.is_empty()))
            .map(|column| {
                (
                    column,
                    cells(column).all(|cell| cell.is_number || cell.html.is_empty()),
                )
            })
            .collect();
        let class = |is_number: bool| if is_number { " class=\"n\"" } else { "" };
        let mut html = String::from("<div class=\"table\"><table>\n");
        // Writing to a String cannot fail.
        if !self.caption.is_empty() {
            let _ = writeln!(html, "<caption><span>{}</span></caption>", escaped(&self.caption));
        }
        html.push_str("<thead><tr>");
        for &(column, is_number) in &kept {
            let _ = write!(
                html,
                "<th scope=\"col\"{}>{}</th>",
                class(is_number),
                escaped(&self.head[column])
            );
        }
        html.push_str("</tr></thead>\n<tbody>\n");
        for (mark, row) in &self.rows {
            match mark {
                &"" => html.push_str("<tr>"),
                mark => {
                    let _ = write!(html, "<tr class=\"{mark}\">");
                }
            }
            for &(column, is_number) in &kept {
                let cell = row.get(column).map_or("", |cell| cell.html.as_str());
                let _ = write!(html, "<td{}>{cell}</td>", class(is_number));
            }
            html.push_str("</tr>\n");
        }
        html.push_str("</tbody></table></div>\n");
        html
    }

    /// The table, folded where it has more than so many rows.
    pub fn folded(&self, above: usize, title: &str) -> String {
        if self.len() <= above {
            return self.html();
        }
        folded(&format!("{title} ({} rows)", self.len()), &self.html())
    }
}

/// Something under a line that opens it.
pub fn folded(title: &str, html: &str) -> String {
    format!(
        "<details><summary>{}</summary>\n{html}</details>\n",
        escaped(title)
    )
}

/// A paragraph of any text.
pub fn paragraph(text: &str) -> String {
    format!("<p>{}</p>\n", escaped(text))
}

/// A list of sentences; nothing if there are none.
pub fn list(lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let items: String = lines
        .iter()
        .map(|line| format!("<li>{}</li>\n", escaped(line)))
        .collect();
    format!("<ul class=\"notes\">\n{items}</ul>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_without_anything_are_left_out_and_words_stay_text() {
        let mut table = HtmlTable::new(&["name", "sigma", "why"]);
        table.row(vec![Shown::text("a<b"), Shown::default(), Shown::text("stated")]);
        let html = table.html();
        assert!(html.contains("<td>a&lt;b</td><td>stated</td>"), "{html}");
        assert!(!html.contains("sigma"), "{html}");
    }
}
