//! Hemisphere with a hole of 18° at its pole, pulled and pushed by two pairs of forces at its free equator.
//!
//! MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
//!
//! ```text
//!    _/ \_     R = 10, t = 0.04, E = 6.825e7, ν = 0.3; forces 2 out along ±x and in along ±y (a quarter is solved)
//!  ←(     )→   value: displacement under the forces; nearly all of it bends without stretching
//! ```

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "hemisphere-with-hole",
    title: "Pinched hemisphere with a hole of 18°",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "displacement under the outward force",
        reference: || vec![0.0930],
        source: "Simo et al.; in FinEtools and Ko 2017",
        confidence: Confidence::Seen,
        tolerance: 0.01,
        order: Order::Exempt("point loads"),
        others: &[Other {
            value: "0.0940",
            source: "MacNeal & Harder 1985",
            confidence: Confidence::Memory,
        }],
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(8), level.times(8)];
    let mut grid = Grid::new(count, plate(6.825e7, 0.3, 0.04), |xi, eta| {
        let (high, round) = (72.0_f64.to_radians() * xi, FRAC_PI_2 * eta);
        10.0 * Vector3::new(high.cos() * round.cos(), high.cos() * round.sin(), high.sin())
    })?;
    grid.hold(&grid.edge(false), [false, true, false, true, false, true]);
    grid.hold(&grid.edge(true), [true, false, false, false, true, true]);
    let (out, inward) = (grid.node([0, 0]), grid.node([0, count[1]]));
    grid.model.hold(out, [false, false, true, false, false, false]);
    let mut loads = Loads::none(grid.model.nodes.len());
    loads.force_n[out].x = 1.0;
    loads.force_n[inward].y = -1.0;
    let moved = linear(&grid.model, &loads)?[out][0].x;
    Ok(Answer::new(grid.words(), [moved]))
}
