//! Torsional divergence of Goland's wing in strip theory.
//!
//! Goland, J. Appl. Mech. 12 (1945) A197-A208.
//!
//! ```text
//!   L = 6.096 m, c = 1.8288 m, elastic axis at 33 % of the chord, GJ = 0.987581e6, EI = 9.77e6 N·m², a = 2π, ρ = 1.225
//! ```
//!
//! A lifting surface gives a much higher speed: the aspect ratio is 6.7.

use crate::progress::Progress;
use crate::verify::strip_wing::StripWing;
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const PART: Quantity = Quantity {
    source: "closed form of strip theory",
    tolerance: 1e-3,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "goland-wing",
    title: "Divergence of Goland's wing, strip theory",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "divergence pressure",
            unit: "Pa",
            reference: || vec![39005.0],
            ..PART
        },
        Quantity {
            name: "divergence speed",
            unit: "m/s",
            reference: || vec![252.352],
            others: &[Other {
                value: "252.8",
                source: "literature",
                confidence: Confidence::Memory,
            }],
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let wing = StripWing {
        columns: level.times(8),
        length_m: 6.096,
        chord_m: 1.8288,
        gj_n_m2: 0.987_581e6,
        ei_n_m2: 9.77e6,
        shear_n: 1e8,
        rib_n_m2: 1e9,
        axis_m: 0.33 * 1.8288,
        q_pa: 20_000.0,
        ..StripWing::WORKED
    };
    let pressure = wing.found_divergence_pa(progress)?;
    let speed = (2.0 * pressure / wing.density_kg_m3).sqrt();
    Ok(Answer::new(
        format!("{} beams and strips", wing.columns),
        [pressure, speed],
    ))
}
