//! Cook's membrane: a tapered panel in plane stress, sheared at its free end.
//!
//! Cook, J. Struct. Div. ASCE 100 (1974) 1851-1863.
//!
//! ```text
//!            __ (48, 60)   E = 1, ν = 1/3, t = 1; unit shear spread over the end x = 48
//!         _/   ↑           value: v at (48, 52)
//!  (0,44)/     | (48, 44)
//!  |clamp|   /
//!  (0, 0)|_/
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "cook-membrane",
    title: "Cook's membrane: tapered panel in plane stress, sheared at its free end",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "deflection of the middle of the free end",
        reference: || vec![23.9677],
        source: "quadratic elements, 8 to 128 a side, extrapolated; set-up of Cook 1974",
        tolerance: 0.01,
        order: Order::Exempt("singular corner at the wall"),
        others: &[Other {
            value: "23.97",
            source: "FinEtools",
            confidence: Confidence::Seen,
        }],
        ..Quantity::BLANK
    }],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    Ok(Answer::new(format!("{cells} × {cells}"), [deflection(cells)?]))
}

/// Deflection at (48, 52); cells are cut along their shorter diagonal, rotations free at the wall.
///
/// # Errors
/// If the structure cannot be solved.
pub fn deflection(cells: usize) -> Result<f64, VerifyError> {
    let place = |xi: f64, eta: f64| {
        let (low, high) = (44.0 * xi, 44.0 + 16.0 * xi);
        Vector3::new(48.0 * xi, low + (high - low) * eta, 0.0)
    };
    let mut grid = Grid::cut([cells, cells], plate(1.0, 1.0 / 3.0, 1.0), place, |_, _| false)?;
    let all: Vec<usize> = (0..grid.model.nodes.len()).collect();
    grid.hold(&all, [false, false, true, true, true, false]);
    grid.hold(&grid.side(false), [true, true, true, true, true, false]);
    let loads = grid.end_force(Vector3::y());
    Ok(linear(&grid.model, &loads)?[grid.node([cells, cells / 2])][0].y)
}
