//! The 45° bend: a curved cantilever in space under a tip force across its plane.
//!
//! Bathe & Bolourchi, Int. J. Numer. Methods Eng. 14 (1979) 961-986.
//!
//! ```text
//!   y                      * tip (70.711, 29.289, 0), dead force P = 600 along z
//!   |                 .
//!   |          .            arc of 45°, R = 100, section 1 × 1
//!   +----.-------------- x  E = 1e7, G = 5e6
//!  clamp
//! ```
//!
//! Own solution of the rod equations by shooting (to 1e-11) with EA = 1e7, GA = 5/6 · 5e6, EI = 1e7/12, and with the
//! polar torsion constant J = 1/6 that the literature uses as well as St Venant's 0.140577, which moves it by 1 %.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::equilibrium;
use crate::verify::chain::{chain, section};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const PART: Quantity = Quantity {
    source: "rod equations by shooting",
    tolerance: 5e-4,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "bend-45-degrees",
    title: "45° bend: curved cantilever in space under a tip force across its plane",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip along x, polar J",
            reference: || vec![-23.560_582],
            others: &[Other {
                value: "-23.5 (Bathe & Bolourchi 1979), -23.545303 (GXBeam, 16 elements)",
                source: "in OpenFAST and GXBeam",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
        Quantity {
            name: "tip along y, polar J",
            reference: || vec![-13.604_632],
            others: &[Other {
                value: "-13.4 (Bathe & Bolourchi 1979), -13.577384 (GXBeam, 16 elements)",
                source: "in OpenFAST and GXBeam",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
        Quantity {
            name: "tip along z, polar J",
            reference: || vec![53.475_478],
            others: &[Other {
                value: "53.4 (Bathe & Bolourchi 1979), 53.458008 (GXBeam, 16 elements)",
                source: "in OpenFAST and GXBeam",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
        Quantity {
            name: "tip along x, St Venant's J",
            reference: || vec![-23.819_092],
            ..PART
        },
        Quantity {
            name: "tip along y, St Venant's J",
            reference: || vec![-13.731_646],
            ..PART
        },
        Quantity {
            name: "tip along z, St Venant's J",
            reference: || vec![53.607_986],
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let elements = level.times(8);
    let polar = tip(elements, 1.0 / 6.0, progress)?;
    let st_venant = tip(elements, 0.140_577, progress)?;
    Ok(Answer::new(
        format!("{elements} beams"),
        [polar.x, polar.y, polar.z, st_venant.x, st_venant.y, st_venant.z],
    ))
}

fn tip(elements: usize, torsion: f64, progress: &Progress) -> Result<Vector3<f64>, VerifyError> {
    let place = |i: usize| {
        let angle = std::f64::consts::FRAC_PI_4 * i as f64 / elements as f64;
        100.0 * Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0)
    };
    let (shear, bending) = (5.0 / 6.0 * 5e6, 1e7 / 12.0);
    let section = section([1e7, shear, shear, 5e6 * torsion, bending, bending])?;
    let model = chain((0..=elements).map(place).collect(), &Vector3::z(), section)?;
    let mut loads = Loads::none(elements + 1);
    loads.force_n[elements] = 600.0 * Vector3::z();
    Ok(equilibrium(&model, &loads, progress)?.displacement[elements])
}
