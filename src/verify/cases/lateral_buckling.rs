//! A strip cantilever tips over sideways under its tip load.
//!
//! Timoshenko & Gere, Theory of Elastic Stability, 2nd ed. (1961), §6.3.
//!
//! ```text
//!   |====================   P_cr = 4.012599 √(EI_minor GJ) / L² at the centroid, EI_major ≫ EI_minor
//!   |                  ↓ P         (4.012599: root with the Bessel function J₋₁⸝₄)
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::buckling::critical_load;
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "lateral-buckling",
    title: "Lateral-torsional buckling of a strip cantilever under a tip load",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "critical load",
        unit: "√(EI GJ)/L²",
        reference: || vec![4.012_599],
        source: "Bessel function (Timoshenko & Gere 1961)",
        tolerance: 2e-3,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (elements, minor, torsion) = (level.times(12), 1.0, 0.7_f64);
    let unit = (minor * torsion).sqrt();
    let load = critical_load(
        elements,
        [1e8, 1e8, 1e8, torsion, minor, 1e5],
        -Vector3::y(),
        [2.0 * unit, 6.0 * unit],
        progress,
    )?;
    Ok(Answer::new(format!("{elements} beams"), [load / unit]))
}
