//! Frames of a video are marked on a page: the twist is that of `measure`, files are kept and never replaced unseen.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::live::Server;
use crate::live::saved::run;
use crate::{folder, program, washout};

const PNG: &[u8] = b"\x89PNG\r\n\x1a\nnothing more is read by the program";

/// Two frames in a folder `bench`.
fn frames(here: &Path) {
    fs::create_dir(here.join("bench")).expect("a folder");
    for name in ["rest.png", "mid-stroke.png", "notes.txt"] {
        fs::write(here.join("bench").join(name), PNG).expect("written");
    }
}

/// The clicks of `examples/video-marks.csv`.
fn clicks() -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/video-marks.csv");
    let text = fs::read_to_string(path).expect("the example");
    let rows = text
        .lines()
        .filter(|line| !line.starts_with('#') && !line.starts_with("frame"));
    rows.map(|row| {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |k: usize| cells[k].parse::<f64>().ok();
        json!({ "frame": cells[0], "r_mm": number(1), "mark": cells[2], "x_px": number(3), "y_px": number(4) })
    })
    .collect()
}

/// What a page sends once these are clicked.
fn marked(state: &Value, clicks: &[Value]) -> Value {
    let mut marks = state["marks"].clone();
    marks["video"]["rest"] = json!("rest");
    marks["video"]["view"] =
        json!({ "along": "stroke", "root_angle_deg": 45.0, "root_angle_sigma_deg": 1.0 });
    marks["clicks"] = json!(clicks);
    json!({ "revision": state["revision"], "marks": marks })
}

fn state(server: &Server) -> Value {
    server.get("api/marks").json()
}

#[test]
fn twist_grows_with_the_clicks_and_is_that_of_measure() {
    let here = folder();
    frames(here.path());
    let server = Server::start(here.path(), &["bench"]);
    let first = state(&server);
    assert_eq!(first["frames"], json!(["mid-stroke", "rest"]));
    assert_eq!(first["told"]["report"], Value::Null);
    // what is needed is said from the start
    assert_eq!(first["told"]["refusal"]["key"], "view.root_angle_deg");

    let all = clicks();
    // without the last click on a trailing edge the station does not count, and is named
    let last = all
        .iter()
        .rposition(|click| click["frame"] == "mid-stroke")
        .expect("a click");
    let (r_mm, edge) = (&all[last]["r_mm"], &all[last]["mark"]);
    let some: Vec<Value> = all
        .iter()
        .filter(|click| !(click["frame"] == "mid-stroke" && click["r_mm"] == *r_mm && click["mark"] == *edge))
        .cloned()
        .collect();
    let told = server.change("api/marks", marked(&first, &some))["told"].clone();
    assert_eq!(told["report"]["readings"].as_array().map(Vec::len), Some(4));
    assert_eq!(
        told["lacks"],
        json!([{ "frame": "mid-stroke", "r_mm": r_mm, "mark": edge }])
    );

    // one click each: the twist is there, its errors are a guess, and there is no measurement to be saved
    let mut once: Vec<Value> = Vec::new();
    for click in &all {
        let is_same = |other: &Value| {
            ["frame", "r_mm", "mark"]
                .iter()
                .all(|key| other[key] == click[key])
        };
        if !once.iter().any(is_same) {
            once.push(click.clone());
        }
    }
    let told = server.change("api/marks", marked(&state(&server), &once))["told"].clone();
    assert_eq!(told["is_assumed"], true, "{told}");
    let saved = server.change("api/save", json!({}));
    assert_eq!(saved["files"].as_array().map(Vec::len), Some(2));

    let done = server.change("api/marks", marked(&state(&server), &all));
    assert_eq!(done["is_dirty"], true);
    let saved = server.change("api/save", json!({}));
    assert_eq!(state(&server)["is_dirty"], false);
    // the measurement is that of the command
    assert_eq!(
        saved["files"],
        json!(["bench/bench.toml", "bench/bench-marks.csv", "bench/bench.csv"])
    );
    let written = fs::read(here.path().join("bench/bench.csv")).expect("written");
    let commands: Vec<Value> = saved["commands"].as_array().expect("commands")[..1].to_vec();
    run(here.path(), &json!(commands));
    assert_eq!(
        fs::read(here.path().join("bench/bench.csv")).expect("written"),
        written
    );
    let said = washout(
        here.path(),
        &["measure", "bench/bench.toml", "-o", "again.csv", "--json"],
    );
    assert_eq!(said.document()["readings"], done["told"]["report"]["readings"]);
    drop(server);

    // what was saved is there again, and saved again it is the same
    let server = Server::start(here.path(), &["bench"]);
    let again = state(&server);
    assert_eq!(again["told"], done["told"]);
    let file = here.path().join("bench/bench-marks.csv");
    let before = fs::read(&file).expect("written");
    server.change("api/save", json!({}));
    assert_eq!(fs::read(&file).expect("written"), before);

    // somebody else's change is not replaced
    fs::write(&file, "frame,r_mm,mark,x_px,y_px\n").expect("written");
    let reply = server.post("api/save", &json!({}));
    assert_eq!(reply.status, 422, "{reply:?}");
    assert!(reply.body.contains("bench-marks.csv"), "{reply:?}");
    assert_eq!(
        fs::read_to_string(&file).expect("there"),
        "frame,r_mm,mark,x_px,y_px\n"
    );
}

