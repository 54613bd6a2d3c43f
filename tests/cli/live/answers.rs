//! What the page is told: the state, the shape after each move, refusals at their place, undo and redo.

use serde_json::{Value, json};

use crate::live::Server;
use crate::{design, entries, folder, washout};

const COARSE: [&str; 2] = ["--set", "mesh.refine=0.4"];

fn value(state: &Value, key: &str) -> f64 {
    let inputs = state["inputs"].as_array().expect("inputs");
    let own = inputs.iter().find(|input| input["key"] == key);
    own.unwrap_or_else(|| panic!("no input {key}"))["value"]
        .as_f64()
        .expect("a number")
}

fn tip(shape: &Value) -> f64 {
    let numbers = shape["numbers"].as_array().expect("numbers");
    let tip = numbers.iter().find(|number| number["key"] == "tip_twist_deg");
    tip.expect("a tip")["value"].as_f64().expect("a number")
}

#[test]
fn a_move_gives_the_shape_that_solve_gives_bit_for_bit() {
    let here = folder();
    let file = design("twist-v2.toml");
    let server = Server::start(here.path(), &[&file, COARSE[0], COARSE[1]]);
    let first = server.settled();
    let state = server.change(
        "api/set",
        json!({"values": {"flapping.frequency_hz": 25.5, "rod[0].to_mm": 35.0}}),
    );
    assert_eq!(value(&state, "flapping.frequency_hz"), 25.5);
    assert_eq!(state["dirty"], json!(true));
    let shape = server.settled();
    assert_ne!(tip(&shape), tip(&first));
    let sets = [
        "flapping.frequency_hz=25.5",
        "rod[0].to_mm=35",
        "rod[1].from_mm=35",
        "mesh.refine=0.4",
    ];
    let sets: Vec<&str> = sets.iter().flat_map(|set| ["--set", *set]).collect();
    let said = washout(here.path(), &[&["solve", &file, "--json"], &sets[..]].concat());
    assert_eq!(
        said.document()["tip"]["twist_deg"].as_f64(),
        Some(tip(&shape)),
        "{}",
        said.err
    );
    assert!(
        shape["wing"]["loaded"]
            .as_array()
            .is_some_and(|points| points.len() > 100)
    );
    assert_eq!(shape["solved"], json!(true));
    let complete = server.shape_where(|shape| !shape["mesh_error_deg"].is_null());
    assert!(complete["mesh_error_deg"].as_f64() > Some(0.0));
    assert!(complete["twist"]["other"]["twist_deg"].is_array());
}

#[test]
fn moves_are_undone_and_done_again_and_a_gesture_is_one_step() {
    let here = folder();
    let server = Server::start(here.path(), &[&design("twist-v1.toml"), COARSE[0], COARSE[1]]);
    let key = "flapping.half_amplitude_deg";
    let first = server.settled();
    for (at, drag) in [(35.0, true), (36.0, true), (37.0, true), (37.0, false)] {
        server.change("api/set", json!({"values": {key: at}, "drag": drag}));
    }
    let state = server.change("api/effect", json!({"name": "root-flexure", "value": 0.2}));
    assert_eq!(state["undo"], "root flexure none → 0.2");
    let state = server.change("api/undo", json!({}));
    assert_eq!(value(&state, key), 37.0);
    assert!(
        state["undo"].as_str().expect("words").ends_with("34.5 → 37 deg"),
        "{}",
        state["undo"]
    );
    let state = server.change("api/undo", json!({}));
    assert_eq!(
        (value(&state, key), &state["undo"], &state["dirty"]),
        (34.5, &Value::Null, &json!(false))
    );
    assert_eq!(tip(&server.settled()), tip(&first));
    assert_eq!(server.post("api/undo", &json!({})).status, 422);
    server.change("api/redo", json!({}));
    let state = server.change("api/redo", json!({}));
    assert_eq!(state["redo"], Value::Null);
    let effects = state["effects"].as_array().expect("effects");
    let own = effects
        .iter()
        .find(|effect| effect["name"] == "root-flexure")
        .expect("an effect");
    assert_eq!(own["value"], json!(0.2));
    let state = server.change("api/reset", json!({}));
    assert_eq!(value(&state, key), 34.5);
    assert_eq!(
        server.change("api/undo", json!({}))["undo"],
        "root flexure none → 0.2"
    );
}

#[test]
fn a_value_that_cannot_be_is_refused_at_its_key_and_nothing_changes() {
    let here = folder();
    let server = Server::start(here.path(), &[&design("twist-v2.toml"), COARSE[0], COARSE[1]]);
    for (path, body, key, words) in [
        (
            "api/set",
            json!({"values": {"flapping.frequency_hz": -3}}),
            "flapping.frequency_hz",
            "0.1 … 1000 Hz",
        ),
        ("api/set", json!({"values": {"rod[0].to_mm": 90}}), "rod[", ""),
        (
            "api/set",
            json!({"values": {"no.such": 1}}),
            "no.such",
            "no input",
        ),
        (
            "api/effect",
            json!({"name": "no-such", "value": 1}),
            "no-such",
            "no such effect",
        ),
        (
            "api/effect",
            json!({"name": "root-flexure", "value": -1}),
            "root-flexure",
            "0 … 1000",
        ),
    ] {
        let reply = server.post(path, &body);
        assert_eq!(reply.status, 422, "{body}: {reply:?}");
        let error = &reply.json()["error"];
        assert!(error["key"].as_str().expect("a key").starts_with(key), "{error}");
        assert!(
            error["message"].as_str().expect("words").contains(words),
            "{error}"
        );
    }
    assert_eq!(server.post("api/case", &json!({"case": 1})).status, 422);
    assert_eq!(server.post("api/add", &json!({"hypothesis": 0})).status, 422);
    assert_eq!(server.state()["revision"], 1);
}

#[test]
fn a_wing_without_a_shape_says_so_and_keeps_the_last_one() {
    let here = folder();
    let server = Server::start(here.path(), &[&design("twist-v2.toml"), COARSE[0], COARSE[1]]);
    let before = server.settled();
    server.change("api/set", json!({"values": {"flapping.frequency_hz": 400}}));
    let shape = server.settled();
    assert_eq!(shape["solved"], json!(false), "{}", shape["numbers"]);
    assert!(shape["refusal"]["message"].as_str().expect("words").len() > 20);
    assert_eq!(shape["wing"], before["wing"]);
    server.change("api/undo", json!({}));
    assert_eq!(server.settled()["solved"], json!(true));
}

#[test]
fn ctrl_c_ends_it_with_0_and_nothing_is_written() {
    let here = folder();
    let server = Server::start(here.path(), &[&design("twist-v1.toml"), COARSE[0], COARSE[1]]);
    server.change("api/set", json!({"values": {"flapping.frequency_hz": 24}}));
    let (code, said) = server.interrupted();
    assert_eq!((code, said.as_str()), (Some(0), ""));
    assert_eq!(entries(here.path()), [""; 0]);
}

#[test]
fn a_file_that_is_refused_ends_it_with_2() {
    let here = folder();
    let said = washout(here.path(), &["live", "no-such.toml", "--no-open"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("no-such.toml"), "{}", said.err);
    let said = washout(
        here.path(),
        &[
            "live",
            &design("twist-v1.toml"),
            "--no-open",
            "--set",
            "flapping.frequency_hz=-3",
        ],
    );
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("0.1 … 1000 Hz"), "{}", said.err);
}
