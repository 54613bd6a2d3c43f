//! MacNeal & Harder's curved beam: a quarter ring as a plate, clamped at one end, unit force at the other.
//!
//! MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
//!
//! ```text
//!  |‾‾-_     radii 4.12 and 4.32, t = 0.1, 90°, E = 1e7, ν = 0.25
//!       \
//!        | → unit force in the plane, or across it
//! ```
//!
//! In the plane: Timoshenko & Goodier, π (a² + b²) P/(E t N); the 0.08734 of 1985 is 1.4 % too low. Across: refined
//! solids; twice as wide as thick it twists by the shear along its edges (without it: 0.4544), and needs sides below the
//! thickness.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::cantilever::middle_of_end;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "curved-beam",
    title: "Curved beam: quarter ring as a plate, unit tip force",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip, force in the plane",
            reference: || vec![0.088_565_54],
            source: "elasticity (Timoshenko & Goodier)",
            tolerance: 0.01,
            order: Order::Exempt("singular corners at the clamp"),
            others: &[
                Other {
                    value: "0.08734",
                    source: "MacNeal & Harder 1985, in FAESOR",
                    confidence: Confidence::Seen,
                },
                Other {
                    value: "0.0885194",
                    source: "refined solids, in FAESOR",
                    confidence: Confidence::Seen,
                },
            ],
            ..Quantity::BLANK
        },
        Quantity {
            name: "tip, force across the plane",
            reference: || vec![0.498_301_64],
            source: "refined solids, in FAESOR",
            confidence: Confidence::Seen,
            tolerance: 0.01,
            order: Order::Exempt("singular corners at the clamp"),
            others: &[
                Other {
                    value: "0.5022",
                    source: "MacNeal & Harder 1985, in FAESOR",
                    confidence: Confidence::Seen,
                },
                Other {
                    value: "0.5005621",
                    source: "curved rod",
                    confidence: Confidence::Derived,
                },
            ],
            ..Quantity::BLANK
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(48), level.times(4)];
    let grid = Grid::new(count, plate(1e7, 0.25, 0.1), |xi, eta| {
        let (sine, cosine) = (FRAC_PI_2 * xi).sin_cos();
        Vector3::new(sine, cosine, 0.0) * (4.12 + 0.2 * eta)
    })?;
    let tips = [
        middle_of_end(&grid, Vector3::x())?,
        middle_of_end(&grid, Vector3::z())?,
    ];
    Ok(Answer::new(grid.words(), tips))
}
