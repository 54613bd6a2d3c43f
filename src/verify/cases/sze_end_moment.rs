//! Plate cantilever rolled up to a full circle by an end moment.
//!
//! Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, case 3.2; table as transcribed by the test suite of Elmer. It
//! agrees with the closed form u = L (sin φ/φ − 1), w = L (1 − cos φ)/φ, φ = M L/EI, to its last digit.
//!
//! ```text
//!  |=========) M   L = 12, b = 1, h = 0.1, E = 1.2e6, ν = 0; full circle at M = 50π/3
//! ```

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::follow;
use crate::verify::grid::{Grid, line_shares, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, Scale, VerifyError};

const LENGTH: f64 = 12.0;

/// M/M_max, −U and W of the tip.
const TABLE: [[f64; 3]; 20] = [
    [0.05, 0.196, 1.87],
    [0.1, 0.774, 3.648],
    [0.15, 1.699, 5.248],
    [0.2, 2.918, 6.598],
    [0.25, 4.361, 7.639],
    [0.3, 5.945, 8.333],
    [0.35, 7.585, 8.664],
    [0.4, 9.194, 8.637],
    [0.45, 10.688, 8.281],
    [0.5, 12.0, 7.639],
    [0.55, 13.073, 6.775],
    [0.6, 13.871, 5.758],
    [0.65, 14.377, 4.665],
    [0.7, 14.595, 3.571],
    [0.75, 14.546, 2.546],
    [0.8, 14.27, 1.65],
    [0.85, 13.818, 0.926],
    [0.9, 13.247, 0.405],
    [0.95, 12.621, 0.098],
    [1.0, 12.0, 0.0],
];

const PART: Quantity = Quantity {
    source: "Sze, Liu & Lo 2004, 3.2; in Elmer",
    confidence: Confidence::Seen,
    tolerance: 0.002,
    scale: Scale::Largest,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

const CIRCLE: Quantity = Quantity {
    source: "circle",
    confidence: Confidence::Derived,
    ..PART
};

/// The case.
pub const CASE: Case = Case {
    name: "sze-end-moment",
    title: "Plate strip rolled up to a full circle by an end moment",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip across, W",
            reference: || TABLE.map(|row| row[2]).to_vec(),
            ..PART
        },
        Quantity {
            name: "tip along, -U",
            reference: || TABLE.map(|row| row[1]).to_vec(),
            ..PART
        },
        Quantity {
            name: "tip across, against the circle",
            reference: || TABLE.map(|row| circle(row[0])[1]).to_vec(),
            ..CIRCLE
        },
        Quantity {
            name: "tip along, against the circle",
            reference: || TABLE.map(|row| circle(row[0])[0]).to_vec(),
            ..CIRCLE
        },
    ],
    short: Level::Middle,
    run,
};

/// Tip displacement (−along, across) after a share of a full turn.
fn circle(share: f64) -> [f64; 2] {
    let phi = share * TAU;
    [LENGTH * (1.0 - phi.sin() / phi), LENGTH * (1.0 - phi.cos()) / phi]
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(24), 2];
    let mut grid = Grid::new(count, plate(1.2e6, 0.0, 0.1), |xi, eta| {
        Vector3::new(LENGTH * xi, eta - 0.5, 0.0)
    })?;
    grid.hold(&grid.side(false), [true; 6]);
    let end = grid.side(true);
    let mut full = Loads::none(grid.model.nodes.len());
    for (&node, share) in end.iter().zip(line_shares(&grid.model, &end)) {
        full.moment_n_m[node].y = -TAU * 100.0 / LENGTH * share;
    }
    let shares = TABLE.map(|row| row[0]);
    let tips = follow(&grid.model, &full, shares, progress, |state| {
        state.displacement[end[1]]
    })?;
    let across: Vec<f64> = tips.iter().map(|tip| tip.z).collect();
    let along: Vec<f64> = tips.iter().map(|tip| -tip.x).collect();
    Ok(Answer::curves(
        grid.words(),
        [across.clone(), along.clone(), across, along],
    ))
}