#[test]
fn two_windows_do_not_overwrite_each_other_and_what_is_no_mark_is_refused() {
    let here = folder();
    frames(here.path());
    let server = Server::start(here.path(), &["bench"]);
    let old = state(&server);
    server.change("api/marks", marked(&old, &clicks()));
    let late = server.post("api/marks", &marked(&old, &[]));
    assert!(
        late.status == 422 && late.body.contains("another window"),
        "{late:?}"
    );
    let now = state(&server);
    for strange in [
        json!({ "frame": "../secret", "r_mm": 1.0, "mark": "leading", "x_px": 1.0, "y_px": 1.0 }),
        json!({ "frame": "rest", "r_mm": null, "mark": "leading", "x_px": 1.0, "y_px": 1.0 }),
        json!({ "frame": "rest", "r_mm": -1.0, "mark": "leading", "x_px": 1.0, "y_px": 1.0 }),
        json!({ "frame": "rest", "r_mm": 1.0, "mark": "leading", "x_px": 1e9, "y_px": 1.0 }),
    ] {
        let reply = server.post("api/marks", &marked(&now, &[strange]));
        assert_eq!(reply.status, 422, "{reply:?}");
    }
    assert_eq!(state(&server), now);
    // where the marks are written is not for a page to say
    let mut elsewhere = marked(&now, &clicks());
    elsewhere["marks"]["video"]["marks"] = json!("../elsewhere.csv");
    server.change("api/marks", elsewhere);
    server.change("api/save", json!({}));
    assert!(!here.path().join("elsewhere.csv").exists());

    let picture = server.get("api/frame?index=0");
    assert_eq!(picture.status, 200);
    assert!(
        picture.head.contains("content-type: image/png"),
        "{}",
        picture.head
    );
    assert!(
        picture.head.contains("x-content-type-options: nosniff"),
        "{}",
        picture.head
    );
    assert_eq!(server.get("api/frame?index=2").status, 422);
    assert_eq!(server.get("api/frame?index=../1").status, 400);
    assert_eq!(server.get("api/state").status, 404);
    assert_eq!(server.post("api/frame", &json!({})).status, 405);
    let foreign = server.posted(
        &server.path("api/save"),
        "{}",
        &[("Origin", "http://example.org")],
    );
    assert_eq!(server.raw(&foreign).status, 403);
}

#[test]
fn what_cannot_be_marked_is_refused_with_its_cure() {
    let here = folder();
    fs::create_dir(here.path().join("empty")).expect("a folder");
    let said = washout(here.path(), &["live", "empty", "--no-open"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(
        said.err.contains("has no image (.png, .jpg, .jpeg)"),
        "{}",
        said.err
    );
    frames(here.path());
    let said = washout(here.path(), &["live", "bench", "--set", "a=1"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(
        said.err.contains("belongs to a design or a study"),
        "{}",
        said.err
    );
    fs::write(here.path().join("bench/bench.toml"), "format = 1\n").expect("written");
    let said = washout(here.path(), &["live", "bench", "--no-open"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("bench.toml"), "{}", said.err);
}

/// A stand-in for ffmpeg: the program is asked for frames, and says what went wrong.
#[cfg(unix)]
#[test]
fn a_video_is_cut_by_ffmpeg_if_there_is_one() {
    use std::os::unix::fs::PermissionsExt;

    let here = folder();
    let tools = here.path().join("tools");
    fs::create_dir(&tools).expect("a folder");
    fs::write(here.path().join("wing.MP4"), "a video").expect("written");
    let live = |arguments: &[&str], path: &Path| {
        let output = program(here.path())
            .arg("live")
            .args(arguments)
            .env("PATH", path)
            .output()
            .expect("the program runs");
        (
            output.status.code(),
            String::from_utf8_lossy(&output.stderr).to_string(),
        )
    };
    let (code, err) = live(&["wing.MP4", "--no-open"], &tools);
    assert_eq!(code, Some(2), "{err}");
    assert!(
        err.contains("ffmpeg cannot be started") && err.contains("Install ffmpeg"),
        "{err}"
    );

    let tool = |script: &str| {
        let path = tools.join("ffmpeg");
        fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("written");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("executable");
    };
    tool("echo 'moov atom not found' >&2; exit 1");
    let (code, err) = live(&["wing.MP4", "--no-open"], &tools);
    assert_eq!(code, Some(2), "{err}");
    assert!(err.contains("ffmpeg cannot cut it: moov atom not found"), "{err}");
    let left: Vec<String> = fs::read_dir(here.path())
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().to_string())
        .collect();
    assert_eq!(left.len(), 2, "something is left: {left:?}");

    // its last argument is the pattern of the frames
    tool(
        "for last; do :; done\nfor k in 00001 00002; do\n  printf '\\211PNG\\r\\n\\032\\n' > \"$(printf '%s' \"$last\" | sed s/%05d/$k/)\"\ndone",
    );
    let path = std::env::var("PATH").unwrap_or_default();
    let server = Server::start_with(
        here.path(),
        &["wing.MP4"],
        &[("PATH", &format!("{}:{path}", tools.display()))],
    );
    let state = state(&server);
    assert_eq!(state["frames"], json!(["frame-00001", "frame-00002"]));
    assert!(here.path().join("wing-frames/frame-00002.png").exists());
}
