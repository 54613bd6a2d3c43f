//! Two effects hidden, one added after the other: the error falls step by step, fitted, left out and held out.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::hidden::{MANY, campaign, json};
use crate::washout;

/// The campaign of a rod, with its largest moment held out, and two effects hidden in its readings.
fn hidden_pair(folder: &Path) {
    campaign(folder, &MANY);
    let path = folder.join("study.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(
        &path,
        text.replacen(
            "measured = 'm-{moment}'",
            "measured = 'm-{moment}'\nheld_out = ['m-3']",
            1,
        ),
    )
    .unwrap();
    let made = [
        "synthesize",
        "study.toml",
        "--effect",
        "root-flexure=0.2",
        "--effect",
        "rod-shear-modulus=0.3",
        "--seed",
        "9",
        "--output",
        "try",
        "--json",
    ];
    json(&washout(folder, &made));
}

fn names(added: &Value) -> Vec<String> {
    let rungs = added["ladder"].as_array().unwrap().iter();
    rungs
        .map(|rung| rung["name"].as_str().unwrap().to_string())
        .collect()
}

fn errors(added: &Value, of: &str) -> Vec<Option<f64>> {
    let rungs = added["ladder"].as_array().unwrap().iter();
    rungs.map(|rung| rung[of].as_f64()).collect()
}

#[test]
fn each_effect_that_was_added_has_its_step_from_uncalibrated_down_to_the_noise() {
    let folder = tempfile::tempdir().unwrap();
    hidden_pair(folder.path());
    let add = |arguments: &[&str]| {
        let all = [&["add"], arguments, &["--to", "try/study.toml", "--json"]].concat();
        json(&washout(folder.path(), &all))
    };

    let arguments = ["diagnose", "try/study.toml", "--json"];
    let said = json(&washout(folder.path(), &arguments));
    for row in said["effects"].as_array().unwrap() {
        let number = |of: &str| row[of].as_f64().unwrap();
        let [from, to] = [0, 1].map(|end| row["plausible_range"][end].as_f64().unwrap());
        assert!(from <= 0.0 && (0.3..=1.0).contains(&to), "{row}");
        // each alone tells most of what is missing, in cases left out; held out, if it was fitted alone
        assert!(number("gain_left_out_conditions") > 100.0, "{row}");
        assert!(
            row["held_out_gain"].as_f64().is_none_or(|gain| gain > 2.0),
            "{row}"
        );
    }
    assert_eq!(
        said["predictions"][0]["unit"], "deg",
        "{}",
        said["predictions"][0]
    );

    let one = add(&["rod-shear-modulus"]);
    assert_eq!(names(&one), ["raw", "calibrated", "+ rod-shear-modulus", "noise"]);
    let two = add(&["root-flexure"]);
    assert_eq!(
        names(&two),
        [
            "raw",
            "calibrated",
            "+ rod-shear-modulus",
            "+ root-flexure",
            "noise"
        ]
    );
    // as stated and calibrated are those of the model without any effect, whatever was added before
    for of in ["in_sample_sigma", "left_out_sigma", "held_out_sigma"] {
        let (first, then) = (errors(&one, of), errors(&two, of));
        assert_eq!(first[..2], then[..2], "{of}");
        let [with_one, with_both, noise] = [2, 3, 4].map(|rung| then[rung].unwrap());
        assert!(with_one > 2.0 * with_both, "{of}: {then:?}");
        assert!(with_both < 1.6, "{of}: {then:?}");
        assert!((noise - 1.0).abs() < 1e-12, "{of}: {then:?}");
    }
    assert_eq!(errors(&two, "left_out_sigma")[0], None);
    // fitted alone, the first stood for both; the study has both as they are fitted together
    assert_eq!(one["others"].as_array().unwrap().len(), 0);
    let again = &two["others"][0];
    let [alone, with_both] =
        [&one["strength"][0], &again["strength"][0]].map(|number| number.as_f64().unwrap());
    assert_eq!(again["effect"], "rod-shear-modulus");
    assert!(
        (again["before"].as_f64().unwrap() / alone - 1.0).abs() < 1e-4,
        "{again}"
    );
    assert!(
        (with_both - 0.3).abs() < 0.05 && (alone - 0.3).abs() > 0.1,
        "{again}"
    );
    let text = fs::read_to_string(folder.path().join("try/study.toml")).unwrap();
    let stands = text.parse::<toml::Table>().unwrap()["effect"][0]["strength"]
        .as_float()
        .unwrap();
    assert!((stands / with_both - 1.0).abs() < 1e-4, "{text}");
    assert_eq!(two["notes"].as_array().unwrap().len(), 0, "{}", two["notes"]);
    let group = &two["ladder"][3]["groups"][0];
    assert!(
        group["left_out"].as_f64().unwrap() >= group["rmse"].as_f64().unwrap(),
        "{group}"
    );
    let csv = fs::read_to_string(folder.path().join("output/bench-ladder/ladder.csv")).unwrap();
    for line in [
        ",all,root_mean_square,sigma,+ root-flexure,held out,",
        "rod,twist,root_mean_square,deg,uncalibrated,fitted,",
        "rod,twist,root_mean_square,deg,+ root-flexure,each case predicted from the others,0.0",
        "rod,twist,root_mean_square,deg,+ root-flexure,held out,0.0",
        "rod,twist,chi_square_per_number,1,+ rod-shear-modulus,held out,",
    ] {
        assert!(csv.contains(line), "{line}\n{csv}");
    }
    let after = json(&washout(
        folder.path(),
        &[
            "diagnose",
            "try/study.toml",
            "--effect",
            "rod-ends-early",
            "--json",
        ],
    ));
    assert_eq!(after["verdict"], "nothing", "{}", after["sentence"]);

    // what adds nothing is written, and said to add nothing
    let idle = add(&["rod-ends-early", "--output", "try/idle.toml"]);
    let notes = idle["notes"].to_string();
    assert!(notes.contains("held out does not fall"), "{notes}");
    let anew = add(&["root-flexure"]);
    assert_eq!(names(&anew)[3..5], ["+ root-flexure", "root-flexure anew"]);
    let out = add(&["rod-shear-modulus", "--remove"]);
    let rung = names(&out).iter().position(|name| name == "− rod-shear-modulus");
    let (rung, held_out) = (rung.unwrap(), errors(&out, "held_out_sigma"));
    assert!(
        held_out[rung].unwrap() > 2.0 * held_out[rung - 1].unwrap(),
        "{held_out:?}"
    );
}

