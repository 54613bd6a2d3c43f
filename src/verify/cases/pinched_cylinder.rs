//! A cylinder on rigid diaphragms, pinched by two opposite forces in the middle of its length.
//!
//! MacNeal & Harder 1985; Lindberg, Olson & Cowper 1969.
//!
//! ```text
//!       ↓        R = 300, L = 600, t = 3, E = 3e6, ν = 0.3; forces 1 (an eighth is solved)
//!  (========)    value: deflection under a force, 164.24 P/(E t)
//!       ↑
//! ```
//!
//! The reference is that of a thin shell. In one that yields to shear the place under a point force goes down without
//! end as the mesh gets finer, here by 0.2 % for every halving: 20 cells a side are fine enough for the rest (1.0 % above
//! the reference on 24, 1.1 % on 32, 1.2 % on 64; 0.3 % on 64 without shear).

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "pinched-cylinder",
    title: "Pinched cylinder with diaphragms",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "deflection under the force",
        reference: || vec![1.824_88e-5],
        source: "in FinEtools, the OpenSees gallery and Ko 2017",
        confidence: Confidence::Seen,
        tolerance: 0.01,
        order: Order::Exempt("point loads"),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(5), level.times(5)];
    let mut grid = Grid::new(count, plate(3e6, 0.3, 3.0), |xi, eta| {
        let (sine, cosine) = (FRAC_PI_2 * eta).sin_cos();
        Vector3::new(300.0 * cosine, 300.0 * xi, 300.0 * sine)
    })?;
    // middle of the length, diaphragm, planes of symmetry
    grid.hold(&grid.side(false), [false, true, false, true, false, true]);
    grid.hold(&grid.side(true), [true, false, true, false, true, false]);
    grid.hold(&grid.edge(false), [false, false, true, true, true, false]);
    grid.hold(&grid.edge(true), [true, false, false, false, true, true]);
    let loaded = grid.node([0, count[1]]);
    let mut loads = Loads::none(grid.model.nodes.len());
    loads.force_n[loaded].z = -0.25;
    let moved = -linear(&grid.model, &loads)?[loaded][0].z;
    Ok(Answer::new(grid.words(), [moved]))
}
