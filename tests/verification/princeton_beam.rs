//! The Princeton beam: a strip cantilever under a tip weight at an angle to its stiff plane twists.
//!
//! Dowell & Traybar, AMS reports 1194 and 1257 (NASA CR-137968 and -137969, 1975).
//!
//! ```text
//!        z flap            L = 508 mm, 12.377 × 3.2024 mm, E = 71.7 GPa, ν = 0.31
//!        |    β            tip weights 4.448, 8.896, 13.345 N, dead
//!  ======|======  y edge   β = 0: in the stiff plane
//! ```
//!
//! Values: own geometrically exact rod solution (the measured reports could not be had; ANSYS beams agree with it to
//! 0.1 % in flap): rotation-vector component of the tip about the beam's axis at rest, degrees.

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{chain, off, section, solve, straight};

/// Weight (N), angle (°), tip displacement in the stiff and across the soft plane (m), twist (°).
const TIP: [[f64; 5]; 15] = [
    [4.448, 15.0, 0.005210161673, 0.020801088315, 0.195869336659],
    [4.448, 30.0, 0.004751074792, 0.039949401311, 0.336422490394],
    [4.448, 45.0, 0.003965163327, 0.056055192880, 0.384129723986],
    [4.448, 60.0, 0.002862206705, 0.068129122365, 0.329034353659],
    [4.448, 75.0, 0.001502994632, 0.075571496971, 0.188476297563],
    [8.896, 15.0, 0.010625771186, 0.042125218621, 0.797532854263],
    [8.896, 30.0, 0.010147240763, 0.079456076074, 1.335067140689],
    [8.896, 45.0, 0.008888857594, 0.109041567661, 1.476674763194],
    [8.896, 60.0, 0.006654361326, 0.129923512428, 1.229177812250],
    [8.896, 75.0, 0.003568890610, 0.142214416674, 0.690658011931],
    [13.345, 15.0, 0.016502892035, 0.064496309470, 1.847219002774],
    [13.345, 30.0, 0.016777987617, 0.117902263429, 2.958157477999],
    [13.345, 45.0, 0.015342257577, 0.156587823329, 3.121333249524],
    [13.345, 60.0, 0.011716415438, 0.181921186361, 2.503908524395],
    [13.345, 75.0, 0.006328438282, 0.196124707341, 1.375496212347],
];

#[test]
fn twist_of_the_tip_is_that_of_the_exact_rod_within_a_percent() {
    let elements = 20;
    let shear = 5.0 / 6.0 * 2_841_909.0 / (2.0 * 1.31);
    let stiffness = [2_841_909.0, shear, shear, 3.103338, 2.428734, 36.27936];
    let model = chain(straight(0.508, elements), &Vector3::z(), section(stiffness));
    for [weight, angle, edge, flap, twist] in TIP {
        let mut loads = Loads::none(elements + 1);
        let angle: f64 = f64::to_radians(angle);
        loads.force_n[elements] = weight * Vector3::new(0.0, -angle.cos(), angle.sin());
        let (state, report) = solve(&model, &loads, 1);
        let tip = state.displacement[elements];
        let turn = state.rotation[elements].scaled_axis().x.to_degrees();
        let error = [off(-tip.y, edge), off(tip.z, flap), off(turn.abs(), twist)];
        println!(
            "{weight} N, {:.0}°: edge, flap, twist off by {error:.5?} in {} steps",
            angle.to_degrees(),
            report.steps
        );
        assert!(error.iter().all(|e| *e < 1e-2), "{weight} N, {angle}: {error:?}");
    }
}
