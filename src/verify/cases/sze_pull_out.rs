//! A cylinder with open ends, pulled apart in the middle: it bends first, then stretches.
//!
//! Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, case 3.5; table of the loaded point as transcribed in MIGFEM,
//! set-up confirmed by Kratos.
//!
//! ```text
//!  P ← ( ) → P   R = 4.953, L = 10.35, h = 0.094, E = 10.5e6, ν = 0.3125; P up to 40000 (an eighth is solved)
//! ```
//!
//! Their point B at the full load (4.551) is from memory; of point C not even the place is sure.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::follow;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, Scale, VerifyError};

/// P/P_max and the displacement under the force.
const TABLE: [[f64; 2]; 23] = [
    [0.025, 0.819],
    [0.05, 1.26],
    [0.075, 1.527],
    [0.1, 1.707],
    [0.15, 1.936],
    [0.2, 2.079],
    [0.25, 2.18],
    [0.3, 2.257],
    [0.35, 2.321],
    [0.4, 2.376],
    [0.45, 2.425],
    [0.5, 2.473],
    [0.525, 2.543],
    [0.55, 2.577],
    [0.6, 2.618],
    [0.65, 2.648],
    [0.7, 2.672],
    [0.75, 2.692],
    [0.8, 2.71],
    [0.85, 2.726],
    [0.9, 2.741],
    [0.95, 2.755],
    [1.0, 2.768],
];

const PART: Quantity = Quantity {
    source: "Sze, Liu & Lo 2004, 3.5; in MIGFEM",
    confidence: Confidence::Seen,
    tolerance: 0.02,
    scale: Scale::Largest,
    order: Order::Exempt("point loads"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "sze-pull-out",
    title: "Open cylinder pulled apart by two forces",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "displacement under the force, A",
            reference: || TABLE.map(|row| row[1]).to_vec(),
            ..PART
        },
        Quantity {
            name: "inward displacement of B at the full load",
            reference: || vec![4.551],
            source: "Sze, Liu & Lo 2004, 3.5",
            confidence: Confidence::Memory,
            ..PART
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(8), level.times(12)];
    let mut grid = Grid::new(count, plate(10.5e6, 0.3125, 0.094), |xi, eta| {
        let (sine, cosine) = (FRAC_PI_2 * eta).sin_cos();
        Vector3::new(4.953 * sine, 5.175 * xi, 4.953 * cosine)
    })?;
    // middle of the length, planes of symmetry
    grid.hold(&grid.side(false), [false, true, false, true, false, true]);
    grid.hold(&grid.edge(false), [true, false, false, false, true, true]);
    grid.hold(&grid.edge(true), [false, false, true, true, true, false]);
    // B: a quarter turn from the force, in the middle of the length
    let [pulled, b] = [[0, 0], [0, count[1]]].map(|place| grid.node(place));
    let mut full = Loads::none(grid.model.nodes.len());
    full.force_n[pulled].z = 10_000.0;
    let shares = TABLE.map(|row| row[0]);
    let moved = follow(&grid.model, &full, shares, progress, |state| {
        let at = |node: usize| &state.displacement[node];
        [at(pulled).z, -at(b).x]
    })?;
    let last = moved.last().copied().unwrap_or_default();
    let curve = moved.iter().map(|moved| moved[0]).collect();
    Ok(Answer::curves(grid.words(), [curve, vec![last[1]]]))
}
