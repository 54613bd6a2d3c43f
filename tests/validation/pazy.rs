//! The Pazy wing: against UM/NAST on the same equivalent beam, and against the measurement on the bench.
//!
//! UM/NAST (C. Riso, C. E. S. Cesnik, University of Michigan; strain-based beam, 15 elements): rows of
//! github.com/UM-A2SRL/AePW3-LDWG at 396710a, 03_2023_JA_Riso_Cesnik/03_Static_Structural, beam bending and beam torsion.
//! They count from the wing without mass, in % of the span (549.8437 mm). The mass of torsion hangs 40 mm behind the trailing
//! edge without skin, 80 mm with it.

use washout::input::measurement::Channel::{Deflection, Twist};

use crate::support::{bending, hung, misfit, near, shipped, stands, sweep};

fn torsion(numbers: &[f64]) -> Vec<String> {
    hung(numbers[0], 138.9)
}

fn torsion_with_skin(numbers: &[f64]) -> Vec<String> {
    hung(numbers[0], 178.9)
}

#[test]
fn a_mass_at_mid_chord_bends_the_pazy_wing_as_in_umnast() {
    for (design, kg, percent) in [
        ("pazy", 0.5, -10.7830712),
        ("pazy", 1.0, -20.6405870),
        ("pazy-skin", 0.5, -10.4348560),
        ("pazy-skin", 1.0, -20.0095027),
    ] {
        let mid_chord = |kg: f64| {
            let wing = shipped(design, &bending(&[kg]));
            wing.moved_mm(wing.planform.tip_m())[2]
        };
        let moved_mm = mid_chord(kg) - mid_chord(0.0);
        near(&format!("{design}, {kg} kg"), moved_mm, percent * 5.498437, 2e-3);
    }
}

#[test]
fn a_mass_behind_the_trailing_edge_twists_the_pazy_wing_as_in_umnast() {
    for (design, kg, nose_up_deg) in [
        ("pazy", 0.5, 2.0154421),
        ("pazy", 1.0, 3.8101875),
        ("pazy-skin", 0.5, 2.8478667),
        ("pazy-skin", 1.0, 5.3891959),
    ] {
        let sets = if design == "pazy" {
            torsion
        } else {
            torsion_with_skin
        };
        let twist = |kg: f64| shipped(design, &sets(&[kg])).tip_twist_deg();
        near(
            &format!("{design}, {kg} kg"),
            twist(0.0) - twist(kg),
            nose_up_deg,
            5e-4,
        );
    }
}

/// Bias, RMSE, and RMSE with the zero taken off. The first two hold the wing's own weight, which the source has taken off.
#[test]
fn without_skin_the_figures_of_the_pazy_wing_against_the_measurement_stand() {
    let rows = sweep("pazy", "pazy", "bending-", bending);
    stands(
        "bending, mm",
        misfit(&rows, Deflection, ""),
        [11.815, 12.754, 4.804],
    );
    let rows = sweep("pazy", "pazy", "torsion-", torsion);
    stands(
        "torsion, mm",
        misfit(&rows, Deflection, ""),
        [9.997, 11.271, 5.206],
    );
    stands("torsion, deg", misfit(&rows, Twist, ""), [-0.001, 0.245, 0.245]);
}

#[test]
fn with_skin_the_figures_of_the_pazy_wing_against_the_measurement_stand() {
    let rows = sweep("pazy-skin", "pazy-skin", "bending-", bending);
    stands(
        "bending, mm",
        misfit(&rows, Deflection, ""),
        [9.577, 12.149, 7.476],
    );
    let rows = sweep("pazy-skin", "pazy-skin", "torsion-", torsion_with_skin);
    stands(
        "torsion, mm",
        misfit(&rows, Deflection, ""),
        [5.554, 8.476, 6.403],
    );
    stands("torsion, deg", misfit(&rows, Twist, ""), [0.863, 1.046, 0.591]);
}
