//! Cantilever under end shear, large deflection.
//!
//! Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, case 3.1; table as transcribed by the test suites of Elmer
//! and NGSolve.
//!
//! ```text
//!  |=========↑ P   L = 10, b = 1, h = 0.1, E = 1.2e6, ν = 0; P up to 4, keeps its direction
//! ```
//!
//! A shear-flexible rod gives W = 6.70013 and U = −3.28951 at the end: the table is 0.03 % and 0.1 % low there.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::follow;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, Scale, VerifyError};

/// P/4, −U and W of the tip.
const TABLE: [[f64; 3]; 20] = [
    [0.05, 0.026, 0.663],
    [0.1, 0.103, 1.309],
    [0.15, 0.224, 1.922],
    [0.2, 0.381, 2.493],
    [0.25, 0.563, 3.015],
    [0.3, 0.763, 3.488],
    [0.35, 0.971, 3.912],
    [0.4, 1.184, 4.292],
    [0.45, 1.396, 4.631],
    [0.5, 1.604, 4.933],
    [0.55, 1.807, 5.202],
    [0.6, 2.002, 5.444],
    [0.65, 2.19, 5.66],
    [0.7, 2.37, 5.855],
    [0.75, 2.541, 6.031],
    [0.8, 2.705, 6.19],
    [0.85, 2.861, 6.335],
    [0.9, 3.01, 6.467],
    [0.95, 3.151, 6.588],
    [1.0, 3.286, 6.698],
];

const PART: Quantity = Quantity {
    source: "Sze, Liu & Lo 2004, 3.1; in Elmer and NGSolve",
    confidence: Confidence::Seen,
    tolerance: 0.002,
    scale: Scale::Largest,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "sze-end-shear",
    title: "Plate cantilever under end shear, large deflection",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip across, W",
            reference: || TABLE.map(|row| row[2]).to_vec(),
            others: &[Other {
                value: "6.70013 at P = 4",
                source: "shear-flexible rod",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
        Quantity {
            name: "tip along, -U",
            reference: || TABLE.map(|row| row[1]).to_vec(),
            others: &[Other {
                value: "3.28951 at P = 4",
                source: "shear-flexible rod",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(16), level.times(2)];
    let mut grid = Grid::new(count, plate(1.2e6, 0.0, 0.1), |xi, eta| {
        Vector3::new(10.0 * xi, eta - 0.5, 0.0)
    })?;
    grid.hold(&grid.side(false), [true; 6]);
    let tip = grid.node([count[0], count[1] / 2]);
    let full = grid.end_force(4.0 * Vector3::z());
    let shares = TABLE.map(|row| row[0]);
    let tips = follow(&grid.model, &full, shares, progress, |state| {
        state.displacement[tip]
    })?;
    Ok(Answer::curves(
        grid.words(),
        [
            tips.iter().map(|tip| tip.z).collect(),
            tips.iter().map(|tip| -tip.x).collect(),
        ],
    ))
}
