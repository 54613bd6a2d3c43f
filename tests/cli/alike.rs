//! Which effects look alike: by what they may do, and by what explains the readings.

use std::fs;
use std::path::Path;

use washout::blind::{Blind, Ranges, spot::Spot, twin};
use washout::input::study::LoadedStudy;
use washout::progress::Progress;
use washout::synthesize::Hidden;

use crate::hidden::{MANY, campaign, json};
use crate::washout;

/// Stations at which a rod that turns at its root is hardly told from a softer one.
const TIP: [u32; 3] = [98, 99, 100];

/// Lets a study try other effects.
fn candidates(folder: &Path, names: &str) {
    let study = fs::read_to_string(folder.join("study.toml")).unwrap();
    let study = study.replace("'rod-shear-modulus', 'root-flexure'", names);
    fs::write(folder.join("study.toml"), study).unwrap();
}

/// θ = T/GJ (r + s L) at a soft root, T/GJ (r − s) beyond a clamp that stops warping: read near the tip, one is the other with the sign
/// turned, and neither has another sign.
#[test]
fn effects_of_one_sign_that_turn_the_wing_opposite_ways_are_no_look_alikes() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &TIP);
    candidates(folder.path(), "'warping-restraint', 'root-flexure'");
    let plan = json(&washout(
        folder.path(),
        &["diagnose", "study.toml", "--plan", "--json"],
    ));
    for effect in plan["effects"].as_array().unwrap() {
        assert_eq!(effect["confused_with"].as_array().unwrap().len(), 0, "{effect}");
    }
    let made = washout(
        folder.path(),
        &[
            "synthesize",
            "study.toml",
            "--effect",
            "root-flexure=0.2",
            "--output",
            "try",
        ],
    );
    assert_eq!(made.code, Some(0), "{}", made.err);
    let said = json(&washout(folder.path(), &["diagnose", "try/study.toml", "--json"]));
    assert_eq!(said["verdict"], "effect", "{}", said["sentence"]);
    assert_eq!(said["hypotheses"][0]["effects"][0], "root-flexure");
    for row in said["effects"].as_array().unwrap() {
        assert_eq!(row["look_alikes"].as_array().unwrap().len(), 0, "{row}");
    }
}

/// A soft root and a soft rod: s L added to r, or r taken 1 + s times; near the tip, where r is nearly L, these are the same.
#[test]
fn a_twin_is_what_explains_the_readings_of_another_effect_as_well() {
    let apart = |stations: &[u32]| {
        let folder = tempfile::tempdir().unwrap();
        campaign(folder.path(), stations);
        let study = LoadedStudy::load_planned(&folder.path().join("study.toml"), &[]).unwrap();
        let names = vec!["rod-shear-modulus", "root-flexure"];
        let quiet = Progress::quiet();
        let ranges = Ranges {
            detectable: [5.0, 25.0],
            background: [0.01, 0.03],
        };
        let blind = Blind::new(&study, names, ranges, Some(Vec::new()), &quiet).unwrap();
        let spot = Spot::of(&blind.campaign, &Hidden::known("root-flexure", 0.2)).unwrap();
        twin::apart(&blind, spot, 0.2, &quiet).unwrap()
    };
    let (near, far) = (apart(&TIP), apart(&MANY));
    println!("apart: {near:.2} sigma by the tip, {far:.1} by the whole rod");
    assert!(near < 1.0 && far > 5.0, "{near} {far}");
}

#[test]
fn an_effect_that_is_to_be_hidden_twice_on_one_wing_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    let twice = [
        "synthesize",
        "study.toml",
        "--effect",
        "root-flexure=0.2",
        "--effect",
        "root-flexure=0.3",
        "--output",
        "try",
    ];
    let refused = washout(folder.path(), &twice);
    assert_eq!(refused.code, Some(2), "{}", refused.out);
    assert!(
        refused.err.contains("root-flexure: is to be hidden twice"),
        "{}",
        refused.err
    );
    assert!(!folder.path().join("try").exists());
}
