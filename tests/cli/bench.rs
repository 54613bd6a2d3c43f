//! Designs on the bench, and designs that cannot be solved: what a new user tries first.

use std::fs;

use crate::{Said, folder, washout};

/// A tube rod under one load at its tip, and `more`.
fn rod(load: &str, more: &str) -> String {
    format!(
        "format = 1
name = \"bench\"
[planform]
length_mm = 200.0
outline = [[0.0, 40.0], [200.0, 40.0]]
base_closure = 0.0
tip_cut = 1.0
[[rod]]
from_mm = 0.0
to_mm = 200.0
material = \"carbon\"
section = {{ shape = \"tube\", outer_diameter_mm = 2.0, inner_diameter_mm = 1.0 }}
[[load]]
at_mm = 200.0
{load}
[material.carbon]
e_gpa = 130.0
g_gpa = 5.0
density_kg_m3 = 1500.0
[material.kapton]
e_gpa = 2.5
poisson = 0.34
density_kg_m3 = 1420.0
{more}"
    )
}

const FILM: &str = "[film]\nmaterial = \"kapton\"\nthickness_mm = 0.02\n";

fn solve(text: &str, more: &[&str]) -> Said {
    let here = folder();
    fs::write(here.path().join("bench.toml"), text).expect("written");
    washout(here.path(), &[&["solve", "bench.toml"], more].concat())
}

#[test]
fn a_film_without_air_is_solved_by_every_accelerator() {
    let text = rod("moment_n_m = [0.001, 0.0, 0.0]", FILM);
    for accelerator in ["newton", "anderson", "aitken", "none"] {
        let set = format!("coupling.accelerator={accelerator}");
        let said = solve(&text, &["--set", &set, "--refine", "0.5"]);
        assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{accelerator}");
    }
}

#[test]
fn an_axial_load_beyond_that_of_euler_ends_with_3_and_below_it_with_0() {
    // Euler: π² E I / (2 L)² with E I = 130e9 · π (2⁴ − 1⁴) 1e-12 / 64 = 0.0957 N m²: 5.9 N
    for (force_n, code) in [(-3.0, 0), (-240.0, 3)] {
        let load = format!("force_n = [{force_n:?}, 0.0, 0.0]");
        let said = solve(&rod(&load, ""), &[]);
        assert_eq!(said.code, Some(code), "{}", said.err);
        assert_eq!(said.err.contains("not stable"), code == 3, "{}", said.err);
        assert_eq!(
            said.err.contains("a small force across"),
            code == 3,
            "{}",
            said.err
        );
    }
}

#[test]
fn an_unknown_effect_ends_with_2_and_names_those_that_there_are() {
    let text = rod("force_n = [0.0, 0.0, 0.1]", "[effects.ground]\nstrength = 1.0\n");
    let said = solve(&text, &[]);
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    for words in [
        "bench.toml",
        "effects.ground: there is no such effect",
        "tip-loss-prandtl",
        "washout effects",
    ] {
        assert!(said.err.contains(words), "{words:?} is not in {}", said.err);
    }
}

#[test]
fn a_negative_refinement_is_refused_by_its_range() {
    let said = solve(&rod("force_n = [0.0, 0.0, 0.1]", ""), &["--refine", "-1"]);
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    assert!(said.err.contains("mesh.refine"), "{}", said.err);
}

#[test]
fn a_run_that_replaces_one_with_other_inputs_says_so_and_one_with_the_same_does_not() {
    let here = folder();
    fs::write(
        here.path().join("bench.toml"),
        rod("force_n = [0.0, 0.0, 0.1]", ""),
    )
    .expect("written");
    let replaces = |set: &[&str]| {
        let said = washout(here.path(), &[&["solve", "bench.toml"], set].concat());
        said.err.contains("replaces an earlier run with other inputs")
    };
    assert!(!replaces(&[]) && !replaces(&[]));
    assert!(replaces(&["--set", "load[0].force_n=[0.0, 0.0, 0.2]"]));
}

#[test]
fn flapping_set_on_a_wing_in_a_stream_is_refused_for_standing_beside_it() {
    let steady = rod(
        "force_n = [0.0, 0.0, 0.1]",
        "[steady]\nspeed_m_s = 5.0\nroot_angle_deg = 5.0\n",
    );
    let said = solve(&steady, &["--set", "flapping.frequency_hz=20"]);
    assert_eq!(said.code, Some(2));
    assert!(
        said.err.contains("cannot stand together with flapping"),
        "{}",
        said.err
    );
}
