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
