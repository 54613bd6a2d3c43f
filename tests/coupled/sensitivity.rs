//! Derivatives by one linear solve against wings that are solved again.

use washout::aero::Flow;
use washout::coupling::Sensitivity;
use washout::coupling::sensitivity::Nearby;
use washout::coupling::wing::Wing;
use washout::mesh::for_design;
use washout::observation::twist_at;

use crate::support::{lift_of, shipped};

const SETS: [&str; 3] = [
    "mesh.refine=0.5",
    "coupling.twist_tolerance_deg=2e-8",
    "coupling.residual_tolerance=1e-8",
];

fn readings(nearby: &Nearby) -> Vec<f64> {
    let r_m = 0.97 * nearby.planform.length_m();
    let twist = twist_at(&nearby.design, &nearby.planform, &nearby.solution, r_m).unwrap();
    let flow = Flow::from_design(&nearby.design).unwrap();
    vec![twist, lift_of(&flow, &nearby.solution)]
}

/// Largest error of the rates of tip twist and lift with a key, relative; solved again with the key moved by `share`.
fn error(name: &str, extra: &[&str], key: &str, share: f64) -> [f64; 2] {
    let mut sets = SETS.to_vec();
    sets.extend_from_slice(extra);
    let base = shipped(name, &sets);
    let solution = base.solve();
    let wing = Wing::new(&base.design, &base.mesh, None).unwrap();
    let remesh = |design: &_| for_design(design, None);
    let mut sensitivity = Sensitivity::new(&base.design, &wing, None, &solution, &remesh).unwrap();
    let rate = sensitivity.rate(key).unwrap();
    let rates = sensitivity.read(&rate, readings).unwrap();
    let again = |offset: f64| {
        let set = format!("{key}={:?}", rate.value + offset);
        let mut sets = sets.clone();
        sets.push(&set);
        let wing = shipped(name, &sets);
        let solution = wing.solve();
        readings(&Nearby {
            design: wing.design,
            planform: wing.planform,
            solution,
        })
    };
    let step = share * rate.value;
    let (up, down) = (again(step), again(-step));
    let mut errors = [0.0; 2];
    for (k, rate) in rates.iter().enumerate() {
        let slope = (up[k] - down[k]) / (2.0 * step);
        errors[k] = (rate / slope - 1.0).abs();
        println!("{name} {key} {k}: {rate:.6e} {slope:.6e} {:.1e}", errors[k]);
    }
    errors
}

#[test]
fn rates_of_tip_twist_and_lift_are_those_of_wings_solved_again() {
    for key in [
        "material.carbon-rod.g_gpa",
        "flapping.half_amplitude_deg",
        "material.kapton.e_gpa",
        "air.density_kg_m3",
        "rod[1].section.diameter_mm",
    ] {
        let errors = error("twist-v2", &[], key, 1e-3);
        assert!(errors.iter().all(|error| *error < 1e-4), "{key}: {errors:?}");
    }
}

#[test]
fn a_parameter_that_moves_the_mesh_has_its_rate_too() {
    for key in ["spar[2].at_mm", "planform.mean_chord_mm"] {
        let errors = error("twist-v2", &[], key, 2e-3);
        assert!(errors.iter().all(|error| *error < 1e-4), "{key}: {errors:?}");
    }
}

#[test]
fn a_parameter_that_moves_the_cured_shape_is_followed_there_too() {
    let taut = ["film.pretension_n_per_m=10"];
    let errors = error("twist-v2", &taut, "film.pretension_n_per_m", 1e-2);
    assert!(errors.iter().all(|error| *error < 1e-3), "{errors:?}");
}

#[test]
fn rates_hold_in_linear_kinematics() {
    // as a plate: a film of 6 µm has nothing to carry the air with without its stretching
    let linear = ["structure.kinematics=linear", "film.thickness_mm=0.3"];
    for key in ["material.carbon-rod.g_gpa", "flapping.half_amplitude_deg"] {
        let errors = error("twist-v2", &linear, key, 1e-3);
        assert!(errors.iter().all(|error| *error < 1e-4), "{key}: {errors:?}");
    }
}
