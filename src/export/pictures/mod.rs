//! Results as pictures: what is drawn against what, with which mark; the drawing itself is done by `plot`.

pub mod compared;

pub mod diagnosis;

pub mod in_sigma;

pub mod ladder;

pub mod panels;

pub mod residuals;

pub mod tables;

pub mod wing;

use crate::input::measurement::Channel;
use crate::plot::Figure;

use super::ExportError;
use super::run::RunFolder;

/// Charts of one picture; more go into another.
const PANELS: usize = 12;

/// Adds a picture to a folder: `NAME.svg`, and `NAME-2.svg` and so on where it has too many panels for one.
pub fn add_picture(folder: &mut RunFolder, name: &str, figure: &Figure) -> Result<(), ExportError> {
    for (index, panels) in figure.panels.chunks(PANELS).enumerate() {
        let page = Figure {
            panels: panels.to_vec(),
            ..figure.clone()
        };
        let name = match index {
            0 => format!("{name}.svg"),
            _ => format!("{name}-{}.svg", index + 1),
        };
        folder.add(&name, page.to_svg()?.as_bytes())?;
    }
    Ok(())
}

/// A channel in words.
fn words(channel: Channel) -> String {
    channel.name().replace('_', " ")
}

/// A quantity with its unit, as axes have it.
fn with_unit(name: &str, unit: &str) -> String {
    match unit {
        "" | "1" => name.to_string(),
        unit => format!("{name} ({unit})"),
    }
}

/// A number as short as it can be read: at most four digits, no zeros behind.
fn plain(value: f64) -> String {
    let text = crate::plot::scale::short(value, 4);
    match text.split_once('.') {
        Some((_, rest)) if rest.chars().all(|c| c.is_ascii_digit()) => {
            text.trim_end_matches('0').trim_end_matches('.').to_string()
        }
        _ => text,
    }
}
