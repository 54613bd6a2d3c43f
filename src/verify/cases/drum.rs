//! A taut square film as a drum: f = √(m² + n²)/(2a) √(N/(ρ t)).

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Sheet;
use crate::verify::answer::frequencies;
use crate::verify::grid::{Grid, film, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "drum",
    title: "Natural frequencies of a taut square film",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "modes 1 to 4",
        unit: "√(N/(ρ t))/(2a)",
        reference: || [2.0_f64, 5.0, 5.0, 8.0].map(f64::sqrt).to_vec(),
        source: "closed form",
        tolerance: 0.01,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (cells, side) = (level.times(8), 0.02);
    let taut = Sheet {
        density_kg_m3: 1420.0,
        pretension_n_per_m: 20.0,
        ..plate(2.5e9, 0.34, 6e-6)
    };
    let mut grid = Grid::new([cells, cells], film(taut, 1e-4), |xi, eta| {
        side * Vector3::new(xi, eta, 0.0)
    })?;
    grid.hold(&grid.rim(), [true, true, true, false, false, false]);
    let unit = (taut.pretension_n_per_m / (taut.density_kg_m3 * taut.thickness_m)).sqrt() / (2.0 * side);
    let found = frequencies(&grid.model, 4, progress)?;
    let found = found.into_iter().map(|frequency| frequency / unit).collect();
    Ok(Answer::curves(grid.words(), [found]))
}
