//! A thin strip, clamped at one end, twisted at the other: the clamp keeps it from warping and so stiffens it.
//!
//! Reissner & Stein, NACA TN 2369 (1951); Kirchhoff plate by Ritz (20 × 14 terms, 1e-4).
//!
//! ```text
//!  |________↑ T/b   θ = (w(b/2) − w(−b/2))/b at the tip, over that of free warping, T L/(G b t³/3)
//!  |________↓ T/b   L/b = 1, 2, 4, 8; ν = 0, 0.3, 0.33
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// L/b.
const LENGTHS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

const PART: Quantity = Quantity {
    source: "Kirchhoff plate by Ritz",
    tolerance: 0.005,
    order: Order::Exempt("corner forces"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "clamped-strip-torsion",
    title: "Torsion of a clamped strip: tip twist over that of free warping",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "L/b = 1 to 8, ν = 0",
            reference: || vec![0.799_118, 0.899_527, 0.949_760, 0.974_868],
            ..PART
        },
        Quantity {
            name: "L/b = 1 to 8, ν = 0.3",
            reference: || vec![0.758_230, 0.879_008, 0.939_472, 0.969_696],
            others: &[Other {
                value: "0.756159, 0.878013, 0.939006, 0.969503",
                source: "1 − tanh(kL)/(kL), Reissner & Stein 1951",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
        Quantity {
            name: "L/b = 1 to 8, ν = 0.33",
            reference: || vec![0.753_340, 0.876_548, 0.938_234, 0.969_066],
            ..PART
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let across = level.times(4);
    let curve = |poisson: f64| -> Result<Vec<f64>, VerifyError> {
        LENGTHS
            .into_iter()
            .map(|length| ratio(across, length, poisson))
            .collect()
    };
    Ok(Answer::curves(
        format!("{across} across"),
        [curve(0.0)?, curve(0.3)?, curve(0.33)?],
    ))
}

/// Tip twist over that of free warping of a strip of width 1.
fn ratio(across: usize, length: f64, poisson: f64) -> Result<f64, VerifyError> {
    let thickness = 1e-3_f64;
    let count = [(length * across as f64).round() as usize, across];
    let mut grid = Grid::new(count, plate(1.0, poisson, thickness), |xi, eta| {
        Vector3::new(length * xi, eta - 0.5, 0.0)
    })?;
    grid.hold(&grid.side(false), [true; 6]);
    let [low, high] = [0, across].map(|j| grid.node([count[0], j]));
    let mut loads = Loads::none(grid.model.nodes.len());
    loads.force_n[low].z = -1.0;
    loads.force_n[high].z = 1.0;
    let moved = linear(&grid.model, &loads)?;
    let torsion = 0.5 / (1.0 + poisson) * thickness.powi(3) / 3.0;
    Ok((moved[high][0].z - moved[low][0].z) * torsion / length)
}
