//! Rods on the shelf, as a CSV table: what a leading edge can be made of.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::design::{Flat, Section};
use super::error::{InputError, Range};
use super::file;
use super::table::{Record, Table};
use crate::origin::InputFile;

/// A rod on the shelf.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StockRod {
    /// Its name.
    pub name: String,
    /// Its cross-section.
    pub section: Section,
    /// Name of its material, as in `[material.NAME]` of the design.
    pub material: String,
    /// How far its diameter may be off, mm.
    pub tolerance_mm: f64,
}

/// Shapes that a shelf holds.
#[derive(Clone, Copy)]
enum Shape {
    Round,
    HalfRound,
    Tube,
}

/// Reads a shelf with the columns `name`, `shape` (round, half-round, tube), `diameter_mm`, `material` and, if wanted,
/// `inner_diameter_mm` for tubes and `tolerance_mm` of the diameter (0.02 where none is given); with what the file is known by.
///
/// # Errors
/// If the file cannot be read, or a row is no rod.
pub fn load_stock(path: &Path) -> Result<(Vec<StockRod>, InputFile), InputError> {
    let (text, input) = file::read_input(path, "list of rods")?;
    Ok((stock_from_csv(&file::shown(path), &text)?, input))
}

/// Rods of a list: every two of them are a layout to try.
const MOST: usize = 1000;

/// The same from text.
///
/// # Errors
/// As [`load_stock`].
pub fn stock_from_csv(file: &str, text: &str) -> Result<Vec<StockRod>, InputError> {
    let table = Table::parse(
        file,
        text,
        &["name", "shape", "diameter_mm", "material"],
        &["inner_diameter_mm", "tolerance_mm"],
    )?;
    let mut rods: Vec<StockRod> = Vec::new();
    for record in &table.records {
        let rod = read(record)?;
        if rods.len() == MOST {
            let cure = "Leave out the rods that nobody would lay into this wing";
            return Err(record.conflict(
                "name",
                format!("is rod {} of at most {MOST}", MOST + 1),
                &[],
                cure,
            ));
        }
        if rods.iter().any(|known| known.name == rod.name) {
            let cure = "Give every rod a name of its own";
            return Err(record.conflict("name", "stands in a row before", &[], cure));
        }
        rods.push(rod);
    }
    Ok(rods)
}

fn read(record: &Record) -> Result<StockRod, InputError> {
    let name = record.text("name").to_string();
    if name.is_empty() {
        return Err(record.conflict("name", "is empty", &[], "Name the rod, e.g. half-1.0"));
    }
    let shapes = [
        ("round", Shape::Round),
        ("half-round", Shape::HalfRound),
        ("tube", Shape::Tube),
    ];
    let shape = record.word("shape", &shapes, "Say which cross-section it has")?;
    let diameter = record.number_in("diameter_mm", mm(0.001, 1000.0), "Give the outer diameter in mm")?;
    let section = read_section(record, shape, diameter)?;
    let tolerance_mm = match record.text("tolerance_mm") {
        "" => 0.02,
        _ => record.number_in(
            "tolerance_mm",
            mm(0.0, 0.5 * diameter),
            "Give how far the diameter may be off, mm",
        )?,
    };
    let material = record.text("material").to_string();
    if material.is_empty() {
        let cure = "Name a material of the design, e.g. carbon-rod";
        return Err(record.conflict("material", "is empty", &[], cure));
    }
    Ok(StockRod {
        name,
        section,
        material,
        tolerance_mm,
    })
}

fn read_section(record: &Record, shape: Shape, diameter: f64) -> Result<Section, InputError> {
    Ok(match shape {
        Shape::Round => Section::Round {
            diameter_mm: diameter.into(),
        },
        Shape::HalfRound => Section::HalfRound {
            diameter_mm: diameter.into(),
            flat: Flat::default(),
        },
        Shape::Tube => {
            let inner = record.number_in(
                "inner_diameter_mm",
                mm(0.0, 1000.0),
                "Give the inner diameter of the tube",
            )?;
            if inner >= diameter {
                let cure = "Give an inner diameter below the outer one";
                return Err(record.conflict("inner_diameter_mm", "leaves no wall", &["diameter_mm"], cure));
            }
            Section::Tube {
                outer_diameter_mm: diameter.into(),
                inner_diameter_mm: inner.into(),
            }
        }
    })
}

fn mm(low: f64, high: f64) -> Range {
    Range {
        low,
        high,
        open: false,
        unit: "mm",
    }
}

#[cfg(test)]
mod tests {
    use super::stock_from_csv;

    #[test]
    fn a_list_of_more_rods_than_can_be_tried_is_refused_with_the_line_of_the_first_too_many() {
        let rods = |count: usize| -> String {
            let rods = (0..count).map(|rod| format!("r{rod},round,1.0,carbon-rod\n"));
            "name,shape,diameter_mm,material\n".to_string() + &rods.collect::<String>()
        };
        assert_eq!(
            stock_from_csv("s.csv", &rods(super::MOST)).expect("rods").len(),
            super::MOST
        );
        let error = stock_from_csv("s.csv", &rods(80_000))
            .expect_err("too many")
            .to_string();
        assert!(
            error.contains("s.csv:1002") && error.contains("at most 1000"),
            "{error}"
        );
    }

    #[test]
    fn a_shelf_of_three_shapes_is_read_and_bad_rows_are_refused_with_their_line() {
        let head = "name,shape,diameter_mm,material,inner_diameter_mm,tolerance_mm\n";
        let good = format!(
            "{head}a,round,1.0,carbon-rod,,\nb,half-round,1.0,carbon-rod,,0.01\nc,tube,1.5,carbon-rod,1.0,\n"
        );
        let rods = stock_from_csv("s.csv", &good).expect("a shelf");
        assert_eq!(
            (rods.len(), rods[0].tolerance_mm, rods[1].tolerance_mm),
            (3, 0.02, 0.01)
        );
        for (row, said) in [
            ("a,square,1,carbon-rod,,", "shape"),
            ("a,round,-1,carbon-rod,,", "diameter_mm"),
            ("a,tube,1,carbon-rod,1.2,", "no wall"),
            (",round,1,carbon-rod,,", "name"),
            ("a,round,1,,,", "material"),
        ] {
            let error = stock_from_csv("s.csv", &format!("{head}{row}\n"))
                .expect_err(row)
                .to_string();
            assert!(error.starts_with("s.csv:2:") && error.contains(said), "{error}");
        }
    }
}
