//! What it would take to explain a few readings: sets of changes, each of which gives by hand what it claims.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::hidden::{campaign, json};
use crate::washout;

/// Six twists of a rod on the bench, `factor` times those of the model as it stands; sigma 0.01 deg.
fn bench(folder: &Path, factor: f64) {
    campaign(folder, &[50, 100]);
    let gj = 80e9 * std::f64::consts::PI / 32.0 * 1e-12;
    let mut rows =
        String::from("case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n");
    for moment in 1..=3 {
        for r_mm in [50, 100] {
            let twist = factor * 1e-3 * f64::from(moment) / gj * 1e-3 * f64::from(r_mm);
            rows.push_str(&format!(
                "m-{moment},twist,chord_rotation,deg,washout,,{r_mm},,{},0.01,stated,none\n",
                twist.to_degrees()
            ));
        }
    }
    fs::write(folder.join("m.csv"), rows).unwrap();
}

fn explained(folder: &Path, more: &[&str]) -> Value {
    json(&washout(
        folder,
        &[&["explain", "study.toml", "--json", "--output", "out"], more].concat(),
    ))
}

#[test]
fn where_nothing_is_off_nothing_needs_to_change() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path(), 1.0);
    let found = explained(folder.path(), &[]);
    assert_eq!(found["kind"], "explain");
    assert_eq!(
        (&found["sets"][0]["name"], &found["sets"][0]["status"]),
        (&"nothing".into(), &"reaches".into())
    );
    assert!(
        found["sentence"]
            .as_str()
            .unwrap()
            .starts_with("Nothing needs to change")
    );
    assert!(folder.path().join("out/explain.txt").is_file());
}

#[test]
fn a_set_run_again_by_hand_gives_the_readings_that_it_claims() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path(), 1.25);
    let found = explained(folder.path(), &[]);
    let first = &found["sets"][0];
    assert_eq!(
        first["changes"][0]["name"], "rod-shear-modulus",
        "{}",
        found["sentence"]
    );
    assert_eq!(first["changes"].as_array().unwrap().len(), 1);
    assert_eq!(first["status"], "reaches");
    assert!(first["probability"].as_f64().unwrap() > 0.5);
    let mut checked = 0;
    for set in found["sets"].as_array().unwrap() {
        for (command, case) in set["by_hand"]
            .as_array()
            .unwrap()
            .iter()
            .zip(["m-1", "m-2", "m-3"])
        {
            let words = command.as_str().unwrap().replace('\'', "");
            let words: Vec<&str> = split(&words);
            let by_hand = json(&washout(
                folder.path(),
                &[&words[1..], &["--json", "--output", case]].concat(),
            ));
            let rows = by_hand["comparison"]["rows"].as_array().unwrap();
            let claimed = set["readings"]
                .as_array()
                .unwrap()
                .iter()
                .filter(|own| own["case"] == case);
            for (claimed, row) in claimed.zip(rows) {
                let [a, b] = [&claimed["with_set"], &row["modelled"]].map(|own| own.as_f64().unwrap());
                assert!((a - b).abs() < 1e-6 * b.abs(), "{command}: {a} {b}");
                checked += 1;
            }
        }
    }
    assert!(checked >= 12, "{checked}");
    let refuting = first["refute"].as_array().unwrap();
    assert!(!refuting.is_empty());
}

/// Words of a command, a set with spaces in brackets being one.
fn split(command: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let (mut start, mut depth) = (0, 0);
    for (place, letter) in command.char_indices() {
        match letter {
            '[' => depth += 1,
            ']' => depth -= 1,
            ' ' if depth == 0 => {
                words.push(&command[start..place]);
                start = place + 1;
            }
            _ => {}
        }
    }
    words.push(&command[start..]);
    words
}

#[test]
fn what_does_not_fit_is_refused_with_its_place_and_cure() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path(), 1.0);
    let path = folder.path().join("study.toml");
    let text = fs::read_to_string(&path).unwrap();
    let cases = [
        ("[[alternative]]\nname = 'a'\n", "probability"),
        (
            "[[alternative]]\nname = 'a'\nprobability = 1.5\n",
            "alternative[0].probability",
        ),
        (
            "[[alternative]]\nname = 'a'\nprobability = 0.5\ncase = [{ measured = 'other', design = 'rod.toml' }]\n",
            "alternative[0].case[0].measured",
        ),
    ];
    for (more, place) in cases {
        fs::write(&path, format!("{text}{more}")).unwrap();
        let said = washout(folder.path(), &["explain", "study.toml"]);
        assert_eq!(said.code, Some(2), "{}", said.err);
        assert!(said.err.contains(place), "{}", said.err);
    }
    let said = washout(folder.path(), &["explain", "study.toml", "--effect", "no-such"]);
    assert_eq!(said.code, Some(2));
    let said = washout(folder.path(), &["explain", "study.toml", "--most", "5"]);
    assert_eq!(said.code, Some(2));
}
