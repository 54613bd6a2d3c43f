//! The page of `washout live` on which frames of a video are marked: one HTML file, everything in it.
//!
//! What is on it lies in files named after what a user sees: the picture, the points, the camera, the twist. Elements, the chart and how
//! the program is asked are those of the page of a wing.

use super::live::framed;

const BODY: &str = include_str!("frames.html");
const OWN_STYLE: &str = include_str!("frames.css");
const PLAIN: &str = include_str!("../viewer/plain.js");
/// What the page does; the last file puts it together.
const SCRIPT: &str = concat!(
    include_str!("../live/element.js"),
    include_str!("../live/number.js"),
    include_str!("../live/hearers.js"),
    include_str!("../live/asked.js"),
    include_str!("../live/chart.js"),
    include_str!("state.js"),
    include_str!("points.js"),
    include_str!("guides.js"),
    include_str!("picture.js"),
    include_str!("strip.js"),
    include_str!("camera.js"),
    include_str!("twist.js"),
    include_str!("saving.js"),
    include_str!("keys.js"),
    include_str!("begin.js"),
);

/// The page that the program serves; its styles and its script carry the nonce.
pub fn page(nonce: &str) -> String {
    let script =
        format!("var wingView = (function () {{\n{PLAIN}return {{ plain: plain }};\n}})();\n{SCRIPT}");
    framed(nonce, "", OWN_STYLE, BODY, &script)
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
        let scripts: Vec<&str> = html.split("<script").skip(1).collect();
        assert_eq!(scripts.len(), 1);
        assert!(scripts[0].starts_with(" nonce=\"abc123\">"));
        assert!(!SCRIPT.contains("</"), "the script would end itself");
        let body = html.split("<script").next().unwrap_or_default();
        let mut words = body.split_whitespace();
        assert!(!words.any(|word| word.starts_with("on") && word.contains("=\"")));
    }
}
