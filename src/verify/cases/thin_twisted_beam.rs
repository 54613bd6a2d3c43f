//! The twisted beam a hundred times thinner: warped, and so thin that any locking of bending by stretching shows.
//!
//! Belytschko et al. 1989; set-up as in `twisted_beam` with t = 0.0032 and a tip force of 1e-6.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::cantilever::middle_of_end;
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

use super::twisted_beam::twisted;

const PART: Quantity = Quantity {
    source: "Belytschko, Simo; in FinEtools and Ko 2017",
    confidence: Confidence::Seen,
    order: Order::Exempt("its references differ by 1.2 %"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "thin-twisted-beam",
    title: "Thin twisted beam (t/b = 0.003), pretwist 90°, tip force 1e-6",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip, force along the width",
            reference: || vec![5.256e-3],
            // as far apart as the references
            tolerance: 0.012,
            others: &[Other {
                value: "5.3162e-3",
                source: "linear rod theory",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
        Quantity {
            name: "tip, force along the thickness",
            reference: || vec![1.294e-3],
            tolerance: 0.005,
            others: &[Other {
                value: "1.2963e-3",
                source: "linear rod theory",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let grid = twisted([level.times(48), level.times(8)], 0.0032)?;
    let tips = [
        1e-6 * middle_of_end(&grid, Vector3::z())?,
        1e-6 * middle_of_end(&grid, Vector3::y())?,
    ];
    Ok(Answer::new(grid.words(), tips))
}
