//! A slit ring plate, one lip clamped and the other lifted, far beyond its width.
//!
//! Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, case 3.3; table as transcribed by the NGSolve notebooks.
//!
//! ```text
//!   ◯ cut at one side: one lip clamped, the other under 0.8 per length along z
//!     radii 6 and 10, h = 0.03, E = 21e6, ν = 0
//! ```

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::follow;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, Scale, VerifyError};

/// P/P_max, lift of the lip at the outer radius and at the inner.
const TABLE: [[f64; 3]; 23] = [
    [0.025, 1.789, 1.305],
    [0.05, 3.37, 2.455],
    [0.075, 4.72, 3.435],
    [0.1, 5.876, 4.277],
    [0.125, 6.872, 5.007],
    [0.15, 7.736, 5.649],
    [0.2, 9.16, 6.725],
    [0.25, 10.288, 7.602],
    [0.3, 11.213, 8.34],
    [0.35, 11.992, 8.974],
    [0.4, 12.661, 9.529],
    [0.45, 13.247, 10.023],
    [0.5, 13.768, 10.468],
    [0.55, 14.24, 10.876],
    [0.6, 14.674, 11.257],
    [0.65, 15.081, 11.62],
    [0.7, 15.469, 11.97],
    [0.75, 15.842, 12.31],
    [0.8, 16.202, 12.642],
    [0.85, 16.55, 12.966],
    [0.9, 16.886, 13.282],
    [0.95, 17.212, 13.59],
    [1.0, 17.528, 13.891],
];

const PART: Quantity = Quantity {
    source: "Sze, Liu & Lo 2004, 3.3; in NGSolve notebooks",
    confidence: Confidence::Seen,
    tolerance: 0.01,
    scale: Scale::Largest,
    order: Order::Exempt("singular ends of the clamped lip"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "sze-slit-ring",
    title: "Slit ring plate lifted at one lip",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "lift at the outer radius",
            reference: || TABLE.map(|row| row[1]).to_vec(),
            ..PART
        },
        Quantity {
            name: "lift at the inner radius",
            reference: || TABLE.map(|row| row[2]).to_vec(),
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(24), level.times(3)];
    let mut grid = Grid::new(count, plate(21e6, 0.0, 0.03), |xi, eta| {
        let (sine, cosine) = (TAU * xi).sin_cos();
        Vector3::new(cosine, sine, 0.0) * (6.0 + 4.0 * eta)
    })?;
    grid.hold(&grid.side(false), [true; 6]);
    let [inner, outer] = [0, count[1]].map(|j| grid.node([count[0], j]));
    // 0.8 per length over a lip of 4
    let full = grid.end_force(3.2 * Vector3::z());
    let shares = TABLE.map(|row| row[0]);
    let lifts = follow(&grid.model, &full, shares, progress, |state| {
        [outer, inner].map(|node| state.displacement[node].z)
    })?;
    let curve = |k: usize| lifts.iter().map(|lift| lift[k]).collect();
    Ok(Answer::curves(grid.words(), [curve(0), curve(1)]))
}
