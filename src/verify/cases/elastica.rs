//! The elastica: a cantilever under a dead force across its tip.
//!
//! ```text
//!  |                        ↑ P, keeps its direction
//!  |=======================      L, EI; inextensible, rigid in shear
//!  |  α = P L²/EI
//! ```
//!
//! Values: elliptic integrals as in Mattiasson, Int. J. Numer. Methods Eng. 17 (1981) 145-153, own evaluation checked
//! against the differential equation to 1e-6; at α = 3 the w/L = 0.60 of Bisshopp & Drucker, Q. Appl. Math. 3 (1945).

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::{Loads, Section};
use crate::verify::answer::follow;
use crate::verify::chain::{chain, straight};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// α, w/L across, u/L shortening, slope of the tip (rad).
const CURVE: [[f64; 4]; 18] = [
    [0.2, 0.066364, 0.002647, 0.099636],
    [0.4, 0.130975, 0.010354, 0.197155],
    [0.6, 0.19235, 0.022488, 0.290738],
    [0.8, 0.249452, 0.038166, 0.379063],
    [1.0, 0.301721, 0.056433, 0.461352],
    [1.5, 0.410978, 0.107942, 0.63954],
    [2.0, 0.493457, 0.160642, 0.78175],
    [3.0, 0.603253, 0.25442, 0.986017],
    [4.0, 0.669964, 0.328941, 1.121239],
    [5.0, 0.713792, 0.387628, 1.215368],
    [6.0, 0.744571, 0.434589, 1.283697],
    [7.0, 0.767369, 0.472927, 1.33496],
    [8.0, 0.784982, 0.504828, 1.374432],
    [9.0, 0.799056, 0.531821, 1.405465],
    [10.0, 0.810609, 0.554996, 1.430286],
    [12.0, 0.828593, 0.592853, 1.466954],
    [14.0, 0.842103, 0.62262, 1.492152],
    [16.0, 0.852747, 0.646773, 1.510072],
];

const PART: Quantity = Quantity {
    source: "elliptic integrals (Mattiasson 1981)",
    tolerance: 1e-3,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "elastica",
    title: "Elastica: cantilever under a dead tip force, P L²/EI = 0.2 to 16",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip across, w/L",
            reference: || CURVE.map(|row| row[1]).to_vec(),
            others: &[Other {
                value: "0.60 at P L²/EI = 3",
                source: "Bisshopp & Drucker 1945, in MOOSE",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
        Quantity {
            name: "shortening, u/L",
            reference: || CURVE.map(|row| row[2]).to_vec(),
            ..PART
        },
        Quantity {
            name: "slope of the tip",
            unit: "rad",
            reference: || CURVE.map(|row| row[3]).to_vec(),
            ..PART
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (length, bending, elements) = (0.1, 2e-3, level.times(16));
    // a slender beam: its stretch EA = 1e7 EI/L² moves nothing in the fifth digit
    let unit = bending / (length * length);
    let section = Section::uncoupled(1e7 * unit, bending, bending, bending);
    let model = chain(straight(length, elements), &Vector3::z(), section)?;
    let mut full = Loads::none(elements + 1);
    full.force_n[elements].z = 16.0 * unit;
    let shares = CURVE.map(|row| row[0] / 16.0);
    let tips = follow(&model, &full, shares, progress, |state| {
        let tip = state.displacement[elements] / length;
        [tip.z, -tip.x, -state.rotation[elements].scaled_axis().y]
    })?;
    let curve = |k: usize| tips.iter().map(|tip| tip[k]).collect();
    Ok(Answer::curves(
        format!("{elements} beams"),
        [curve(0), curve(1), curve(2)],
    ))
}
