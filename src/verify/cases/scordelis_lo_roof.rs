//! Scordelis-Lo roof: 80° of a cylinder on two diaphragms, under its own weight.
//!
//! Scordelis & Lo, J. ACI 61 (1964) 539-561; MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
//!
//! ```text
//!    _-^-_   R = 25, L = 50, t = 0.25, half angle 40°, E = 4.32e8, ν = 0, weight 90 per area
//!   /     \  value: fall of the middle of the free edge; a quarter is solved
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "scordelis-lo-roof",
    title: "Scordelis-Lo roof: cylinder on diaphragms under its own weight",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "fall of the middle of the free edge",
        reference: || vec![0.3024],
        source: "MacNeal & Harder 1985, as transcribed by Ko 2017",
        confidence: Confidence::Seen,
        tolerance: 0.006,
        order: Order::Theory(2.0),
        others: &[
            Other {
                value: "0.30202",
                source: "Krysl & Chen, in FinEtools",
                confidence: Confidence::Seen,
            },
            Other {
                value: "0.3006 (deep shell), 0.3086 (Scordelis & Lo)",
                source: "literature",
                confidence: Confidence::Memory,
            },
        ],
        ..Quantity::BLANK
    }],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    let mut grid = Grid::new([cells, cells], plate(4.32e8, 0.0, 0.25), |xi, eta| {
        let (sine, cosine) = (40.0_f64.to_radians() * eta).sin_cos();
        Vector3::new(25.0 * sine, 25.0 * xi, 25.0 * cosine)
    })?;
    // diaphragm, middle of the length, crown
    grid.hold(&grid.side(false), [true, false, true, false, true, false]);
    grid.hold(&grid.side(true), [false, true, false, true, false, true]);
    grid.hold(&grid.edge(false), [true, false, false, false, true, true]);
    let loads = grid.pressure(Vector3::new(0.0, 0.0, -90.0));
    let fall = -linear(&grid.model, &loads)?[grid.node([cells, cells])][0].z;
    Ok(Answer::new(grid.words(), [fall]))
}
