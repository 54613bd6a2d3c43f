//! Readers of what washout wrote: folders of runs, through the verbs that show them, and grids.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Parser;
use washout::cli::{Arguments, Console, run_on};
use washout::export::vtu_read::read_vtu;
use washout::progress::Progress;

use crate::{Verdict, folder, fuzz};

/// The endings of files that a verb reads again.
const READ: [&str; 3] = ["json", "csv", "vtu"];

/// Runs a verb in this process; nothing is printed.
fn told(arguments: &[&str]) -> Result<(), String> {
    let parsed = Arguments::try_parse_from([&["washout"], arguments].concat()).expect("arguments");
    run_on(&Console::keeping(Progress::quiet()), &parsed).map_err(|failure| failure.to_string())
}

/// A run of the program, made anew.
fn made(name: &str, arguments: &str) -> PathBuf {
    let output = folder(name).join("run");
    let _ = fs::remove_dir_all(&output);
    // of a sweep that was killed
    let _ = fs::remove_dir_all(output.with_file_name("run-tasks"));
    let said = Command::new(env!("CARGO_BIN_EXE_washout"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(arguments.split(' '))
        .arg("--output")
        .arg(&output)
        .output()
        .expect("runs");
    assert!(said.status.success(), "{}", String::from_utf8_lossy(&said.stderr));
    output
}

/// Damages every file of a run, one after the other, and shows the run each time.
fn every_file(name: &str, arguments: &str, count: u64) {
    let run = made(name, arguments);
    let entries = fs::read_dir(&run)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path());
    let is_read = |path: &PathBuf| {
        path.extension()
            .is_some_and(|ending| READ.iter().any(|known| ending == *known))
    };
    let mut paths: Vec<PathBuf> = entries.filter(is_read).collect();
    paths.sort();
    assert!(paths.len() > 1, "{paths:?}");
    let page = run.with_file_name("report.html").display().to_string();
    let shown = run.display().to_string();
    let report = || told(&["report", &shown, "--output", &page]);
    report().unwrap_or_else(|said| panic!("{name}: {said}"));
    let show = || report().and(told(&["plot", &shown, "--list"]));
    for path in paths {
        let whole = fs::read(&path).expect("a file");
        let file = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        fuzz(
            &format!("{name}-{file}"),
            std::slice::from_ref(&whole),
            count,
            |bytes| {
                fs::write(&path, bytes).expect("written");
                says_something(show())
            },
        );
        fs::write(&path, whole).expect("written");
    }
}

fn says_something(shown: Result<(), String>) -> Verdict {
    match shown {
        Err(said) if said.len() < 20 => Err(format!("it does not say what is wrong: {said:?}")),
        _ => Ok(()),
    }
}

#[test]
fn grids_of_a_run() {
    let run = made("vtu", "solve designs/twist-v2.toml --refine 0.2");
    let seed = fs::read(run.join("wing.vtu")).expect("a grid");
    fuzz("vtu", &[seed], 2000, |bytes| {
        match read_vtu(bytes, Path::new("wing.vtu")) {
            Err(error) if !error.to_string().contains("wing.vtu") => Err(error.to_string()),
            _ => Ok(()),
        }
    });
}

#[test]
fn a_solved_run() {
    every_file("solve", "solve designs/twist-v2.toml --refine 0.2", 40);
}

#[test]
fn natural_modes() {
    every_file("modes", "modes designs/twist-v2.toml --refine 0.2", 15);
}

#[test]
fn a_wing_compared() {
    every_file("wing", "compare designs/twist-v2.toml --refine 0.2", 40);
}

#[test]
fn a_study_compared() {
    every_file("study", "compare studies/minguet.toml", 40);
}

#[test]
fn a_lift_run() {
    every_file("lift", "lift designs/twist-v2.toml --set mesh.refine=0.2", 40);
}

#[test]
fn a_sweep() {
    let sweep = "sweep designs/rigid.toml --set mesh.refine=0.2 --vary flapping.frequency_hz=20,21";
    every_file("sweep", sweep, 40);
}

#[test]
fn a_diagnosis() {
    let diagnose = "diagnose studies/minguet.toml --set mesh.refine=0.3 --effect root-flexure";
    every_file("diagnose", diagnose, 40);
}
