//! What the marks give so far: twist with its error, and what is still to be clicked.

use serde::Serialize;

use super::marks::Marks;
use crate::export::marks::{marks_csv, video_toml};
use crate::export::video::MeasureReport;
use crate::input::video::{Click, LoadedVideo, Video, Which};
use crate::live::refusal::Refusal;

/// Error of a click where nothing says what it is, px.
const ASSUMED_PX: f64 = 1.0;

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
    /// Whether the error of a click is a guess, for nothing says what it is.
    pub is_assumed: bool,
    /// Why there is no twist yet.
    pub refusal: Option<Refusal>,
}

impl Told {
    /// Of marks on these frames.
    pub fn of(marks: &Marks, frames: &[String]) -> Told {
        let lacks = lacks(marks, frames);
        let clicks = whole(marks, &lacks);
        match unready(marks, &clicks) {
            Some(refusal) => Told {
                lacks,
                refusal: Some(refusal),
                ..Told::default()
            },
            None => Told {
                lacks,
                ..read(&marks.video, &marks_csv(&clicks, frames))
            },
        }
    }
}

/// The clicks that count: those of points that are whole, in frames that show an edge.
fn whole(marks: &Marks, lacks: &[Lack]) -> Vec<Click> {
    let counts = |click: &&Click| !lacks.iter().any(|lack| is_spoiled(click, lack, marks));
    let whole: Vec<&Click> = marks.clicks.iter().filter(counts).collect();
    // reference points alone make no frame
    let has_edge = |frame: &str| {
        let mut clicks = whole.iter();
        clicks.any(|click| click.frame == frame && click.r_mm.is_some())
    };
    let kept = whole.iter().filter(|click| has_edge(&click.frame));
    kept.map(|click| (*click).clone()).collect()
}

/// What comes next, while there is no twist to be read.
fn unready(marks: &Marks, clicks: &[Click]) -> Option<Refusal> {
    // how the camera stood is asked for from the start
    if let Err(error) = Video::read("the video", &video_toml(&marks.video)) {
        return Some(error.into());
    }
    let is_in = |frame: &String| clicks.iter().any(|click| click.frame == *frame);
    let message = match &marks.video.rest {
        None if marks.clicks.is_empty() => {
            "Begin with a frame that shows the wing untwisted, and tick it as such."
        }
        _ if clicks.is_empty() => "No station has both edges yet.",
        Some(rest) if !is_in(rest) => "The frame at rest has no station with both edges yet.",
        Some(rest) if clicks.iter().all(|click| click.frame == *rest) => {
            "Now click the same stations in a frame under load."
        }
        _ => return None,
    };
    Some(Refusal::new(message))
}

/// The twist of marks, as `washout measure` reads them.
fn read(video: &Video, csv: &str) -> Told {
    let read = |video: &Video| LoadedVideo::read(("the video", &video_toml(video)), ("the marks", csv));
    let (found, is_assumed) = match read(video) {
        // the twist is shown as it grows; a measurement needs an error that somebody stands for
        Err(error) if error.key == "sigma_px" => {
            let sigma_px = Some(ASSUMED_PX);
            let video = video.clone();
            (read(&Video { sigma_px, ..video }), true)
        }
        found => (found, false),
    };
    match found {
        Ok(loaded) => Told {
            report: Some(MeasureReport::new(&loaded, String::new())),
            is_assumed,
            ..Told::default()
        },
        Err(error) => Told {
            refusal: Some(error.into()),
            ..Told::default()
        },
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
