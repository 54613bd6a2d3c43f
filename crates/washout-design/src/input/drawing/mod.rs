//! The outline of a wing from a drawing, DXF or SVG: its largest closed line, in millimetres.

mod chain;

mod curve;

mod dxf;

mod svg;

use std::path::Path;

use super::error::InputError;
use super::file::{read_input, shown};
use crate::origin::InputFile;

/// A closed line that was drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// Its file.
    pub file: InputFile,
    /// Its points in order, x to the right and y upward, mm; the last is joined to the first.
    pub outline_mm: Vec<[f64; 2]>,
    /// What a unit of the drawing was taken for, in words.
    pub unit: String,
    /// What else stands in the drawing and was not taken: its kind, and how many (at least one).
    pub left_out: Vec<(String, usize)>,
}

impl Drawing {
    /// Reads the largest closed line of a drawing, ASCII DXF or SVG by its ending. Curves become short straight lines.
    ///
    /// # Errors
    /// If the file cannot be read, is neither of the two, or holds no closed line.
    pub fn load(path: &Path) -> Result<Drawing, InputError> {
        let name = shown(path);
        let ending = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        let read = match ending.as_str() {
            "dxf" => dxf::lines_mm,
            "svg" => svg::lines_mm,
            _ => {
                let cure = "Give an ASCII DXF (R12 or later) or an SVG, by its ending .dxf or .svg";
                return Err(InputError::about_file(&name, "is no drawing that is read", cure));
            }
        };
        let (text, file) = read_input(path, "drawing")?;
        let lines = read(&name, &text)?;
        let mut left_out = lines.left_out;
        left_out.push((
            "smaller closed line".to_string(),
            lines.closed.len().saturating_sub(1),
        ));
        left_out.retain(|(_, count)| *count > 0);
        let largest = lines
            .closed
            .into_iter()
            .filter(|line| line.len() > 2)
            .max_by(|a, b| area(a).abs().total_cmp(&area(b).abs()));
        match largest {
            Some(outline_mm) if area(&outline_mm).abs() > 0.0 => Ok(Drawing {
                file,
                outline_mm,
                unit: lines.unit,
                left_out,
            }),
            _ => Err(InputError::about_file(
                &name,
                format!("holds no closed line{}", counted(" but ", &left_out)),
                "Draw the outline of the wing as one closed polyline or path, or as lines and arcs whose ends meet",
            )),
        }
    }
}

/// Kinds with their number, after `lead`; nothing where there are none.
pub fn counted(lead: &str, kinds: &[(String, usize)]) -> String {
    let each = kinds.iter().map(|(kind, count)| format!("{count} × {kind}"));
    match kinds.is_empty() {
        true => String::new(),
        false => format!("{lead}{}", each.collect::<Vec<_>>().join(", ")),
    }
}

/// Area of a closed line, positive where it runs counterclockwise.
fn area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let doubled = points.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]);
    0.5 * doubled.sum::<f64>()
}
