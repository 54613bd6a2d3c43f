//! `washout divergence`.

use crate::{conforms, design, folder, schema, washout};

#[test]
fn a_wing_that_washes_out_has_an_equilibrium_at_every_step() {
    let here = folder();
    let said = washout(
        here.path(),
        &[
            "divergence",
            &design("rigid.toml"),
            "--to",
            "40",
            "--steps",
            "3",
            "--json",
        ],
    );
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    let document = said.document();
    conforms(&document, &schema(&["--output", "divergence"]));
    assert_eq!(document["limit"], serde_json::Value::Null);
    assert_eq!(document["steps"].as_array().expect("steps").len(), 3);
}

#[test]
fn a_value_off_the_range_of_its_key_ends_with_2() {
    let here = folder();
    let said = washout(
        here.path(),
        &["divergence", &design("rigid.toml"), "--to", "400", "--steps", "2"],
    );
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    assert!(said.err.contains("flapping.half_amplitude_deg"), "{}", said.err);
}

#[test]
fn a_sweep_that_does_not_settle_prints_its_result_and_ends_with_3() {
    let here = folder();
    let design = design("rigid.toml");
    let arguments = ["divergence", &design, "--steps", "2", "--to", "40", "--json"];
    let hasty = ["--set", "coupling.max_iterations=1"];
    let said = washout(here.path(), &[&arguments[..], &hasty[..]].concat());
    assert_eq!(said.code, Some(3), "{}", said.err);
    assert_eq!(said.document()["undecided"].as_array().expect("a list").len(), 2);
    assert!(said.err.contains("2 of the steps did not settle"), "{}", said.err);
}

#[test]
fn an_amplitude_whose_double_no_stroke_has_is_raised_to_the_largest_that_one_has() {
    let here = folder();
    let set = [
        "--set",
        "flapping.half_amplitude_deg=50",
        "--refine",
        "0.3",
        "--steps",
        "2",
        "--json",
    ];
    let said = washout(
        here.path(),
        &[&["divergence", &design("twist-v1.toml")], &set[..]].concat(),
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let steps = said.document()["steps"].clone();
    assert_eq!(steps[1]["value"], serde_json::json!(90.0), "{steps}");
}
