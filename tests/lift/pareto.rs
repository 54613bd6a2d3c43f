//! `washout pareto`: the front between lift and efficiency, and what the paper says of it.

use serde_json::Value;

use crate::{Said, design, folder, washout};

const FAST: [&str; 4] = ["--population", "60", "--generations", "60"];

fn pareto(more: &[&str]) -> Said {
    with(&[&FAST, more].concat())
}

fn with(more: &[&str]) -> Said {
    let here = folder();
    let wings = ["rigid", "twist-v1", "twist-v2"].map(design);
    let files: Vec<&str> = wings.iter().map(String::as_str).collect();
    washout(
        here.path(),
        &[&["pareto"], &files[..], &["--json"], more].concat(),
    )
}

fn number(value: &Value, path: &[&str]) -> f64 {
    let found = path.iter().fold(value, |value, key| &value[key]);
    found.as_f64().unwrap_or_else(|| panic!("{path:?} in {value}"))
}

fn points(front: &Value) -> Vec<[f64; 2]> {
    let points = front["points"].as_array().expect("points").iter();
    points
        .map(|p| [number(p, &["lift"]), number(p, &["efficiency"])])
        .collect()
}

#[test]
fn without_the_shape_factor_the_front_is_the_untwisted_wing_at_other_stops() {
    // twist held over the stroke, total lift over drag: no profile can beat one angle everywhere
    let said = pareto(&["--no-gain", "--ramp", "0", "--efficiency", "lift-to-drag"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let gap = &document["largest_gap"];
    assert!(number(gap, &["largest"]) < 1e-3, "a profile beats them: {gap}");
    assert!(number(gap, &["largest"]).abs() < 0.06, "{gap}");
}

#[test]
fn with_the_shape_factor_twist_pays_and_the_front_lies_above_the_untwisted_wing() {
    let document = pareto(&[]).document();
    let highest = |front: usize| -> [f64; 2] {
        let all = points(&document["fronts"][front]);
        all.into_iter()
            .reduce(|a, b| if a[0] > b[0] { a } else { b })
            .expect("points")
    };
    assert!(
        highest(0)[0] < 1.02 && highest(1)[0] > 1.1,
        "{:?} {:?}",
        highest(0),
        highest(1)
    );
    let factor = &document["shape_factor"];
    assert!(number(factor, &["strength"]) > 1.0 && number(factor, &["sigma"]) > 0.0);
    // the form does not explain both wings, and the page must say so
    let warning = document["warnings"][0].as_str().expect("a warning");
    assert!(warning.contains("No single strength"), "{warning}");
}

#[test]
fn the_front_is_within_a_percent_of_an_exhaustive_search_and_the_same_at_any_number_of_threads() {
    let more = ["--stages", "2", "--exhaustive"];
    let one = pareto(&[&more[..], &["--threads", "1"]].concat());
    let two = pareto(&[&more[..], &["--threads", "2"]].concat());
    assert_eq!(one.code, Some(0), "{}", one.err);
    assert_eq!(one.out, two.out);
    for front in one.document()["fronts"].as_array().expect("fronts") {
        let share = number(front, &["exhaustive", "found_over_exhaustive"]);
        let on_steps = number(front, &["exhaustive", "on_steps_over_exhaustive"]);
        assert!((0.99..=1.0 + 1e-9).contains(&on_steps), "{on_steps}");
        // it may be better: its profiles are not on the steps of the coarse family
        assert!(share > 0.99, "{share}");
    }
}

#[test]
fn every_profile_of_the_front_rises_keeps_its_bounds_and_is_not_beaten() {
    let document = pareto(&["--no-gain"]).document();
    let front = &document["fronts"][0];
    for point in front["points"].as_array().expect("points") {
        let rates = point["rate_deg_per_mm"].as_array().expect("rates");
        let lengths = point["length_mm"].as_array().expect("lengths");
        let total: f64 = lengths.iter().filter_map(Value::as_f64).sum();
        assert!((total - 70.0).abs() < 1e-9);
        for rate in rates {
            assert!((0.001..=1.4).contains(&rate.as_f64().expect("a rate")));
        }
        assert!(number(point, &["tip_deg"]) <= 45.0 + 1e-6);
    }
    let all = points(front);
    for a in &all {
        assert!(!all.iter().any(|b| b[0] > a[0] && b[1] > a[1]));
    }
}

#[test]
fn bad_settings_end_with_2_and_say_the_cure() {
    for (more, said) in [
        (&["--rates", "0,1"][..], "least twist rate"),
        (&["--rates", "0.5,0.1"], "largest twist rate"),
        (&["--stages", "0"], "number of stages"),
        (&["--population", "7"], "even number"),
        (&["--ramp", "0.7"], "--ramp"),
        (&["--gain", "gravity"], "does not change the lift"),
        (&["--gain", "lift-gain"], "lift-gain"),
        (&["--set", "flapping.stop_angle_deg=0.01"], "stop_angle_deg"),
    ] {
        let done = with(more);
        assert_eq!(done.code, Some(2), "{more:?}: {}", done.err);
        assert!(done.err.contains(said), "{more:?}: {}", done.err);
    }
    let here = folder();
    let done = washout(here.path(), &["pareto", &design("rigid")]);
    assert_eq!(done.code, Some(2));
    assert!(done.err.contains("effective_lift_ratio"), "{}", done.err);
}
