//! The wings of a report: stills, and one to be turned.

use std::fmt::Write;

use crate::export::ExportError;

use super::script::in_script;
use super::still::still;
use super::stroke::Stroke;
use super::table::paragraph;
use super::wing::{MAP, Wing};

/// What the viewer fills and draws on.
const LIVE: &str = include_str!("viewer/live.html");

/// Wings of a study, and what is not shown of them.
#[derive(Debug, Clone, Default)]
pub struct Wings {
    /// Those shown.
    pub shown: Vec<Wing>,
    /// What is not shown, and why.
    pub notes: Vec<String>,
}

impl Wings {
    /// Those of `more` besides.
    pub fn extend(&mut self, more: Wings) {
        self.shown.extend(more.shown);
        self.notes.extend(more.notes);
    }

    /// The section that shows them and says what it does not show.
    ///
    /// # Errors
    /// If a value is not finite.
    pub fn section(&self) -> Result<String, ExportError> {
        let mut html = section(&self.shown)?;
        for words in &self.notes {
            html.push_str(&paragraph(words));
        }
        Ok(html)
    }
}

/// The wings as they stand in the page: a still picture, and a viewer that takes its place where scripts run.
///
/// # Errors
/// If a value is not finite.
pub fn section(wings: &[Wing]) -> Result<String, ExportError> {
    let Some(first) = wings.first() else {
        return Ok(String::new());
    };
    let shown: Vec<String> = wings.iter().map(Wing::json).collect::<Result<_, _>>()?;
    let map: Vec<String> = MAP.iter().map(|[r, g, b]| format!("[{r},{g},{b}]")).collect();
    let mut html = String::from("<div class=\"wing\">\n");
    // Writing to a String cannot fail.
    let _ = writeln!(html, "<div id=\"wing-still\">{}</div>", still(first));
    html.push_str(LIVE);
    let _ = writeln!(
        html,
        "<script type=\"application/json\" id=\"wing-data\">{{\"map\":[{}],\"wings\":[{}]}}</script>",
        map.join(","),
        in_script(&shown.join(","))
    );
    let strokes = wings.iter().filter_map(|wing| wing.stroke.as_ref());
    for words in strokes.filter_map(Stroke::note) {
        html.push_str(&paragraph(&words));
    }
    if wings.len() > 1 {
        html.push_str(
            "<p class=\"quiet screen\">All wings share one scale of colours. Two states of a wing are held against each other by \
             choosing one as wing and the other as ghost.</p>\n",
        );
    }
    Ok(html)
}
