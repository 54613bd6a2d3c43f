//! Two of them at once: one after the other, or one is refused, and nothing is lost.

use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};

use crate::hidden::{MANY, campaign};
use crate::{design, entries, folder, program, washout};

fn start(here: &Path, arguments: &[&str]) -> Child {
    program(here)
        .args(arguments)
        .args(["--threads", "1"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts")
}

/// Exit codes of programs that were started at once; all but 0 must say `words`.
fn codes(children: Vec<Child>, words: &str) -> Vec<i32> {
    let end = |child: Child| {
        let output = child.wait_with_output().expect("the program ends");
        let (code, err) = (output.status.code(), String::from_utf8_lossy(&output.stderr));
        assert!(code == Some(0) || err.contains(words), "{code:?} {err}");
        code.expect("an exit code")
    };
    children.into_iter().map(end).collect()
}

#[test]
fn of_two_effects_that_join_a_study_at_once_none_is_lost() {
    let here = folder();
    campaign(here.path(), &MANY);
    let hide = ["synthesize", "study.toml", "--seed", "3", "--output", "made"];
    assert_eq!(washout(here.path(), &hide).code, Some(0));
    let study = here.path().join("made/study.toml");
    let effects = ["rod-shear-modulus", "root-flexure"];
    let add = |effect: &str, ladder: &str| {
        let to = ["add", effect, "--to", "made/study.toml", "--ladder", ladder];
        start(here.path(), &to)
    };
    let both = vec![add(effects[0], "one"), add(effects[1], "other")];
    let codes = codes(both, "another washout is writing made/study.toml");
    let joined = || -> Vec<String> {
        let study: toml::Table = toml::from_str(&fs::read_to_string(&study).unwrap()).unwrap();
        let tables = study["effect"].as_array().unwrap().iter();
        tables
            .map(|effect| effect["name"].as_str().unwrap().to_string())
            .collect()
    };
    for (effect, code) in effects.into_iter().zip(&codes) {
        let is_in = joined().iter().any(|name| name == effect);
        assert_eq!(is_in, *code == 0, "{effect}: {code}");
    }
    assert!(codes.contains(&0), "{codes:?}");
    for (effect, code) in effects.into_iter().zip(&codes) {
        if *code != 0 {
            let again = ["add", effect, "--to", "made/study.toml"];
            assert_eq!(washout(here.path(), &again).code, Some(0));
        }
    }
    let mut all = joined();
    all.sort();
    assert_eq!(all, effects.map(String::from));
    assert!(!here.path().join("made/.study.toml.lock").exists());
}

#[test]
fn of_two_sweeps_into_one_folder_one_is_refused() {
    let here = folder();
    let wing = design("rigid.toml");
    for round in 0..4 {
        let name = format!("sweep-{round}");
        let sweep = |values: &str| {
            let vary = format!("flapping.frequency_hz={values}");
            let base = ["sweep", &wing, "--set", "mesh.refine=0.2", "--output", &name];
            start(here.path(), &[&base[..], &["--vary", &vary]].concat())
        };
        let both = ["20,21", "22,23"];
        let codes = codes(both.map(sweep).into(), "holds parts of another sweep");
        assert!(codes == [0, 2] || codes == [2, 0], "{codes:?}");
        let done = both[codes.iter().position(|code| *code == 0).unwrap()];
        let table = fs::read_to_string(here.path().join(&name).join("sweep.csv")).unwrap();
        let swept: Vec<&str> = table
            .lines()
            .skip(1)
            .map(|line| line.split(',').nth(1).unwrap())
            .collect();
        assert_eq!(swept.join(","), done);
        let plan = here.path().join(format!("{name}-tasks/sweep.json"));
        let plan: serde_json::Value = serde_json::from_str(&fs::read_to_string(plan).unwrap()).unwrap();
        let planned = plan["axes"][0]["values"]["list"].as_array().unwrap();
        let planned: Vec<&str> = planned.iter().map(|value| value.as_str().unwrap()).collect();
        assert_eq!(planned.join(","), done);
    }
}

#[test]
fn of_solves_into_one_folder_one_is_whole_and_the_others_say_why_not() {
    let here = folder();
    let wing = design("rigid.toml");
    for _ in 0..4 {
        let solve = |frequency: &str| {
            let set = format!("flapping.frequency_hz={frequency}");
            let base = ["solve", &wing, "--refine", "0.3", "--output", "run"];
            start(here.path(), &[&base[..], &["--set", &set]].concat())
        };
        let codes = codes(
            ["20", "21", "22"].map(solve).into(),
            "another washout is writing run",
        );
        assert!(codes.contains(&0), "{codes:?}");
        let run = here.path().join("run");
        let summary = fs::read_to_string(run.join("summary.json")).unwrap();
        let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
        for file in summary["files"].as_array().unwrap() {
            assert!(run.join(file.as_str().unwrap()).is_file(), "{file}");
        }
        assert_eq!(entries(here.path()), ["run"]);
    }
}
