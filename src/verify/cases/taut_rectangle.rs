//! A taut rectangular film under even pressure, small deflection: Poisson's equation.
//!
//! ```text
//!   a ┌────────────┐   w_c = c p a²/N at the centre, a the short side; c by the double sine series
//!     │ N, p       │
//!     └────────────┘ b
//! ```
//!
//! One solve with the tangent at rest.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Sheet;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, film, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// b/a, c.
const TABLE: [[f64; 2]; 5] = [
    [1.0, 0.073_671_35],
    [1.5, 0.100_771_38],
    [2.0, 0.113_871_83],
    [3.0, 0.122_682_39],
    [5.0, 0.124_899_84],
];

/// The case.
pub const CASE: Case = Case {
    name: "taut-rectangle",
    title: "Taut rectangular film under even pressure, b/a = 1 to 5",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "deflection of the centre",
        unit: "p a²/N",
        reference: || TABLE.map(|row| row[1]).to_vec(),
        source: "double sine series",
        tolerance: 0.005,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let (across, short) = (level.times(8), 0.02);
    let taut = Sheet {
        pretension_n_per_m: 100.0,
        ..plate(2.5e9, 0.34, 6e-6)
    };
    let mut found = Vec::new();
    for [ratio, _] in TABLE {
        let count = [(ratio * across as f64).round() as usize, across];
        let mut grid = Grid::new(count, film(taut, 1e-4), |xi, eta| {
            short * Vector3::new(ratio * xi, eta, 0.0)
        })?;
        grid.hold(&grid.rim(), [true, true, true, false, false, false]);
        let moved = linear(&grid.model, &grid.pressure(Vector3::z()))?;
        found.push(moved[grid.centre()][0].z * taut.pretension_n_per_m / (short * short));
    }
    Ok(Answer::curves(format!("{across} across"), [found]))
}
