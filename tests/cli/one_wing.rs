//! Effects on one wing of several, and effects that are there wholly or not at all, as a user asks for them.

use std::fs;
use std::path::{Path, PathBuf};

use crate::hidden::json;
use crate::{folder, washout};

fn study(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("studies").join(name)
}

/// A shipped study beside its designs and measurements, to be written over.
fn copied(into: &Path, name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(study(name)).unwrap();
    let shipped = root.display().to_string();
    let path = into.join(name);
    fs::write(&path, text.replace("\"../", &format!("\"{shipped}/"))).unwrap();
    path
}

#[test]
fn a_wing_that_is_not_there_is_refused_with_those_that_are() {
    let here = folder();
    let path = study("pre-pazy-both.toml").display().to_string();
    let said = washout(here.path(), &["diagnose", &path, "--on", "pre-pazy-skined"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    for words in ["--on", "pre-pazy-skined", "did you mean pre-pazy-skinned"] {
        assert!(said.err.contains(words), "{}", said.err);
    }
    let own = copied(here.path(), "pre-pazy-both.toml");
    let text = fs::read_to_string(&own).unwrap();
    fs::write(
        &own,
        text.replace(
            "candidates_on = [\"pre-pazy-skinned\"]",
            "candidates_on = [\"mine\"]",
        ),
    )
    .unwrap();
    let said = washout(here.path(), &["diagnose", "pre-pazy-both.toml"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    for words in ["candidates_on", "no case has a design mine", "pre-pazy-skinned"] {
        assert!(said.err.contains(words), "{}", said.err);
    }
}

/// The option has the last word: effects of the bare wing are seen in its own readings alone.
#[test]
fn effects_are_tried_on_the_wing_that_is_asked_for() {
    let here = folder();
    let path = study("pre-pazy-both.toml").display().to_string();
    // which readings are asked does not hang on the mesh
    let coarse = ["--set", "mesh.refine=0.25"];
    let arguments = [
        &["diagnose", &path, "--effect", "skin-bending", "--json"],
        &coarse[..],
        &["--on"],
    ]
    .concat();
    let strength = |wing: &str| {
        let said = json(&washout(here.path(), &[&arguments[..], &[wing]].concat()));
        assert!(
            said["notes"]
                .to_string()
                .contains(&format!("tried on {wing} alone"))
        );
        let row = &said["effects"][0];
        row["one_step"].as_f64().unwrap()
    };
    // what makes the one wing stiffer would make the other softer
    assert!(strength("pre-pazy-skinned") > 0.1 && strength("pre-pazy") < 0.0);
}

#[test]
fn an_effect_that_is_added_stays_on_the_wings_that_the_study_tries_it_on() {
    let here = folder();
    copied(here.path(), "pre-pazy-both.toml");
    let add = ["add", "skin-bending", "--to", "pre-pazy-both.toml", "--json"];
    let added = json(&washout(here.path(), &add));
    assert!(
        (added["strength"][0].as_f64().unwrap() - 0.19).abs() < 0.02,
        "{}",
        added["strength"]
    );
    let text = fs::read_to_string(here.path().join("pre-pazy-both.toml")).unwrap();
    assert!(text.contains("designs = [\"pre-pazy-skinned\"]"), "{text}");
}

#[test]
fn what_is_all_or_none_is_added_whole_has_its_rung_and_goes_again() {
    let here = folder();
    let path = copied(here.path(), "tang-dowell-linear.toml");
    let before = fs::read_to_string(&path).unwrap();
    let add = [
        "add",
        "large-rotation",
        "--to",
        "tang-dowell-linear.toml",
        "--json",
    ];
    let added = json(&washout(here.path(), &add));
    assert_eq!(added["strength"], serde_json::json!([1.0, 0.0]));
    let table = fs::read_to_string(&path).unwrap();
    let table = table.split("[[effect]]").nth(1).unwrap();
    assert!(
        table.contains("strength = 1.0") && !table.contains("sigma"),
        "{table}"
    );
    // once more: it has a step of its own now
    let again = json(&washout(here.path(), &add));
    let rungs: Vec<&str> = again["ladder"]
        .as_array()
        .unwrap()
        .iter()
        .map(|r| r["name"].as_str().unwrap())
        .collect();
    assert!(rungs.contains(&"+ large-rotation"), "{rungs:?}");
    json(&washout(here.path(), &[&add[..], &["--remove"]].concat()));
    assert_eq!(fs::read_to_string(&path).unwrap().trim(), before.trim());
}

#[test]
fn an_effect_that_is_not_there_is_refused_before_the_study_is_read() {
    let here = folder();
    let said = washout(here.path(), &["add", "skin-bendin", "--to", "no-such.toml"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("did you mean skin-bending"), "{}", said.err);
}

/// A split rod of one wing, which all experiments that are listed are on.
#[test]
fn an_effect_on_one_wing_is_foretold_for_experiments_on_it_alone() {
    let here = folder();
    let study = copied(here.path(), "three-rods.toml");
    let text = fs::read_to_string(&study).unwrap();
    let mut parts = text.split("[[experiment]]");
    let cases = parts.next().unwrap().to_string();
    let torque = parts.find(|part| part.contains("torque-v1")).unwrap();
    assert!(torque.contains("twist-v1.toml"));
    fs::write(&study, format!("{cases}[[experiment]]{torque}")).unwrap();
    let hidden = [
        "--effect",
        "rod-split@twist-v1=0.25",
        "--seed",
        "5",
        "--output",
        "try",
    ];
    json(&washout(
        here.path(),
        &[&["synthesize", "three-rods.toml", "--json"], &hidden[..]].concat(),
    ));
    let tried = [
        "--effect",
        "rod-split",
        "--effect",
        "root-flexure",
        "--effect",
        "tip-loss-prandtl",
    ];
    let said = json(&washout(
        here.path(),
        &[&["diagnose", "try/three-rods.toml", "--json"], &tried[..]].concat(),
    ));
    let apart = &said["next_experiment"]["candidates"][0]["separation_sigma"];
    assert!(apart.as_f64().unwrap() > 1.0, "{}", said["next_experiment"]);
}
