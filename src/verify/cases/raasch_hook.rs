//! Raasch's hook: a strip of two arcs, clamped at one end, sheared along the width of the other.
//!
//! Harder, MSC World Users' Conference 1991; Knight, AIAA J. 35 (1997) 1281-1284.
//!
//! ```text
//!   ⌒\      arcs R = 14 over 60° and R = 46 over 150°, width 20, t = 2, E = 3300
//!  |  \__/  clamped at the upper end; unit force along the width, spread over the free end
//! ```
//!
//! It bends, twists and shears at once, and shows where rotations about the normal are not carried on across edges.

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::cantilever::middle_of_end;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, VerifyError};

const PART: Quantity = Quantity {
    confidence: Confidence::Seen,
    tolerance: 0.02,
    order: Order::Exempt("curvature jumps between the arcs"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "raasch-hook",
    title: "Raasch's hook: strip of two arcs under shear along its width",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip along the width, ν = 0.35",
            reference: || vec![5.022_012_65],
            source: "refined 20-node solids, in FinEtools",
            ..PART
        },
        Quantity {
            name: "tip along the width, ν = 0.30",
            reference: || vec![4.824_82],
            source: "Ko 2017",
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(36), level.times(8)];
    let tips = [
        middle_of_end(&hook(count, 0.35)?, Vector3::y())?,
        middle_of_end(&hook(count, 0.30)?, Vector3::y())?,
    ];
    Ok(Answer::new(format!("{} × {}", count[0], count[1]), tips))
}

fn hook(count: [usize; 2], poisson: f64) -> Result<Grid, VerifyError> {
    let (first, second) = (14.0 * PI / 3.0, 46.0 * PI * 5.0 / 6.0);
    let grid = Grid::new(count, plate(3300.0, poisson, 2.0), |xi, eta| {
        let along = xi * (first + second);
        let place = if along <= first {
            // centre (14, 0, 0), from the wall at the origin upwards
            let angle = along / 14.0;
            Vector3::new(14.0 - 14.0 * angle.cos(), 0.0, 14.0 * angle.sin())
        } else {
            // the bend turns the other way about the common normal at 60°
            let (sine, cosine) = (PI / 3.0).sin_cos();
            let joint = Vector3::new(14.0 - 14.0 * cosine, 0.0, 14.0 * sine);
            let outward = Vector3::new(-cosine, 0.0, sine);
            let ahead = Vector3::new(sine, 0.0, cosine);
            let angle = (along - first) / 46.0;
            joint + 46.0 * (outward * (1.0 - angle.cos()) + ahead * angle.sin())
        };
        place + Vector3::new(0.0, 20.0 * eta, 0.0)
    })?;
    Ok(grid)
}
