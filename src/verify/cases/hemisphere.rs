//! The pinched hemisphere without a hole, on triangles of an octant.
//!
//! ```text
//!      .z       R = 10, t = 0.04, E = 6.825e7, ν = 0.3; forces 2 out along ±x and in along ±y at the free equator
//!     /\/\      (a quarter is solved): n triangles along each of the three arcs
//!   x/\/\/\y
//! ```

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::{Loads, Model};
use crate::verify::answer::linear;
use crate::verify::grid::plate;
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "hemisphere",
    title: "Pinched hemisphere without a hole",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "displacement under the outward force",
        reference: || vec![0.0924],
        source: "Ko 2017",
        confidence: Confidence::Seen,
        tolerance: 0.01,
        order: Order::Exempt("point loads"),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let n = level.times(8);
    // rows of constant height: row j has n − j + 1 nodes, from the plane y = 0 to the plane x = 0
    let start = |j: usize| j * (n + 1) - j * j.saturating_sub(1) / 2;
    let index = |i: usize, j: usize| start(j) + i;
    let sine = |k: usize| (FRAC_PI_2 * k as f64 / n as f64).sin();
    let nodes = (0..=n).flat_map(|j| (0..=n - j).map(move |i| [n - i - j, i, j]));
    let nodes = nodes.map(|place| 10.0 * Vector3::from(place.map(sine)).normalize());
    let mut model = Model::new(nodes.collect());
    let sheet = model.add_sheet(plate(6.825e7, 0.3, 0.04));
    for j in 0..n {
        for i in 0..n - j {
            model.add_shell([index(i, j), index(i + 1, j), index(i, j + 1)], sheet)?;
            if i + 1 < n - j {
                model.add_shell([index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)], sheet)?;
            }
        }
    }
    for j in 0..=n {
        model.hold(index(0, j), [false, true, false, true, false, true]);
        model.hold(index(n - j, j), [true, false, false, false, true, true]);
    }
    let (out, inward) = (index(0, 0), index(n, 0));
    model.hold(out, [false, false, true, false, false, false]);
    let mut loads = Loads::none(model.nodes.len());
    loads.force_n[out].x = 1.0;
    loads.force_n[inward].y = -1.0;
    let moved = linear(&model, &loads)?[out][0].x;
    Ok(Answer::new(format!("{n} a side"), [moved]))
}
