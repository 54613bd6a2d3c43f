//! What is missing, asked, added and saved: files are those of the commands, byte for byte.

use std::path::Path;

use serde_json::{Value, json};

use crate::live::Server;
use crate::{contents, design, folder, washout};

/// A campaign with a hidden effect and five that may be it, in a folder.
fn campaign(here: &Path) {
    let study = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies/three-rods.toml");
    let study = study.to_str().expect("UTF-8");
    let arguments = [
        "synthesize",
        study,
        "--effect",
        "root-flexure=0.2",
        "--seed",
        "7",
        "--output",
        "try",
        "-q",
    ];
    assert_eq!(washout(here, &arguments).code, Some(0));
    let study = here.join("try/three-rods.toml");
    let text = std::fs::read_to_string(&study).expect("the study");
    let tried = "candidates = ['root-flexure', 'stop-backlash', 'warping-restraint', 'tip-loss-prandtl', 'inflow-uniform']\n";
    std::fs::write(&study, format!("{tried}{text}")).expect("written");
}

/// Runs commands as they were given.
pub fn run(here: &Path, commands: &Value) {
    for command in commands.as_array().expect("commands") {
        let words: Vec<&str> = command.as_str().expect("words").split(' ').skip(1).collect();
        let words: Vec<&str> = words.into_iter().map(|word| word.trim_matches('\'')).collect();
        let said = washout(here, &words);
        assert_eq!(said.code, Some(0), "{command}: {}", said.err);
    }
}

fn answer(server: &Server) -> Value {
    let mut after = 0;
    for _ in 0..1000 {
        let reply = server.get(&format!("api/diagnosis?after={after}&wait=20"));
        if reply.status == 204 {
            continue;
        }
        let told = reply.json();
        after = told["serial"].as_u64().expect("a number");
        assert_eq!(told["error"], Value::Null, "{told}");
        if told["running"] == json!(false) && !told["answer"].is_null() {
            return told["answer"].clone();
        }
    }
    panic!("no answer")
}

/// Names of the steps of the ladder, and their errors in deg.
fn ladder(server: &Server, steps: usize) -> Vec<(String, f64)> {
    server.shape_where(|_| {
        server.state()["ladder"]
            .as_array()
            .is_some_and(|ladder| ladder.len() == steps)
    });
    let state = server.state();
    let rungs = state["ladder"].as_array().expect("a ladder").iter();
    rungs
        .map(|rung| {
            let label = rung["label"].as_str().expect("a name").to_string();
            (label, rung["rms_deg"].as_f64().expect("a number"))
        })
        .collect()
}

#[test]
fn a_hidden_effect_is_found_added_undone_redone_and_saved_as_the_commands_would() {
    let (here, there) = (folder(), folder());
    campaign(here.path());
    campaign(there.path());
    let server = Server::start(here.path(), &["try/three-rods.toml"]);
    let before = ladder(&server, 2);
    assert_eq!(server.post("api/diagnose", &json!({})).status, 200);
    let answer = answer(&server);
    assert_eq!(answer["verdict"], "effect");
    assert_eq!(answer["hypotheses"][0]["effects"], json!(["root-flexure"]));
    let curve = server.get("api/hypothesis?index=0").json();
    assert!(
        curve["twist_deg"]
            .as_array()
            .is_some_and(|twists| twists.len() > 20)
    );
    let state = server.change("api/add", json!({"hypothesis": 0}));
    assert_eq!(state["undo"], "+ root flexure");
    let after = ladder(&server, 3);
    assert_eq!(after[2].0, "+ root-flexure");
    let noise = server.state()["noise_deg"].as_f64().expect("noise");
    assert!(
        before[0].1 > 5.0 * noise && before[1].1 > 1.5 * noise,
        "{before:?} {noise}"
    );
    assert!(after[2].1 < 1.2 * noise, "{after:?} {noise}");
    assert_eq!(server.change("api/undo", json!({}))["redo"], "+ root flexure");
    assert_eq!(ladder(&server, 2), before);
    server.change("api/redo", json!({}));
    assert_eq!(ladder(&server, 3), after);
    let saved = server.change("api/save", json!({}));
    assert_eq!(server.state()["dirty"], json!(false));
    run(there.path(), &saved["commands"]);
    for folder in ["try", "output/three-rods-ladder", "output/three-rods-live"] {
        let both = [&here, &there].map(|at| contents(&at.path().join(folder)));
        assert!(both[0] == both[1], "{folder} differs");
        assert!(!both[0].is_empty());
    }
    assert!(here.path().join("try/three-rods-live.toml").is_file());
}

#[test]
fn a_design_that_was_moved_is_saved_as_solve_would() {
    let (here, there) = (folder(), folder());
    let server = Server::start(
        here.path(),
        &[&design("twist-v2.toml"), "--set", "mesh.refine=0.4"],
    );
    server.change(
        "api/set",
        json!({"values": {"rod[0].to_mm": 35.0, "flapping.frequency_hz": 24.25}}),
    );
    server.change("api/effect", json!({"name": "root-flexure", "value": 0.1}));
    let saved = server.change("api/save", json!({}));
    assert_eq!(saved["commands"], server.state()["save"]["commands"]);
    run(there.path(), &saved["commands"]);
    let both = [&here, &there].map(|at| contents(&at.path().join("output/twist-v2-live")));
    assert!(both[0] == both[1]);
    let names: Vec<&str> = both[0].iter().map(|(name, _)| name.as_str()).collect();
    assert!(
        names.contains(&"report.html") && names.contains(&"summary.json"),
        "{names:?}"
    );
}

#[test]
fn a_study_moved_by_hand_is_saved_as_the_commands_would() {
    let (here, there) = (folder(), folder());
    campaign(here.path());
    campaign(there.path());
    let server = Server::start(here.path(), &["try/three-rods.toml"]);
    server.change("api/set", json!({"values": {"material.carbon-rod.g_gpa": 4.25}}));
    for (effect, strength) in [
        ("root-flexure", json!(0.15)),
        ("tip-loss-prandtl", json!(0.5)),
        ("root-flexure", json!(0.2)),
    ] {
        server.change("api/effect", json!({"name": effect, "value": strength}));
    }
    server.change("api/effect", json!({"name": "tip-loss-prandtl", "value": null}));
    let saved = server.change("api/save", json!({}));
    run(there.path(), &saved["commands"]);
    for folder in ["try", "output/three-rods-live"] {
        let both = [&here, &there].map(|at| contents(&at.path().join(folder)));
        assert!(both[0] == both[1], "{folder} differs");
    }
    // and the shape that was shown is the one of the study that was saved
    let shown = server.settled();
    let again = Server::start(
        here.path(),
        &[
            "try/three-rods-live.toml",
            "--set",
            "material.carbon-rod.g_gpa=4.25",
        ],
    );
    assert_eq!(again.settled()["twist"]["twist_deg"], shown["twist"]["twist_deg"]);
}
