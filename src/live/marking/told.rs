//! What the marks give so far: twist with its error, and what is still to be clicked.

use serde::Serialize;

use super::marks::Marks;
use crate::export::marks::{marks_csv, video_toml};
use crate::export::video::MeasureReport;
use crate::input::video::{Click, LoadedVideo, Which};
use crate::live::refusal::Refusal;

/// A point that is still to be clicked.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Lack {
    /// Frame.
    pub frame: String,
    /// Station, mm; none for a reference point.
    pub r_mm: Option<f64>,
    /// What.
    pub mark: Which,
}

/// What the marks say.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Told {
    /// What `washout measure` gives for the points that are whole.
    pub report: Option<MeasureReport>,
    /// Points without which others do not count.
    pub lacks: Vec<Lack>,
    /// Why there is no twist yet.
    pub refusal: Option<Refusal>,
}

impl Told {
    /// Of marks on these frames.
    pub fn of(marks: &Marks, frames: &[String]) -> Told {
        let mut lacks = lacks(marks, frames);
        let whole: Vec<Click> = marks
            .clicks
            .iter()
            .filter(|click| !lacks.iter().any(|lack| is_spoiled(click, lack, marks)))
            .cloned()
            .collect();
        // reference points alone make no frame
        let has_edge = |frame: &str| {
            whole
                .iter()
                .any(|click| click.frame == frame && click.r_mm.is_some())
        };
        let clicks: Vec<Click> = whole
            .iter()
            .filter(|click| has_edge(&click.frame))
            .cloned()
            .collect();
        lacks.dedup();
        let refused = |message: &str| Told {
            lacks: lacks.clone(),
            refusal: Some(Refusal::new(message)),
            ..Told::default()
        };
        match &marks.video.rest {
            _ if clicks.is_empty() => return refused("No station has both edges yet."),
            Some(rest) if !has_edge(rest) => {
                return refused("The frame at rest has no station with both edges yet.");
            }
            Some(rest) if clicks.iter().all(|click| click.frame == *rest) => {
                return refused("Now click the same stations in a frame under load.");
            }
            _ => {}
        }
        let (toml, csv) = (video_toml(&marks.video), marks_csv(&clicks, frames));
        match LoadedVideo::read(("the video", &toml), ("the marks", &csv)) {
            Ok(loaded) => Told {
                report: Some(MeasureReport::new(&loaded, String::new())),
                lacks,
                refusal: None,
            },
            Err(error) => Told {
                report: None,
                lacks,
                refusal: Some(error.into()),
            },
        }
    }
}

/// Edges and references without their partner, and stations that the frame at rest does not have.
fn lacks(marks: &Marks, frames: &[String]) -> Vec<Lack> {
    let has = |frame: &str, mark: Which, r_mm: Option<f64>| {
        let mut clicks = marks.clicks.iter();
        clicks.any(|click| click.frame == frame && click.mark == mark && click.r_mm == r_mm)
    };
    let mut found: Vec<Lack> = Vec::new();
    let mut lack = |frame: &str, mark: Which, r_mm: Option<f64>| {
        let own = Lack {
            frame: frame.to_string(),
            r_mm,
            mark,
        };
        if !has(frame, mark, r_mm) && !found.contains(&own) {
            found.push(own);
        }
    };
    for frame in frames {
        for click in marks.clicks.iter().filter(|click| click.frame == *frame) {
            lack(frame, partner(click.mark), click.r_mm);
            if let (Some(rest), Some(_)) = (&marks.video.rest, click.r_mm) {
                lack(rest, Which::Leading, click.r_mm);
                lack(rest, Which::Trailing, click.r_mm);
            }
        }
    }
    found
}

/// Whether a click does not count because of a point that is missing.
fn is_spoiled(click: &Click, lack: &Lack, marks: &Marks) -> bool {
    let is_rest = marks.video.rest.as_ref() == Some(&lack.frame);
    click.r_mm == lack.r_mm && (click.frame == lack.frame || is_rest && lack.r_mm.is_some())
}

fn partner(mark: Which) -> Which {
    match mark {
        Which::Leading => Which::Trailing,
        Which::Trailing => Which::Leading,
        Which::ReferenceA => Which::ReferenceB,
        Which::ReferenceB => Which::ReferenceA,
    }
}
