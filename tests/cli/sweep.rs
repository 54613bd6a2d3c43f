//! Sweeps as a user makes them: tables, interruptions, failures, refusals.

use std::fs;
use std::path::{Path, PathBuf};

use crate::hidden::{MANY, campaign, json};
use crate::{design, folder, washout};

/// A coarse wing, so that a case takes a tenth of a second.
const COARSE: [&str; 2] = ["--set", "mesh.refine=0.4"];

fn swept(folder: &Path, more: &[&str]) -> crate::Said {
    let base = design("twist-v2.toml");
    let arguments: Vec<&str> = ["sweep", &base]
        .iter()
        .chain(&COARSE)
        .chain(more)
        .copied()
        .collect();
    washout(folder, &arguments)
}

fn tasks(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.with_file_name("two-tasks")).unwrap();
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    found.retain(|path| !path.ends_with("sweep.json"));
    found.sort();
    found
}

#[test]
fn the_table_of_a_sweep_is_the_same_for_any_threads_and_tasks_and_after_an_interruption() {
    let here = folder();
    let vary = [
        "--vary",
        "flapping.frequency_hz=18..24:4",
        "--vary",
        "film.thickness_mm=0.006,0.008",
    ];
    let run = |name: &str, more: &[&str]| {
        let arguments: Vec<&str> = vary
            .iter()
            .chain(&["--output", name, "--json"])
            .chain(more)
            .copied()
            .collect();
        let said = swept(here.path(), &arguments);
        assert_eq!(said.code, Some(0), "{}", said.err);
        (
            fs::read(here.path().join(name).join("sweep.csv")).unwrap(),
            said.document(),
        )
    };
    let (one, document) = run("one", &["--threads", "1"]);
    let (two, _) = run("two", &["--threads", "2", "--task-size", "3"]);
    assert_eq!(one, two);
    assert_eq!(document["cases"], 8);
    let text = String::from_utf8(one.clone()).unwrap();
    assert!(
        text.starts_with("case,flapping.frequency_hz,film.thickness_mm,tip_twist_deg,"),
        "{text}"
    );
    let twist = |case: usize| -> f64 {
        let line = text.lines().nth(case + 1).unwrap();
        line.split(',').nth(3).unwrap().parse().unwrap()
    };
    assert!(
        twist(0) < twist(2) && twist(2) < twist(6),
        "faster twists more: {text}"
    );
    // what an interruption left: the first task of three
    let folder = here.path().join("two");
    let kept = tasks(&folder);
    assert_eq!(kept.len(), 3);
    for lost in &kept[1..] {
        fs::remove_file(lost).unwrap();
    }
    fs::write(&kept[1], "half a fi").unwrap();
    fs::remove_file(folder.join("sweep.csv")).unwrap();
    let before = fs::metadata(&kept[0]).unwrap().modified().unwrap();
    let said = washout(here.path(), &["sweep", "--resume", "two"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert_eq!(fs::read(folder.join("sweep.csv")).unwrap(), one);
    assert_eq!(
        fs::metadata(&kept[0]).unwrap().modified().unwrap(),
        before,
        "nothing is done twice"
    );
}

#[test]
fn a_row_of_a_sweep_is_what_solve_says_of_that_design_with_an_effect_of_the_air_on() {
    let here = folder();
    let share = "effects.coefficient-scale.strength";
    let said = swept(
        here.path(),
        &["--vary", &format!("{share}=0.3,0.4"), "--output", "swept"],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let table = fs::read_to_string(here.path().join("swept/sweep.csv")).unwrap();
    let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let figure = |name: &str| -> f64 {
        let column = lines[0].iter().position(|own| *own == name).unwrap();
        lines[2][column].parse().unwrap()
    };
    let base = design("twist-v2.toml");
    let set = format!("{share}=0.4");
    let said = washout(
        here.path(),
        &["solve", &base, COARSE[0], COARSE[1], "--set", &set, "--json"],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let mean = document["lift"]["stroke_mean"].clone();
    for (name, solved) in [
        ("lift_mn", &mean["lift_mn"]),
        ("drag_mn", &mean["drag_mn"]),
        ("power_mw", &mean["power_mw"]),
    ] {
        let solved = solved.as_f64().unwrap_or_else(|| panic!("{document}"));
        // the sweep starts from its base, the solve from rest
        assert!(
            (figure(name) / solved - 1.0).abs() < 1e-6,
            "{name}: {} {solved}",
            figure(name)
        );
    }
}

#[test]
fn a_case_that_fails_keeps_its_row_with_the_reason() {
    let here = folder();
    let said = swept(
        here.path(),
        &[
            "--vary",
            "film.thickness_mm=0.006,-1",
            "--output",
            "sweep",
            "--json",
        ],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert_eq!(
        (&said.document()["cases"], &said.document()["failures"]),
        (&2.into(), &1.into())
    );
    let text = fs::read_to_string(here.path().join("sweep/sweep.csv")).unwrap();
    let failed = text.lines().nth(2).unwrap();
    assert!(
        failed.starts_with("1,-1,,") && failed.contains("film.thickness_mm"),
        "{failed}"
    );
    let said = swept(
        here.path(),
        &["--vary", "film.thickness_mm=-1", "--output", "none"],
    );
    assert_eq!(said.code, Some(2), "a base that no case can have: {}", said.err);
}

#[test]
fn a_sweep_without_any_result_ends_as_its_cases_do() {
    let here = folder();
    // a design that can be read, and of which no wing is made
    let mesh = here.path().join("no.msh").display().to_string();
    fs::write(&mesh, "no mesh").unwrap();
    let vary = format!("mesh.file={mesh},{mesh}");
    let said = swept(here.path(), &["--vary", &vary, "--output", "refused"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("none of the 2 cases"), "{}", said.err);
    assert!(here.path().join("refused/sweep.csv").is_file());
    let unsolved = ["--set", "coupling.max_iterations=1", "--output", "unsolved"];
    let said = swept(
        here.path(),
        &[&["--vary", "flapping.frequency_hz=21,22"], &unsolved[..]].concat(),
    );
    assert_eq!(said.code, Some(3), "{}", said.err);
}

#[test]
fn samples_tell_which_axis_moves_the_twist() {
    let here = folder();
    let said = swept(
        here.path(),
        &[
            "--vary",
            "flapping.frequency_hz=18..24",
            "--vary",
            "air.density_kg_m3=1.19..1.21",
            "--samples",
            "16",
            "--output",
            "sweep",
            "--json",
        ],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let twist = &document["sensitivities"][0];
    assert_eq!(twist["figure"], "tip_twist_deg");
    assert_eq!(twist["shares"][0]["key"], "flapping.frequency_hz");
    assert!(twist["shares"][0]["total"].as_f64().unwrap() > 0.9, "{twist}");
    assert!(here.path().join("sweep/scatter.svg").exists());
}

#[test]
fn a_sweep_that_makes_no_sense_is_refused_before_anything_is_solved() {
    let here = folder();
    for (arguments, words) in [
        (vec!["--vary", "flapping.frequency=18..24:4"], "frequency_hz"),
        (vec!["--vary", "flapping.frequency_hz=18..24"], "18..24:5"),
        (vec!["--vary", "flapping.frequency_hz=24..18:4"], "not up"),
        (
            vec![
                "--vary",
                "flapping.frequency_hz=18,19",
                "--vary",
                "flapping.frequency_hz=20,21",
            ],
            "varied twice",
        ),
    ] {
        let said = swept(here.path(), &arguments);
        assert_eq!(said.code, Some(2), "{arguments:?}: {}", said.err);
        assert!(said.err.contains(words), "{arguments:?}: {}", said.err);
    }
    let said = washout(here.path(), &["sweep", "--resume", "nowhere"]);
    assert!(
        said.code == Some(2) && said.err.contains("holds no sweep"),
        "{}",
        said.err
    );
    let one = ["--vary", "flapping.frequency_hz=18,19", "--output", "sweep"];
    assert_eq!(swept(here.path(), &one).code, Some(0));
    let other = ["--vary", "flapping.frequency_hz=18,20", "--output", "sweep"];
    let said = swept(here.path(), &other);
    assert!(
        said.code == Some(2) && said.err.contains("another sweep"),
        "{}",
        said.err
    );
    let said = washout(here.path(), &["sweep", "--resume", "sweep", "--task", "7"]);
    assert!(
        said.code == Some(2) && said.err.contains("from 0 to 0"),
        "{}",
        said.err
    );
}

#[test]
fn what_a_study_calibrates_is_held_at_the_values_that_a_sweep_gives_it() {
    let here = folder();
    campaign(here.path(), &MANY);
    let hide = ["--effect", "root-flexure=0.2", "--seed", "9", "--output", "try"];
    json(&washout(
        here.path(),
        &[&["synthesize", "study.toml", "--json"], &hide[..]].concat(),
    ));
    // a fact of the design, which takes no prior from it
    let study = here.path().join("try/study.toml");
    let text = fs::read_to_string(&study).unwrap();
    fs::write(&study, text + "[[uncertain]]\nkey = 'material.steel.g_gpa'\n").unwrap();
    let vary = ["--vary", "material.steel.g_gpa=40,80", "--output", "sweep"];
    let said = washout(here.path(), &[&["sweep", "try/study.toml"], &vary[..]].concat());
    assert_eq!(said.code, Some(0), "{}", said.err);
    let table = fs::read_to_string(here.path().join("sweep/sweep.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| {
        let at = rows[0].iter().position(|own| *own == name).unwrap();
        [rows[1][at], rows[2][at]].map(|text| text.parse::<f64>().unwrap())
    };
    let stated = column("chi_square_per_number_stated");
    assert_eq!(stated, column("chi_square_per_number_calibrated"));
    assert!(stated[0] != stated[1], "{table}");
}

fn table(lift: f64) -> String {
    format!("alpha_deg,cl,cd\n-90,0,2\n0,0,0.1\n45,{lift},1\n90,0,2\n180,0,0.1\n")
}

#[test]
fn what_a_sweep_read_from_a_file_that_has_changed_since_is_done_again() {
    let here = folder();
    assert_eq!(washout(here.path(), &["init", "wing"]).code, Some(0));
    fs::write(here.path().join("a.csv"), table(1.2)).unwrap();
    let air = ["--set", "air.coefficients=table", "--set", "air.table=a.csv"];
    let vary = [
        "--set",
        "mesh.refine=0.2",
        "--vary",
        "air.table=a.csv,b.csv",
        "--json",
    ];
    let sweep = |name: &str| {
        let said = washout(
            here.path(),
            &[&["sweep", "wing.toml", "--output", name], &air[..], &vary[..]].concat(),
        );
        assert_eq!(said.code, Some(0), "{}", said.err);
        let table = fs::read_to_string(here.path().join(name).join("sweep.csv")).unwrap();
        (table, said.document())
    };
    let (lost, _) = sweep("sweep");
    assert!(lost.contains("no such file"), "{lost}");
    let mut known = vec![lost];
    for lift in [1.2, 1.1] {
        fs::write(here.path().join("b.csv"), table(lift)).unwrap();
        let (again, document) = sweep("sweep");
        let (fresh, _) = sweep(&format!("fresh-{lift}"));
        assert_eq!(again, fresh);
        assert!(!known.contains(&again), "an old table is given again: {again}");
        known.push(again);
        for (name, lift) in [("a.csv", 1.2), ("b.csv", lift)] {
            is_made_of(&document, name, table(lift).as_bytes());
        }
    }
}

/// Fails unless a document names the program and a file with what it held.
pub fn is_made_of(document: &serde_json::Value, name: &str, bytes: &[u8]) {
    let made = &document["made_of"];
    assert_eq!(made["program_sha256"].as_str().map(str::len), Some(64), "{made}");
    let files = made["files"].as_array().unwrap();
    let file = files
        .iter()
        .find(|file| file["file"].as_str().unwrap().ends_with(name))
        .unwrap_or_else(|| panic!("{name} is not in {made}"));
    assert_eq!(file["sha256"], washout::origin::sha256(bytes), "{name}");
}
