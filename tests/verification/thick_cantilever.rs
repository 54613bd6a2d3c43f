//! A stubby cantilever under a dead tip force: bending, shear and stretch at once.
//!
//! Nachbagauer, Pechstein, Irschik & Gerstmayr, Multibody Syst. Dyn. 26 (2011) 245-263.
//!
//! ```text
//!  |=========== ↑ P = 6.25e7     L = 2, h = 0.5, b = 0.1, E = 2.07e11, ν = 0.3,
//!                                shear factor 10 (1 + ν)/(12 + 11 ν)
//! ```
//!
//! Tip displacement (−0.15097114, 0.71056860): own solution of the rod equations; Exudyn with 1024 elements gives
//! (−0.15097103, 0.71056837).

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{chain, off, section, solve, straight};

#[test]
fn tip_moves_as_the_shear_flexible_rod_within_a_thousandth() {
    let (elements, e, nu) = (32, 2.07e11, 0.3);
    let (b, h) = (0.1, 0.5_f64);
    let shear = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu) * e / (2.0 * (1.0 + nu)) * b * h;
    let bending = e * b * h.powi(3) / 12.0;
    let model = chain(
        straight(2.0, elements),
        &Vector3::z(),
        section([e * b * h, shear, shear, bending, bending, bending]),
    );
    let mut loads = Loads::none(elements + 1);
    loads.force_n[elements].z = 6.25e7;
    let (state, report) = solve(&model, &loads, 1);
    let tip = state.displacement[elements];
    let error = [off(tip.x, -0.150_971_14), off(tip.z, 0.710_568_60)];
    println!("thick cantilever: {error:.6?} in {} steps", report.steps);
    assert!(error.iter().all(|e| *e < 1e-3), "{error:?}");
}
