//! Roll-up of a cantilever of beams by an end moment.
//!
//! ```text
//!  |                    ↷ M      φ = M L / EI; φ = 2π closes the circle
//!  |====================         tip: u = L (sin φ / φ − 1), w = L (1 − cos φ) / φ
//! ```

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::{Loads, Section};
use crate::verify::answer::follow;
use crate::verify::chain::{chain, straight};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, Scale, VerifyError};

/// Turns of the tip.
const TURNS: [f64; 6] = [0.25, 0.5, 0.75, 1.0, 1.5, 2.0];

const PART: Quantity = Quantity {
    source: "circle",
    tolerance: 1e-3,
    scale: Scale::Largest,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "roll-up",
    title: "Roll-up: cantilever bent to one and two full circles by an end moment",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip along, u/L",
            reference: || TURNS.map(|turns| circle(turns)[0]).to_vec(),
            ..PART
        },
        Quantity {
            name: "tip across, w/L",
            reference: || TURNS.map(|turns| circle(turns)[1]).to_vec(),
            ..PART
        },
        Quantity {
            name: "rotation of the tip, turns",
            reference: || TURNS[..2].to_vec(),
            order: Order::Exempt("exact for any mesh"),
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

/// Tip displacement over the length, along and across.
fn circle(turns: f64) -> [f64; 2] {
    let phi = turns * TAU;
    [phi.sin() / phi - 1.0, (1.0 - phi.cos()) / phi]
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (length, bending, elements) = (10.0, 100.0, level.times(16));
    let section = Section::uncoupled(1e6, 80.0, bending, bending);
    let model = chain(straight(length, elements), &Vector3::z(), section)?;
    let mut full = Loads::none(elements + 1);
    full.moment_n_m[elements].y = -TURNS[5] * TAU * bending / length;
    let shares = TURNS.map(|turns| turns / TURNS[5]);
    let tips = follow(&model, &full, shares, progress, |state| {
        let tip = state.displacement[elements] / length;
        [tip.x, tip.z, state.rotation[elements].angle() / TAU]
    })?;
    let curve = |k: usize| tips.iter().map(|tip| tip[k]).collect::<Vec<f64>>();
    Ok(Answer::curves(
        format!("{elements} beams"),
        [curve(0), curve(1), curve(2)[..2].to_vec()],
    ))
}
