//! Beams that are tall and thin tip over sideways under loads in their stiff plane.
//!
//! Timoshenko & Gere, Theory of Elastic Stability, 2nd ed. (1961), §6.2-6.4.
//!
//! ```text
//!   |====================   cantilever, P at the tip: 4.012599 (root with the Bessel function J₋₁⸝₄); even load q L: 12.85
//!   |                  ↓ P
//!   △====================△  ends that may not tip over: moment at both ends π; P in the middle 16.94
//! ```
//!
//! Loads at the centroid in √(EI_minor GJ)/L² (moments: /L), EI_major ≫ EI_minor.

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::{Loads, Model};
use crate::verify::buckling::critical_share;
use crate::verify::chain::{chain, section, straight};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, VerifyError};

const MINOR: f64 = 1.0;
const TORSION: f64 = 0.7;

const PART: Quantity = Quantity {
    unit: "√(EI GJ)/L²",
    tolerance: 2e-3,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

const UNSURE: Quantity = Quantity {
    source: "Timoshenko & Gere 1961",
    confidence: Confidence::Memory,
    ..PART
};

/// The case.
pub const CASE: Case = Case {
    name: "lateral-buckling",
    title: "Lateral-torsional buckling of strips",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "cantilever, force at the tip",
            reference: || vec![4.012_599],
            source: "Bessel function (Timoshenko & Gere 1961)",
            ..PART
        },
        Quantity {
            name: "supported ends, end moments",
            unit: "√(EI GJ)/L",
            reference: || vec![PI],
            source: "closed form",
            ..PART
        },
        Quantity {
            name: "cantilever, even load",
            reference: || vec![12.85],
            ..UNSURE
        },
        Quantity {
            name: "supported ends, force in the middle",
            reference: || vec![16.94],
            ..UNSURE
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let elements = level.times(12);
    let section = section([1e8, 1e8, 1e8, TORSION, MINOR, 1e5])?;
    let cantilever = chain(straight(1.0, elements), &Vector3::z(), section)?;
    let mut supported = cantilever.clone();
    supported.held[0] = [true, true, true, true, false, false];
    supported.hold(elements, [false, true, true, true, false, false]);
    let unit = (MINOR * TORSION).sqrt();
    let none = Loads::none(elements + 1);
    let find = |model: &Model, guess: f64, load: &dyn Fn(&mut Loads)| {
        let mut loads = none.clone();
        load(&mut loads);
        let range = [0.6 * guess * unit, 1.5 * guess * unit];
        Ok::<f64, VerifyError>(critical_share(model, &loads, range, progress)? / unit)
    };
    let tip = find(&cantilever, 4.0, &|loads| loads.force_n[elements].y = -1.0)?;
    let moments = find(&supported, PI, &|loads| {
        loads.moment_n_m[0].z = -1.0;
        loads.moment_n_m[elements].z = 1.0;
    })?;
    let even = find(&cantilever, 12.8, &|loads| {
        for (node, force) in loads.force_n.iter_mut().enumerate() {
            let share = if node == 0 || node == elements { 0.5 } else { 1.0 };
            force.y = -share / elements as f64;
        }
    })?;
    let middle = find(&supported, 17.0, &|loads| loads.force_n[elements / 2].y = -1.0)?;
    Ok(Answer::new(
        format!("{elements} beams"),
        [tip, moments, even, middle],
    ))
}
