//! Natural frequencies of a uniform cantilever: bending, torsion, stretching.
//!
//! ```text
//!  |==========   bending ω = (βL)² √(EI/(m L⁴)) with cos βL cosh βL = −1; torsion ω = (2n − 1) π/2 √(GJ/(I_p L²)),
//!                stretching the same with EA/m
//! ```

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Section;
use crate::verify::answer::frequencies;
use crate::verify::chain::{chain, straight};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// βL.
const BENDING: [f64; 5] = [
    1.875_104_07,
    4.694_091_13,
    7.854_757_44,
    10.995_540_73,
    14.137_168_39,
];

const PART: Quantity = Quantity {
    source: "closed form",
    tolerance: 0.005,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "beam-frequencies",
    title: "Natural frequencies of a uniform cantilever beam",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "bending, modes 1 to 5",
            unit: "√(EI/(m L⁴))",
            reference: || BENDING.map(|beta| beta * beta).to_vec(),
            tolerance: 1e-3,
            order: Order::Theory(4.0),
            ..PART
        },
        Quantity {
            name: "torsion, modes 1 to 3",
            unit: "√(GJ/(I_p L²))",
            reference: quarter_waves,
            ..PART
        },
        Quantity {
            name: "stretching, modes 1 to 3",
            unit: "√(EA/(m L²))",
            reference: quarter_waves,
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn quarter_waves() -> Vec<f64> {
    [0.5, 1.5, 2.5].map(|n| n * PI).to_vec()
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let elements = level.times(8);
    let bending = [true, true, false, true, false, true];
    let torsion = [true, true, true, false, true, true];
    let stretching = [false, true, true, true, true, true];
    Ok(Answer::curves(
        format!("{elements} beams"),
        [
            angular(elements, bending, 5, progress)?,
            angular(elements, torsion, 3, progress)?,
            angular(elements, stretching, 3, progress)?,
        ],
    ))
}

/// Angular frequencies of a cantilever with all stiffnesses, masses and its length 1, moving as `held` lets it.
fn angular(
    elements: usize,
    held: [bool; 6],
    count: usize,
    progress: &Progress,
) -> Result<Vec<f64>, VerifyError> {
    let mut section = Section::uncoupled(1.0, 1.0, 1.0, 1.0);
    section.mass_kg_m = 1.0;
    section.inertia_kg_m = if held[3] { Vector3::zeros() } else { Vector3::x() };
    let mut model = chain(straight(1.0, elements), &Vector3::z(), section)?;
    for node in 1..=elements {
        model.hold(node, held);
    }
    let found = frequencies(&model, count, progress)?;
    Ok(found.into_iter().map(|frequency| TAU * frequency).collect())
}
