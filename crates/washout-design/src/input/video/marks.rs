//! Marks of a video: clicks on one point averaged, their scatter kept.

use serde::{Deserialize, Serialize};

use crate::input::error::{InputError, Range};
use crate::input::file;
use crate::input::table::{Record, Table};

/// Columns of a file of marks.
const COLUMNS: [&str; 5] = ["frame", "r_mm", "mark", "x_px", "y_px"];
/// Columns that may be left out: repeats are told by number, the chord serves where no frame shows the wing untwisted.
const OPTIONAL: [&str; 2] = ["repeat", "chord_mm"];

/// A point of a frame; y down, as images have it.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Line of its first click.
    pub line: usize,
    /// Mean of its clicks, px.
    pub x_px: f64,
    /// Mean of its clicks, px.
    pub y_px: f64,
    /// How many clicks.
    pub clicks: usize,
    /// Sum of squares of both coordinates about their means, px²; has 2 (clicks − 1) degrees of freedom.
    pub scatter_px2: f64,
}

/// What was clicked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Which {
    /// The leading edge.
    Leading,
    /// The trailing edge.
    Trailing,
    /// The first of two points that do not move.
    ReferenceA,
    /// The second.
    ReferenceB,
}

/// One click, as a row of the file of marks has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Click {
    /// Name of the frame.
    pub frame: String,
    /// Station, mm from the wing base; none for a reference point.
    pub r_mm: Option<f64>,
    /// What was clicked.
    pub mark: Which,
    /// To the right, px.
    pub x_px: f64,
    /// Down, px.
    pub y_px: f64,
    /// Chord at the station, mm, where it was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chord_mm: Option<f64>,
}

impl Click {
    /// Whether both are of the same point of the same frame: repeats.
    pub fn is_repeat_of(&self, other: &Click) -> bool {
        (self.frame.as_str(), self.mark, self.r_mm) == (other.frame.as_str(), other.mark, other.r_mm)
    }

    /// Every click of a file of marks, points in its order, also where a partner is still missing.
    ///
    /// # Errors
    /// A row that is none, with place and cure.
    pub fn load(path: &std::path::Path) -> Result<Vec<Click>, InputError> {
        let text = file::read_text(path, "file of marks")?;
        let points = read(&file::shown(path), &text)?;
        Ok(points.iter().flat_map(Point::clicks).collect())
    }
}

/// The clicks on one point of one frame, as they stand.
pub(super) struct Point {
    pub frame: String,
    pub which: Which,
    /// Station; none for references.
    pub r_mm: Option<f64>,
    pub chord_mm: Option<f64>,
    pub record: Record,
    clicks: Vec<(String, [f64; 2])>,
}

impl Which {
    /// The word in the column `mark`.
    pub fn name(self) -> &'static str {
        match self {
            Which::Leading => "leading",
            Which::Trailing => "trailing",
            Which::ReferenceA => "reference_a",
            Which::ReferenceB => "reference_b",
        }
    }

    /// Whether it belongs to no station.
    pub fn is_reference(self) -> bool {
        matches!(self, Which::ReferenceA | Which::ReferenceB)
    }
}

impl Point {
    fn clicks(&self) -> impl Iterator<Item = Click> + '_ {
        self.clicks.iter().map(|(_, [x_px, y_px])| Click {
            frame: self.frame.clone(),
            r_mm: self.r_mm,
            mark: self.which,
            x_px: *x_px,
            y_px: *y_px,
            chord_mm: self.chord_mm,
        })
    }

    pub fn mark(&self) -> Mark {
        let count = self.clicks.len() as f64;
        let mean = [0, 1].map(|axis| self.clicks.iter().map(|(_, at)| at[axis]).sum::<f64>() / count);
        let off = |(_, at): &(String, [f64; 2])| (at[0] - mean[0]).powi(2) + (at[1] - mean[1]).powi(2);
        Mark {
            line: self.record.line,
            x_px: mean[0],
            y_px: mean[1],
            clicks: self.clicks.len(),
            scatter_px2: self.clicks.iter().map(off).sum(),
        }
    }
}

/// Reads all points of a file, in its order.
pub(super) fn read(file: &str, text: &str) -> Result<Vec<Point>, InputError> {
    let mut points: Vec<Point> = Vec::new();
    for record in Table::parse(file, text, &COLUMNS, &OPTIONAL)?.records {
        let frame = frame(&record)?;
        let words = [
            Which::Leading,
            Which::Trailing,
            Which::ReferenceA,
            Which::ReferenceB,
        ];
        let words = words.map(|which| (which.name(), which));
        let which = record.word(
            "mark",
            &words,
            "Say which point was clicked: that on the leading edge, ...",
        )?;
        let r_mm = station(&record, which)?;
        let chord_mm = match record.text("chord_mm") {
            "" => None,
            _ => {
                let cure = "Give the chord at the station in millimetres, e.g. 20.5";
                Some(record.number_in("chord_mm", length(true), cure)?)
            }
        };
        let click = (
            record.text("repeat").to_string(),
            [coordinate(&record, "x_px")?, coordinate(&record, "y_px")?],
        );
        let same = |point: &&mut Point| {
            (point.frame.as_str(), point.which, point.r_mm) == (frame.as_str(), which, r_mm)
        };
        match points.iter_mut().find(same) {
            None => points.push(Point {
                frame,
                which,
                r_mm,
                chord_mm,
                record,
                clicks: vec![click],
            }),
            Some(point) if point.clicks.iter().any(|(repeat, _)| *repeat == click.0) => {
                let message = format!("was clicked already on line {}", point.record.line);
                let cure = "Delete one of them, or number the repeats in the column repeat";
                return Err(record.conflict("mark", message, &["frame", "r_mm", "repeat"], cure));
            }
            Some(point) => {
                point.clicks.push(click);
                point.chord_mm = point.chord_mm.or(chord_mm);
            }
        }
    }
    Ok(points)
}

fn frame(record: &Record) -> Result<String, InputError> {
    let frame = record.text("frame").to_string();
    if frame.is_empty() {
        let cure = "Name the frame, e.g. rest or aero-5-30; the name becomes that of the measured case";
        return Err(record.conflict("frame", "is missing", &[], cure));
    }
    let allowed = |c: char| c.is_ascii_alphanumeric() || "_-.".contains(c);
    if !frame.chars().all(allowed) {
        let cure = "Use letters, digits, -, _ and . only: the name becomes that of the measured case";
        return Err(record.conflict("frame", "is no name", &[], cure));
    }
    Ok(frame)
}

fn coordinate(record: &Record, column: &str) -> Result<f64, InputError> {
    let cure = "Give the pixel coordinate, x to the right and y down, e.g. 512.5";
    let range = Range {
        low: -1e6,
        high: 1e6,
        open: false,
        unit: "px",
    };
    record.number_in(column, range, cure)
}

fn station(record: &Record, which: Which) -> Result<Option<f64>, InputError> {
    match (which.is_reference(), record.text("r_mm")) {
        (false, _) => {
            let cure = "Give the distance of the mark from the wing base on the wing at rest, in millimetres";
            record.number_in("r_mm", length(false), cure).map(Some)
        }
        (true, "") => Ok(None),
        (true, _) => Err(record.conflict(
            "r_mm",
            "does not belong to a reference point",
            &["mark"],
            "Leave it empty",
        )),
    }
}

fn length(open: bool) -> Range {
    Range {
        low: 0.0,
        high: 100000.0,
        open,
        unit: "mm",
    }
}
