//! A stubby cantilever under a dead tip force: bending, shear and stretch at once.
//!
//! Nachbagauer, Pechstein, Irschik & Gerstmayr, Multibody Syst. Dyn. 26 (2011) 245-263.
//!
//! ```text
//!  |=========== ↑ P = 6.25e7     L = 2, h = 0.5, b = 0.1, E = 2.07e11, ν = 0.3,
//!                                shear factor 10 (1 + ν)/(12 + 11 ν)
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::equilibrium;
use crate::verify::chain::{chain, section, straight};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const PART: Quantity = Quantity {
    unit: "m",
    source: "rod equations",
    tolerance: 1e-3,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "thick-cantilever",
    title: "Stubby cantilever under a dead tip force: bending, shear and stretch",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip along",
            reference: || vec![-0.150_971_14],
            others: &[Other {
                value: "-0.15097103",
                source: "1024 elements of Nachbagauer et al. 2011, in Exudyn",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
        Quantity {
            name: "tip across",
            reference: || vec![0.710_568_60],
            others: &[Other {
                value: "0.71056837",
                source: "1024 elements of Nachbagauer et al. 2011, in Exudyn",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (elements, e, nu) = (level.times(16), 2.07e11, 0.3);
    let (b, h) = (0.1, 0.5_f64);
    let shear = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu) * e / (2.0 * (1.0 + nu)) * b * h;
    let bending = e * b * h.powi(3) / 12.0;
    let section = section([e * b * h, shear, shear, bending, bending, bending])?;
    let model = chain(straight(2.0, elements), &Vector3::z(), section)?;
    let mut loads = Loads::none(elements + 1);
    loads.force_n[elements].z = 6.25e7;
    let tip = equilibrium(&model, &loads, progress)?.displacement[elements];
    Ok(Answer::new(format!("{elements} beams"), [tip.x, tip.z]))
}
