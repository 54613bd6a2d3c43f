//! Natural frequencies of a simply supported square plate: ω = π² (m² + n²)/a² √(D/(ρ t)), Navier.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::frequencies;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "supported-plate-frequencies",
    title: "Natural frequencies of a simply supported square plate",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "modes 1 to 4",
        unit: "√(D/(ρ t a⁴))",
        reference: || [2.0, 5.0, 5.0, 8.0].map(|s| PI * PI * s).to_vec(),
        source: "Navier",
        tolerance: 0.01,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (cells, side) = (level.times(8), 0.4);
    let sheet = plate(70e9, 0.3, 1e-3);
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| side * Vector3::new(xi, eta, 0.0))?;
    grid.hold(&grid.rim(), [true, true, true, false, false, true]);
    let bending = sheet.e_pa * sheet.thickness_m.powi(3) / (12.0 * (1.0 - sheet.poisson.powi(2)));
    let unit = (bending / (sheet.density_kg_m3 * sheet.thickness_m)).sqrt() / (side * side);
    let found = frequencies(&grid.model, 4, progress)?;
    let found = found
        .into_iter()
        .map(|frequency| TAU * frequency / unit)
        .collect();
    Ok(Answer::curves(grid.words(), [found]))
}
