//! A table dropped on the page, and a page that is sent to others.

use std::fs;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use crate::live::Server;
use crate::live::saved::run;
use crate::{contents, design, entries, folder, washout};

const SHEET: &str = "r (mm);22 Hz, 30 deg;23 Hz, 34 deg\n20;4,4;5,5\n40;8,7;10,8\n60;19,0;21,5\n";

/// The design of a wing with what it names.
fn wing(here: &Path) {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR"));
    fs::create_dir(here.join("designs")).expect("a folder");
    for name in ["materials.toml", "twist-v2.toml"] {
        let text = fs::read_to_string(shipped.join("designs").join(name)).expect("a design");
        let (own, _) = text.split_once("[measured]").unwrap_or((&text, ""));
        fs::write(here.join("designs").join(name), own).expect("written");
    }
}

#[test]
fn a_table_becomes_a_study_once_it_is_confirmed_and_is_saved_as_init_would() {
    let (here, there) = (folder(), folder());
    wing(here.path());
    wing(there.path());
    let server = Server::start(
        here.path(),
        &["designs/twist-v2.toml", "--set", "mesh.refine=0.3"],
    );
    let dropped = json!({"name": "sheet.csv", "base64": STANDARD.encode(SHEET)});
    let read = server.change("api/table", dropped);
    let understood = read["understood"].as_str().expect("words");
    assert!(
        understood.contains("designs/sheet.csv") && understood.contains("22 Hz"),
        "{understood}"
    );
    assert_eq!(read["rows"].as_array().map(Vec::len), Some(7));
    assert_eq!(server.state()["of"], "design");
    assert_eq!(
        server.post("api/table/confirm", &json!({"ticket": "0"})).status,
        422
    );
    let state = server.change("api/table/confirm", json!({"ticket": read["ticket"]}));
    assert_eq!(
        (&state["of"], state["cases"].as_array().map(Vec::len)),
        (&json!("study"), Some(2))
    );
    let shape = server.settled();
    assert_eq!(shape["count"], json!(3));
    assert_eq!(
        entries(&here.path().join("designs")).len(),
        2,
        "nothing is written yet"
    );
    let saved = server.change("api/save", json!({}));
    fs::write(there.path().join("designs/sheet.csv"), SHEET).expect("written");
    run(there.path(), &saved["commands"]);
    for folder in ["designs", "output/twist-v2-sheet-live"] {
        let both = [&here, &there].map(|at| contents(&at.path().join(folder)));
        assert!(both[0] == both[1], "{folder} differs");
    }
    // saved once, the study stands there, and is saved again without the table
    let state = server.change("api/set", json!({"values": {"material.carbon-rod.g_gpa": 4.5}}));
    let commands = state["save"]["commands"].as_array().expect("commands");
    assert_eq!(commands.len(), 1);
    assert!(
        commands[0]
            .as_str()
            .expect("words")
            .starts_with("washout compare "),
        "{commands:?}"
    );
}

#[test]
fn what_is_no_table_is_refused_with_its_place() {
    let here = folder();
    wing(here.path());
    let server = Server::start(here.path(), &["designs/twist-v2.toml"]);
    let table = |name: &str, text: &str| {
        let reply = server.post(
            "api/table",
            &json!({"name": name, "base64": STANDARD.encode(text)}),
        );
        assert_eq!(reply.status, 422, "{name}: {reply:?}");
        reply.json()["error"]["message"]
            .as_str()
            .expect("words")
            .to_string()
    };
    assert!(table("../sheet.csv", SHEET).contains("drop a table"));
    let message = table("sheet.csv", "r (mm);22 Hz\n20;much\n");
    assert!(
        message.contains("sheet.csv") && !message.contains("/tmp"),
        "{message}"
    );
    assert_eq!(
        server
            .post("api/table", &json!({"name": "a.csv", "base64": "%%"}))
            .status,
        400
    );
    for (name, text) in [("other.toml", "x = 1"), ("../designs/twist-v2.toml", "")] {
        assert_eq!(
            server
                .post("api/open", &json!({"name": name, "text": text}))
                .status,
            422
        );
    }
    let text = fs::read_to_string(here.path().join("designs/twist-v2.toml")).expect("a design");
    let state = server.change("api/open", json!({"name": "twist-v2.toml", "text": text}));
    assert_eq!(
        (&state["name"], &state["undo"]),
        (&json!("twist-v2"), &Value::Null)
    );
    assert_eq!(entries(here.path()), ["designs"]);
}

#[test]
fn a_page_for_others_holds_the_wings_that_solve_gives() {
    let here = folder();
    let file = design("twist-v2.toml");
    let over = "flapping.frequency_hz,root-flexure";
    let arguments = [
        "live",
        &file,
        "--set",
        "mesh.refine=0.3",
        "--export",
        "page.html",
        "--over",
        over,
    ];
    let said = washout(here.path(), &arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let page = fs::read_to_string(here.path().join("page.html")).expect("a page");
    assert!(page.len() < 5_000_000, "{}", page.len());
    let grid = page
        .split("id=\"grid\">")
        .nth(1)
        .expect("a grid")
        .split("</script>")
        .next()
        .expect("an end");
    let grid: Value = serde_json::from_str(grid).expect("JSON");
    let axis = |place: usize| grid["axes"][place]["values"].as_array().expect("places");
    let (frequencies, strengths) = (axis(0), axis(1));
    let points = grid["points"].as_array().expect("points");
    assert_eq!(points.len(), frequencies.len() * strengths.len());
    assert!(frequencies.contains(&json!(23.0)) && strengths.contains(&json!(0.0)));
    let (row, column) = (2, 3);
    let point = &points[row * strengths.len() + column];
    let sets = [
        format!("flapping.frequency_hz={}", frequencies[row]),
        format!("effects.root-flexure.strength={}", strengths[column]),
    ];
    let solved = washout(
        here.path(),
        &[
            "solve",
            &file,
            "--json",
            "--set",
            "mesh.refine=0.3",
            "--set",
            &sets[0],
            "--set",
            &sets[1],
        ],
    );
    assert_eq!(
        solved.document()["tip"]["twist_deg"],
        point["numbers"][0],
        "{}",
        solved.err
    );
    // it stands there now, and is not replaced
    assert_eq!(washout(here.path(), &arguments).code, Some(2));
    for (over, words) in [
        ("no.such", "no input"),
        ("spar[1].at_mm", "mesh"),
        ("a,b,c,d", "one to three"),
    ] {
        let said = washout(
            here.path(),
            &[
                "live",
                &file,
                "--set",
                "mesh.refine=0.3",
                "--export",
                "x.html",
                "--over",
                over,
            ],
        );
        assert_eq!(said.code, Some(2), "{over}: {}", said.err);
        assert!(said.err.contains(words), "{over}: {}", said.err);
    }
}
