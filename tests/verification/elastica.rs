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
use washout::structure::{Loads, Section};

use crate::support::{chain, off, solve, straight};

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

#[test]
fn tip_follows_the_elliptic_integrals_within_a_thousandth() {
    let (length, bending, elements) = (0.1, 2e-3, 32);
    // a slender beam: its stretch EA = 1e7 EI/L² moves nothing in the fifth digit
    let section = Section::uncoupled(1e7 * bending / (length * length), bending, bending, bending);
    let model = chain(straight(length, elements), &Vector3::z(), section);
    for [alpha, across, shortening, slope] in CURVE {
        let mut loads = Loads::none(elements + 1);
        loads.force_n[elements].z = alpha * bending / (length * length);
        let (state, report) = solve(&model, &loads, 1);
        let tip = state.displacement[elements] / length;
        let turn = -state.rotation[elements].scaled_axis().y;
        let error = [off(tip.z, across), off(-tip.x, shortening), off(turn, slope)];
        println!("α = {alpha}: {error:.5?} in {} steps", report.steps);
        assert!(error.iter().all(|e| *e < 1e-3), "α = {alpha}: {error:?}");
    }
}
