//! The paper's own results, from the profiles as it first states them: ratios that no unknown amplitude enters, and the
//! measured gains that they stand beside.

use serde_json::Value;
use washout::aero::CoefficientLaw;

use crate::{design, folder, washout};

/// The three wings with their measured twist on the paper's ramp.
fn summary(more: &[&str]) -> Value {
    let here = folder();
    let wings = ["rigid", "twist-v1", "twist-v2"].map(design);
    let mut arguments = vec![
        "lift", &wings[0], &wings[1], &wings[2], "--twist", "measured", "--json",
    ];
    arguments.extend(more);
    let said = washout(here.path(), &arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    said.document()
}

fn at(value: &Value, path: &[&str]) -> f64 {
    let found = path.iter().fold(value, |value, key| &value[key]);
    found.as_f64().unwrap_or_else(|| panic!("{path:?} in {value}"))
}

#[track_caller]
fn near(found: f64, expected: f64, share: f64) {
    assert!((found / expected - 1.0).abs() < share, "{found}, not {expected}");
}

#[test]
fn coefficients_at_45_degrees_are_those_of_dickinson() {
    let (lift, drag) = CoefficientLaw::Dickinson.lift_and_drag(45.0_f64.to_radians());
    near(lift, 1.805, 3e-4);
    near(drag, 1.704, 3e-4);
}

/// On the planform of the paper before it is closed and cut at its ends, as the reference numbers were computed.
#[test]
fn ratios_that_no_amplitude_enters_agree_to_half_a_percent() {
    let whole = [
        "--set",
        "planform.base_closure=0.001",
        "--set",
        "planform.tip_cut=0.999",
    ];
    let summary = summary(&whole);
    for (index, [lift, drag, lift_to_drag, per_power, per_power_own]) in [
        [0.786, 0.579, 1.357, 1.481, 1.414],
        [0.905, 0.701, 1.290, 1.375, 1.255],
    ]
    .into_iter()
    .enumerate()
    {
        let ratios = &summary["ratios"][index];
        near(at(ratios, &["equal_rate", "lift"]), lift, 5e-3);
        near(at(ratios, &["equal_rate", "drag"]), drag, 5e-3);
        near(at(ratios, &["equal_rate", "lift_to_drag"]), lift_to_drag, 5e-3);
        near(at(ratios, &["equal_rate", "lift_per_power"]), per_power, 5e-3);
        near(
            at(ratios, &["equal_amplitude", "lift_per_power"]),
            per_power_own,
            5e-3,
        );
    }
}

#[test]
fn one_amplitude_ratio_explains_the_effective_coefficients_of_both_wings() {
    let summary = summary(&[]);
    for (index, implied) in [0.979, 0.978].into_iter().enumerate() {
        let effective = &summary["ratios"][index]["effective"];
        near(at(effective, &["implied_amplitude_ratio"]), implied, 5e-3);
    }
}

#[test]
fn lift_per_power_at_equal_amplitude_is_the_measured_efficiency_of_v1_and_within_3_percent_of_v2() {
    let summary = summary(&[]);
    for (index, share) in [(0, 0.005), (1, 0.03)] {
        let ratios = &summary["ratios"][index];
        let measured = ratios["measured"]["efficiency"][0].as_f64().expect("efficiency");
        near(
            at(ratios, &["equal_amplitude", "lift_per_power"]),
            measured,
            share,
        );
    }
}

#[test]
fn no_assumed_number_moves_the_ratios_by_half_a_percent_but_law_and_ramp_do() {
    let summary = summary(&["--sensitivity"]);
    let rows = summary["sensitivity"].as_array().expect("rows");
    let of = |wing: &str| {
        rows.iter()
            .filter(move |row| row["wing"] == wing)
            .collect::<Vec<_>>()
    };
    for wing in ["twist-v1", "twist-v2"] {
        let rows = of(wing);
        let base = at(rows[0], &["lift_per_power_at_equal_rate"]);
        assert_eq!(rows[0]["what"], "nothing");
        let moved = |row: &Value| (at(row, &["lift_per_power_at_equal_rate"]) / base - 1.0).abs();
        for row in &rows[1..] {
            let key = row["what"].as_str().expect("a key");
            if key == "air.coefficients" || row["value"] == "50/0/50" {
                assert!(moved(row) > 0.02, "{row}");
            } else if !key.starts_with("ramp") {
                assert!(moved(row) < 5e-3, "{row}");
            }
        }
    }
}

#[test]
fn along_the_span_v1_is_nearer_to_an_ellipse_and_drags_less_at_the_tip() {
    let summary = summary(&[]);
    let off = |wing: usize| at(&summary["wings"][wing], &["departure_from_ellipse"]);
    assert!(off(1) < 0.8 * off(0), "{} {}", off(1), off(0));
    let drag_near_tip = |wing: usize| {
        let curve = &summary["span"][wing];
        let r = curve["r_mm"].as_array().expect("stations");
        let index = r.iter().position(|r| r.as_f64() > Some(64.0)).expect("a station");
        curve["drag_mn_per_mm"][index].as_f64().expect("drag")
    };
    assert!(drag_near_tip(1) < 0.45 * drag_near_tip(0));
}
