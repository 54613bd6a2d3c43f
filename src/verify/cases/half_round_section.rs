//! The section of a half-round rod: torsion, bending and shear centre.
//!
//! ```text
//!    _-‾‾-_      radius R; J = (π/2 − 4/π) R⁴, 0.29756 R⁴ (the 0.296 of tables is 0.5 % low)
//!   |______|     shear centre 8/(5π) R from the flat (Trefftz; mean twist at ν = 0), 0.51137 R at ν = 0.3 (mean twist)
//! ```
//!
//! The 0.548 R of textbooks has the twist vanish on the diameter, which is another definition.

use std::f64::consts::PI;

use crate::progress::Progress;
use crate::structure::Section;
use crate::structure::section::BeamMaterial;
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const PART: Quantity = Quantity {
    source: "closed form",
    tolerance: 1e-6,
    order: Order::Exempt("no mesh"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "half-round-section",
    title: "Half-round rod: torsion, bending and shear centre of its section",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "torsion constant J",
            unit: "R⁴",
            reference: || vec![PI / 2.0 - 4.0 / PI],
            others: &[Other {
                value: "0.297532",
                source: "sectionproperties, finite elements",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
        Quantity {
            name: "second moment parallel to the flat",
            unit: "R⁴",
            reference: || vec![PI / 8.0 - 8.0 / (9.0 * PI)],
            ..PART
        },
        Quantity {
            name: "second moment across",
            unit: "R⁴",
            reference: || vec![PI / 8.0],
            ..PART
        },
        Quantity {
            name: "shear centre from the flat, ν = 0",
            unit: "R",
            reference: || vec![8.0 / (5.0 * PI)],
            others: &[Other {
                value: "0.509285",
                source: "sectionproperties, finite elements",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
        Quantity {
            name: "shear centre from the flat, ν = 0.3, zero mean twist",
            unit: "R",
            reference: || vec![0.511_366_2],
            tolerance: 0.005,
            others: &[Other {
                value: "0.548472, zero twist on the diameter",
                source: "Timoshenko",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
    ],
    short: Level::Coarse,
    run,
};

fn run(_: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let (e, g, radius) = (200e9, 80e9, 1e-3_f64);
    let material = BeamMaterial {
        e_pa: e,
        g_pa: g,
        density_kg_m3: 1.0,
    };
    let section = Section::half_round(radius, true, &material);
    let fourth = radius.powi(4);
    // a force along the flat, at the axis through the centroid, twists by its distance from the shear centre
    let offset = (section.compliance[(3, 1)] / section.compliance[(3, 3)]).abs();
    let centre = 4.0 / (3.0 * PI) + offset / radius;
    Ok(Answer::new(
        "no mesh",
        [
            section.gj_n_m2() / g / fourth,
            section.ei_flap_n_m2() / e / fourth,
            section.ei_edge_n_m2() / e / fourth,
            centre,
            centre,
        ],
    ))
}