#[test]
fn an_effect_of_fixed_strength_is_part_of_the_model_until_it_is_added() {
    let folder = tempfile::tempdir().unwrap();
    hidden_pair(folder.path());
    let path = folder.path().join("try/study.toml");
    let text = fs::read_to_string(&path).unwrap();
    let fixed = format!("{text}\n[[effect]]\nname = 'rod-shear-modulus'\nstrength = 0.3\n");
    fs::write(&path, fixed).unwrap();
    let arguments = ["add", "root-flexure", "--to", "try/study.toml", "--json"];
    let added = json(&washout(folder.path(), &arguments));
    assert_eq!(names(&added), ["raw", "calibrated", "+ root-flexure", "noise"]);
    let arguments = ["add", "rod-shear-modulus", "--to", "try/study.toml", "--json"];
    let added = json(&washout(folder.path(), &arguments));
    assert_eq!(
        names(&added),
        [
            "raw",
            "calibrated",
            "+ root-flexure",
            "rod-shear-modulus fitted",
            "noise"
        ]
    );
    let [value, error] = [0, 1].map(|k| added["strength"][k].as_f64().unwrap());
    assert!(
        error > 0.0 && (value - 0.3).abs() < 4.0 * error,
        "{value} {error}"
    );
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(text.matches("sigma").count(), 2, "{text}");
}

#[test]
fn an_effect_that_ends_at_nothing_predicts_as_if_it_were_not_there() {
    let folder = tempfile::tempdir().unwrap();
    hidden_pair(folder.path());
    // both that are hidden make the rod softer; this stiffens it, and can only do that
    let arguments = ["add", "warping-restraint", "--to", "try/study.toml", "--json"];
    let added = json(&washout(folder.path(), &arguments));
    assert_eq!(names(&added)[2], "+ warping-restraint");
    assert_eq!(added["strength"][0], 0.0, "{}", added["strength"]);
    for of in ["in_sample_sigma", "left_out_sigma", "held_out_sigma"] {
        let found = errors(&added, of);
        let [without, with] = [1, 2].map(|rung| found[rung].unwrap());
        assert!((with / without - 1.0).abs() < 1e-3, "{of}: {found:?}");
    }
    let arguments = [
        "diagnose",
        "try/study.toml",
        "--effect",
        "warping-restraint",
        "--effect",
        "root-flexure",
        "--json",
    ];
    let said = json(&washout(folder.path(), &arguments));
    let rows = said["effects"].as_array().unwrap().iter();
    for row in rows {
        let gain = row["gain_left_out_conditions"].as_f64().unwrap();
        let is_true = row["effect"] == "root-flexure";
        assert!(if is_true { gain > 100.0 } else { gain.abs() < 1.0 }, "{row}");
    }
}
