//! Euler's column: a cantilever pressed along its axis.
//!
//! ```text
//!   |====================← P   P_cr = π² EI / (4 L²)
//! ```

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::buckling::critical_share;
use crate::verify::chain::{chain, section, straight};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "euler-column",
    title: "Euler's column, clamped and free",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "critical load",
        unit: "EI/L²",
        reference: || vec![PI * PI / 4.0],
        source: "Euler",
        tolerance: 1e-3,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let elements = level.times(12);
    let section = section([1e8, 1e8, 1e8, 1.0, 1.0, 3.0])?;
    let model = chain(straight(1.0, elements), &Vector3::z(), section)?;
    let mut unit = Loads::none(elements + 1);
    unit.force_n[elements].x = -1.0;
    let load = critical_share(&model, &unit, [1.2, 3.7], progress)?;
    Ok(Answer::new(format!("{elements} beams"), [load]))
}
