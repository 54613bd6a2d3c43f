//! `washout check`: a run that is what it says it is, and runs that are not.

use std::fs;
use std::path::Path;

use crate::{Said, conforms, contents, design, folder, schema, washout};

fn solved(here: &Path, output: &str, more: &[&str]) {
    let wing = here.join("wing.toml").display().to_string();
    let said = washout(
        here,
        &[&["solve", &wing, "--refine", "0.2", "--output", output], more].concat(),
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
}

/// A folder with a wing of its own.
fn with_wing() -> tempfile::TempDir {
    let here = folder();
    for name in ["twist-v2.toml", "materials.toml"] {
        let to = if name == "twist-v2.toml" {
            "wing.toml"
        } else {
            name
        };
        let text = fs::read_to_string(design(name)).expect("a design");
        // the measurement stands elsewhere
        let (start, rest) = text.split_once("[measured]").unwrap_or((&text, ""));
        let rest = rest.find("\n[").map_or("", |end| &rest[end..]);
        fs::write(here.path().join(to), format!("{start}{rest}")).expect("written");
    }
    here
}

fn says(said: &Said, code: i32, words: &[&str]) {
    assert_eq!(said.code, Some(code), "{}{}", said.out, said.err);
    for words in words {
        assert!(said.out.contains(words), "{words:?} is not in\n{}", said.out);
    }
}

#[test]
fn a_run_as_it_was_written_holds_and_its_shape_meets_the_equations() {
    let here = with_wing();
    let turned = ["--set", "root.pitch_stiffness_n_m_per_rad=0.01"];
    let linear = ["--set", "structure.kinematics=linear"];
    let tight = ["--set", "film.pretension_n_per_m=2"];
    for more in [&[][..], &turned, &linear, &tight] {
        solved(here.path(), "run", more);
        let before = contents(&here.path().join("run"));
        let said = washout(here.path(), &["check", "run"]);
        says(
            &said,
            0,
            &[
                "run: Everything that was checked holds.",
                "6 of 6 unchanged",
                "2 of 2 unchanged",
                "this program",
            ],
        );
        let said = washout(here.path(), &["check", "run", "--json"]);
        let document = said.document();
        conforms(&document, &schema(&["--output", "check"]));
        let balance = &document["balance"];
        for left in [
            "residual",
            "force_left",
            "moment_left",
            "work_left",
            "twist_change_deg",
        ] {
            let left = balance[left].as_f64().expect("a number");
            assert!(left < 1e-6, "{more:?}: {balance}");
        }
        assert!(balance["load_work_mj"].as_f64() > Some(0.01), "{balance}");
        assert_eq!(contents(&here.path().join("run")), before);
    }
}

#[test]
fn what_was_changed_or_taken_away_since_is_named() {
    let here = with_wing();
    solved(here.path(), "run", &[]);
    let run = here.path().join("run");
    let wing = here.path().join("wing.toml");
    let text = fs::read_to_string(&wing).expect("a design");
    fs::write(&wing, text.clone() + "\n# a word\n").expect("written");
    let said = washout(here.path(), &["check", "run"]);
    says(
        &said,
        1,
        &[
            "One thing does not hold.",
            "wing.toml: what the run was made of was changed since",
        ],
    );
    fs::write(&wing, text).expect("written");
    fs::remove_file(run.join("profile.csv")).expect("removed");
    let mut grid = fs::read(run.join("wing.vtu")).expect("a grid");
    let middle = grid.len() / 2;
    grid[middle] ^= 1;
    fs::write(run.join("wing.vtu"), grid).expect("written");
    let said = washout(here.path(), &["check", "run"]);
    let words = [
        "2 things do not hold.",
        "profile.csv: this file of the run is not there any more",
        "wing.vtu: this file of the run was changed since",
        "shape     not checked",
    ];
    says(&said, 1, &words);
}

#[test]
fn a_shape_of_another_wing_does_not_meet_the_equations() {
    let here = with_wing();
    solved(here.path(), "run", &[]);
    solved(here.path(), "other", &["--set", "flapping.frequency_hz=21"]);
    let run = |name: &str| here.path().join("run").join(name);
    // under its hash in the record, as if it had been written so
    fs::copy(here.path().join("other/wing.vtu"), run("wing.vtu")).expect("copied");
    let record =
        |folder: &str| fs::read_to_string(here.path().join(folder).join(".washout.json")).expect("a record");
    let hash = |text: &str| {
        let line = text
            .lines()
            .find(|line| line.contains("\"wing.vtu\""))
            .expect("its line");
        line.split('"').nth(3).expect("a hash").to_string()
    };
    let (own, other) = (record("run"), record("other"));
    fs::write(run(".washout.json"), own.replace(&hash(&own), &hash(&other))).expect("written");
    let said = washout(here.path(), &["check", "run"]);
    says(
        &said,
        1,
        &[
            "6 of 6 unchanged",
            "the residual relative to the load is",
            "a twist less what the run says (deg) is",
        ],
    );
    // a residual that the run states allows no more than a converged solve leaves
    let text = fs::read_to_string(run("summary.json")).expect("a summary");
    let number = text
        .split("\"residual\": ")
        .nth(1)
        .and_then(|rest| rest.split(',').next())
        .expect("a residual");
    let other = text.replace(&format!("\"residual\": {number}"), "\"residual\": 1e9");
    let whole = washout::origin::sha256(text.as_bytes());
    let own = fs::read_to_string(run(".washout.json")).expect("a record");
    fs::write(run("summary.json"), &other).expect("written");
    fs::write(
        run(".washout.json"),
        own.replace(&whole, &washout::origin::sha256(other.as_bytes())),
    )
    .expect("written");
    let said = washout(here.path(), &["check", "run"]);
    says(
        &said,
        1,
        &["the residual relative to the load is", "at most 1e-2"],
    );
    // forces balance only in equilibrium, work too
    says(
        &said,
        1,
        &[
            "what loads and supports leave of the load",
            "what the works of loads and internal forces leave",
        ],
    );
}

#[test]
fn what_is_no_run_is_refused_and_of_other_runs_the_files_are_checked() {
    let here = with_wing();
    let said = washout(here.path(), &["check", "nowhere"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(
        said.err.contains("nowhere is not the folder of a run"),
        "{}",
        said.err
    );
    let wing = here.path().join("wing.toml").display().to_string();
    let lift = washout(
        here.path(),
        &["lift", &wing, "--set", "mesh.refine=0.2", "--output", "lift"],
    );
    assert_eq!(lift.code, Some(0), "{}", lift.err);
    says(
        &washout(here.path(), &["check", "lift"]),
        0,
        &["run       washout lift"],
    );
    fs::write(here.path().join("lift/span.csv"), "r_mm\n").expect("written");
    says(
        &washout(here.path(), &["check", "lift"]),
        1,
        &["span.csv: this file of the run was changed since"],
    );
}
