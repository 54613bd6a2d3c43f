//! `washout lift` as its user meets it.

use crate::{design, file, folder, washout};

const COARSE: [&str; 2] = ["--refine", "0.35"];

#[test]
fn a_solved_wing_with_sweep_effects_and_inertia_writes_what_it_lists() {
    let here = folder();
    let wing = design("twist-v2");
    let arguments = [
        &[
            "lift",
            &wing,
            "--sweep",
            "3",
            "--phases",
            "3",
            "--json",
            "--inertial-power",
        ][..],
        &["--set", "effects.phase-lag.strength=0.1"],
        &COARSE,
    ];
    let said = washout(here.path(), &arguments.concat());
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    // effects that know the phase leave no table of twist by speed, and the page says so
    assert!(
        document["warnings"][0]
            .as_str()
            .expect("a warning")
            .contains("left out of the sweep")
    );
    let inertial = &document["wings"][0]["inertial"];
    let without = inertial["mean_without_recovery_mw"].as_f64().expect("power");
    assert!(without > document["wings"][0]["mean"]["power_mw"].as_f64().expect("power"));
    for name in document["files"].as_array().expect("files") {
        let path = here
            .path()
            .join("output/twist-v2-lift")
            .join(name.as_str().expect("a name"));
        assert!(path.is_file(), "{name}");
    }
}

#[test]
fn lift_rises_with_power_over_the_amplitude_and_the_sweep_passes_through_the_wing_as_flown() {
    let here = folder();
    let wing = design("twist-v2");
    let arguments = [
        &["lift", &wing, "--sweep", "3", "--phases", "3", "--json"][..],
        &COARSE,
    ];
    let document = washout(here.path(), &arguments.concat()).document();
    let sweep = &document["sweep"][0];
    let column = |key: &str| -> Vec<f64> {
        let values = sweep[key].as_array().expect(key).iter();
        values.map(|value| value.as_f64().expect("a number")).collect()
    };
    let (amplitude, lift, power) = (
        column("half_amplitude_deg"),
        column("lift_mn"),
        column("power_mw"),
    );
    assert!((amplitude[1] / 34.5 - 1.0).abs() < 1e-9);
    assert!(lift.windows(2).all(|pair| pair[1] > pair[0]) && power.windows(2).all(|pair| pair[1] > pair[0]));
    let mean = &document["wings"][0]["mean"];
    // between the solved phases the twist is taken as straight, with more of them known in the sweep
    assert!((lift[1] / mean["lift_mn"].as_f64().expect("lift") - 1.0).abs() < 5e-3);
    // more washout the harder it flaps: less than the square
    assert!(lift[2] / lift[0] < (1.3_f64 / 0.7).powi(2));
}

#[test]
fn a_profile_flies_on_the_stroke_of_a_design() {
    let here = folder();
    let profile = file(
        here.path(),
        "stated.csv",
        "# Twist v2 as first stated\nr_mm,twist_deg\n0,0\n20,0\n70,23\n",
    );
    let (rigid, v2) = (design("rigid"), design("twist-v2"));
    let said = washout(
        here.path(),
        &[
            "lift", &rigid, &v2, &profile, "--on", &v2, "--twist", "measured", "--json",
        ],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let lift = |wing: usize| document["wings"][wing]["mean"]["lift_mn"].as_f64().expect("lift");
    assert!((lift(1) / lift(2) - 1.0).abs() < 1e-9, "{} {}", lift(1), lift(2));
    assert_eq!(document["wings"][2]["name"], "stated");
}

#[test]
fn an_effect_on_the_air_reaches_the_means_over_the_stroke() {
    let here = folder();
    let rigid = design("rigid");
    let lift = |more: &[&str]| {
        let said = washout(
            here.path(),
            &[&["lift", &rigid, "--twist", "flat", "--json"], more].concat(),
        );
        assert_eq!(said.code, Some(0), "{}", said.err);
        let mean = said.document()["wings"][0]["mean"].clone();
        [
            mean["lift_mn"].as_f64().expect("lift"),
            mean["drag_mn"].as_f64().expect("drag"),
        ]
    };
    let (plain, scaled) = (
        lift(&[]),
        lift(&["--set", "effects.coefficient-scale.strength=0.1"]),
    );
    assert!(
        (scaled[0] / plain[0] - 1.1).abs() < 1e-9 || (scaled[0] / plain[0] - 0.1).abs() > 0.5,
        "{scaled:?} {plain:?}"
    );
    assert!(scaled[0] != plain[0]);
    // added mass: nothing over a stroke that is the same on both sides of its middle
    let moved = lift(&["--with", "added-mass"]);
    assert!((moved[0] / plain[0] - 1.0).abs() < 1e-9 && (moved[1] / plain[1] - 1.0).abs() < 1e-9);
}

#[test]
fn bad_inputs_end_with_2_say_the_cure_and_write_nothing() {
    let here = folder();
    let rigid = design("rigid");
    let empty = file(here.path(), "empty.csv", "r_mm,twist_deg\n");
    let fallen = file(here.path(), "fallen.csv", "r_mm,twist_deg\n10,0\n5,1\n");
    let good = file(here.path(), "good.csv", "r_mm,twist_deg\n0,0\n70,20\n");
    let bench = design("minguet-1");
    for (arguments, said) in [
        (vec!["lift"], "is missing"),
        (vec!["lift", "none.toml"], "no such file"),
        (vec!["lift", &rigid, &empty], "no rows"),
        (vec!["lift", &rigid, &fallen], "Sort the rows"),
        (vec!["lift", &good], "--on"),
        (vec!["lift", &rigid, &rigid], "two wings are called 'rigid'"),
        (vec!["lift", &bench], "flap"),
        (
            vec!["lift", &rigid, "--sweep", "3", "--amplitudes", "45,24"],
            "--amplitudes",
        ),
        (vec!["lift", &rigid, "--with", "rotational"], "rotational"),
        (
            vec![
                "lift",
                &rigid,
                "--twist",
                "measured",
                "--set",
                "measured.case=twist",
            ],
            "twist",
        ),
    ] {
        let done = washout(here.path(), &arguments);
        assert_eq!(done.code, Some(2), "{arguments:?}: {}", done.err);
        assert!(done.err.contains(said), "{arguments:?}: {}", done.err);
        assert!(!here.path().join("output").exists(), "{arguments:?}");
    }
}
