//! The page of `washout live`: one HTML file, everything in it, filled by the program that serves it.
//!
//! The wing is drawn by the viewer of the report. What else is on the page lies in files named after what a user sees: sliders, the
//! curve, the error step by step. None of them reaches out of the page but to the program itself, below its own address.

use super::GENERATOR;
use super::page::{STYLE, VIEWER_FILES};
use super::script::in_script;
use super::wing::MAP;

const BODY: &str = include_str!("live.html");
const OWN_STYLE: &str = include_str!("live.css");
/// The viewer of the report, and how shapes come to it one after the other.
const VIEW: &str = include_str!("wing_view.js");
const STAGE: &str = include_str!("../viewer/live.html");
/// What the page does; the last file puts it together.
const SCRIPT: &str = concat!(
    include_str!("element.js"),
    include_str!("number.js"),
    include_str!("hearers.js"),
    include_str!("state.js"),
    include_str!("asked.js"),
    include_str!("server.js"),
    include_str!("grid.js"),
    include_str!("chart.js"),
    include_str!("curve.js"),
    include_str!("attack.js"),
    include_str!("figures.js"),
    include_str!("ladder.js"),
    include_str!("slider.js"),
    include_str!("inputs.js"),
    include_str!("effects.js"),
    include_str!("cases.js"),
    include_str!("history.js"),
    include_str!("status.js"),
    include_str!("hypothesis.js"),
    include_str!("missing.js"),
    include_str!("save.js"),
    include_str!("sheet.js"),
    include_str!("keyboard.js"),
    include_str!("begin.js"),
);

/// The page that the program serves. Its styles and its script carry the nonce, so that a policy of
/// `script-src 'nonce-…'; style-src 'nonce-…'` lets nothing else run; `nonce` must be made of letters, digits, `+`, `/`, `=`, `-`, `_`.
pub fn page(nonce: &str) -> String {
    document(nonce, "", "")
}

/// The page as a file for others: sliders move through what was solved on a grid (`grid.js` says what `grid`, a JSON document, holds).
/// It carries its policy itself; nothing in it reaches out of the file.
pub fn alone(grid: &str) -> String {
    let policy = format!(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'nonce-{OF_FILE}'; \
         style-src 'nonce-{OF_FILE}'; img-src data:; base-uri 'none'; form-action 'none'\">\n"
    );
    let data = format!(
        "<script type=\"application/json\" id=\"grid\">{}</script>\n",
        in_script(grid)
    );
    document(OF_FILE, &policy, &data)
}

/// The nonce of a file, in which nobody else can write.
const OF_FILE: &str = "washout";

fn document(nonce: &str, policy: &str, data: &str) -> String {
    let map: Vec<String> = MAP.iter().map(|[r, g, b]| format!("[{r},{g},{b}]")).collect();
    let body = format!(
        "{}<script type=\"application/json\" id=\"wing-map\">[{}]</script>\n{data}",
        BODY.replace("{viewer}", STAGE),
        map.join(","),
    );
    let script = format!("var wingView = (function () {{\n{VIEWER_FILES}{VIEW}}})();\n{SCRIPT}");
    framed(nonce, policy, "", &body, &script)
}

/// A page of this program: its styles and its script carry the nonce.
pub(super) fn framed(nonce: &str, policy: &str, style: &str, body: &str, script: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{policy}\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         {GENERATOR}{version}\">\n<title>washout live</title>\n<link rel=\"icon\" href=\"data:,\">\n\
         <style nonce=\"{nonce}\">\n{STYLE}{OWN_STYLE}{style}</style>\n</head>\n<body>\n{body}\
         <script nonce=\"{nonce}\">\n(function () {{\n\"use strict\";\n{script}}})();\n</script>\n</body>\n</html>\n",
        version = env!("CARGO_PKG_VERSION"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_needs_nothing_from_outside_and_runs_nothing_without_the_nonce() {
        let html = page("abc123");
        for outside in [
            "src=",
            "href=\"http",
            "url(",
            "@import",
            "import(",
            "eval(",
            "style=\"",
            "<!--",
        ] {
            assert!(!html.contains(outside), "{outside}");
        }
        let inline = handlers_of(&html);
        assert!(inline.is_empty(), "handlers in the page: {inline:?}");
        let scripts: Vec<&str> = html.split("<script").skip(1).collect();
        assert_eq!(scripts.len(), 2);
        assert!(scripts[0].starts_with(" type=\"application/json\""));
        assert!(scripts[1].starts_with(" nonce=\"abc123\">"));
        for code in [SCRIPT, VIEW, VIEWER_FILES] {
            assert!(!code.contains("</"), "the script would end itself");
        }
    }

    #[test]
    fn what_stands_in_a_grid_cannot_end_its_element() {
        let html = alone("{\"name\":\"</script><b>\"}");
        assert!(html.contains("\\u003c/script\\u003e\\u003cb\\u003e"));
        assert!(!html.contains("</script><b>"));
        assert!(html.contains("http-equiv=\"Content-Security-Policy\""));
    }

    /// Words such as ` onclick="` in the elements of the page.
    fn handlers_of(html: &str) -> Vec<&str> {
        let body = html.split("<script").next().unwrap_or_default();
        body.split_whitespace()
            .filter(|word| word.starts_with("on") && word.contains("=\""))
            .collect()
    }
}
