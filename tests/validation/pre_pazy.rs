//! The Pre-Pazy wing: against UM/NAST on the same equivalent beam, and against the measurement, with and without skin.
//!
//! UM/NAST (C. Riso, C. E. S. Cesnik, University of Michigan; strain-based beam, 15 elements): the rows at 0, 1 and 3 kg
//! of github.com/ngoiz/pazy-aepw3-results at 559bd1c, `bending_UMNAST_*.txt` and `torsion_UMNAST_*.txt`. Twist and sag
//! of the wing under its own weight depend on the signs of couplings and offsets, so they check the mirrored design.

use washout::compare::ComparedRow;
use washout::input::measurement::Channel::{Deflection, Twist};

use crate::support::{bending, hung, misfit, near, shipped, stands, sweep};

fn torsion(numbers: &[f64]) -> Vec<String> {
    hung(numbers[0], -80.0)
}

fn aero(numbers: &[f64]) -> Vec<String> {
    let (angle, speed) = (numbers[0], numbers[1]);
    vec![
        "load[0].mass_kg=0".to_string(),
        "gravity.acceleration_m_s2=[0,0,0]".to_string(),
        format!("steady.root_angle_deg={angle}"),
        format!("observation.frame_pitch_deg={angle}"),
        format!("steady.speed_m_s={speed}"),
    ]
}

#[test]
fn a_mass_at_mid_chord_bends_the_wing_as_in_umnast() {
    for (design, kg, deflection_mm) in [
        ("pre-pazy", 0.0, -17.61009),
        ("pre-pazy", 1.0, -131.57837),
        ("pre-pazy", 3.0, -278.84140),
        ("pre-pazy-skin", 0.0, -15.68701),
        ("pre-pazy-skin", 1.0, -118.67902),
        ("pre-pazy-skin", 3.0, -260.65105),
    ] {
        let wing = shipped(design, &bending(&[kg]));
        let name = format!("{design}, {kg} kg");
        near(
            &name,
            wing.moved_mm(wing.planform.tip_m())[2],
            deflection_mm,
            2e-3,
        );
    }
}

#[test]
fn a_mass_ahead_of_the_leading_edge_twists_the_wing_as_in_umnast() {
    for (design, kg, deflection_mm, washout_deg) in [
        ("pre-pazy", 0.0, -17.61009, 0.010547),
        ("pre-pazy", 1.0, -130.53477, 5.21624),
        ("pre-pazy", 3.0, -271.65919, 10.95506),
        ("pre-pazy-skin", 0.0, -15.68701, 0.005791),
        ("pre-pazy-skin", 1.0, -117.79434, 4.78285),
        ("pre-pazy-skin", 3.0, -254.29057, 10.52485),
    ] {
        let wing = shipped(design, &torsion(&[kg]));
        let name = format!("{design}, {kg} kg");
        near(
            &name,
            wing.moved_mm(wing.planform.tip_m())[2],
            deflection_mm,
            2e-3,
        );
        near(&name, wing.tip_twist_deg(), washout_deg, 1e-2);
    }
}

/// Bias, RMSE, and RMSE with the ruler's zero taken off. The first two hold the unknown zero of each run.
#[test]
fn without_skin_the_figures_against_the_measurement_stand() {
    let rows = sweep("pre-pazy", "pre-pazy", "bending-", bending);
    stands(
        "bending, mm",
        misfit(&rows, Deflection, ""),
        [-30.299, 30.425, 2.768],
    );
    let rows = sweep("pre-pazy", "pre-pazy", "torsion-", torsion);
    stands(
        "torsion, mm",
        misfit(&rows, Deflection, ""),
        [0.327, 6.447, 6.439],
    );
    stands("torsion, deg", misfit(&rows, Twist, ""), [1.598, 1.677, 0.508]);
}

fn with_skin(design: &str) -> [Vec<ComparedRow>; 2] {
    [
        sweep(design, "pre-pazy-skin", "bending-", bending),
        sweep(design, "pre-pazy-skin", "torsion-", torsion),
    ]
}

#[test]
fn with_skin_the_figures_against_the_measurement_stand() {
    let [bent, twisted] = with_skin("pre-pazy-skin");
    stands(
        "bending, run 1, mm",
        misfit(&bent, Deflection, "bending-1"),
        [22.080, 22.297, 3.107],
    );
    stands(
        "bending, run 2, mm",
        misfit(&bent, Deflection, "bending-2"),
        [12.054, 14.052, 7.223],
    );
    stands(
        "torsion, mm",
        misfit(&twisted, Deflection, ""),
        [3.218, 7.781, 7.084],
    );
    stands(
        "torsion, deg",
        misfit(&twisted, Twist, ""),
        [-0.328, 0.373, 0.178],
    );
}

/// A finding against expectation: with its skin modelled the wing is too stiff in bending; left out, it fits better.
#[test]
fn with_skin_but_modelled_without_it_the_figures_stand() {
    let [bent, twisted] = with_skin("pre-pazy");
    stands(
        "bending, run 1, mm",
        misfit(&bent, Deflection, "bending-1"),
        [31.647, 31.683, 1.508],
    );
    stands(
        "bending, run 2, mm",
        misfit(&bent, Deflection, "bending-2"),
        [26.406, 26.659, 3.661],
    );
    stands(
        "torsion, mm",
        misfit(&twisted, Deflection, ""),
        [16.073, 16.542, 3.910],
    );
    stands(
        "torsion, deg",
        misfit(&twisted, Twist, ""),
        [-0.733, 0.762, 0.210],
    );
}

/// Strip theory without induced flow loads the tip too much.
#[test]
fn in_the_wind_the_figures_against_the_measurement_stand() {
    let rows = sweep("pre-pazy-skin", "pre-pazy-skin", "aero-5-", aero);
    stands(
        "5 deg, mm",
        misfit(&rows, Deflection, ""),
        [-11.340, 15.053, 14.637],
    );
    let rows = sweep("pre-pazy-skin", "pre-pazy-skin", "aero-7-", aero);
    stands(
        "7 deg, mm, first reading",
        misfit(&rows, Deflection, "aero-1"),
        [-7.270, 10.027, 9.911],
    );
}
