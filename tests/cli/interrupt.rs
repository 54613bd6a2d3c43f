//! Ctrl-C, and a kill at any instant.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::hidden::{MANY, campaign};
use crate::{contents, design, entries, folder, program, washout};

#[test]
fn an_interrupted_run_ends_with_130_and_leaves_what_was_there() {
    if cfg!(not(unix)) {
        eprintln!("skipped: no signals here");
        return;
    }
    let here = folder();
    let design = design("twist-v2.toml");
    assert_eq!(washout(here.path(), &["solve", &design]).code, Some(0));
    let before = contents(&here.path().join("output/twist-v2"));
    let child = program(here.path())
        .args(["solve", &design, "--refine", "4"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    wait_until_it_writes(&here.path().join("output"));
    interrupt(&child);
    let output = child.wait_with_output().expect("the program ends");
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(
        (output.status.code(), output.stdout.as_slice()),
        (Some(130), b"".as_slice()),
        "{err}"
    );
    assert!(err.contains("interrupted"), "{err}");
    assert!(before == contents(&here.path().join("output/twist-v2")));
    assert_eq!(entries(&here.path().join("output")), ["twist-v2"]);
}

#[test]
fn what_a_killed_run_left_is_cleared_by_the_next_one_into_that_folder() {
    let here = folder();
    let design = design("twist-v2.toml");
    let coarse = ["solve", &design, "--refine", "0.3", "--quiet"];
    washout(here.path(), &coarse);
    let output = here.path().join("output");
    let before = contents(&output.join("twist-v2"));
    let mut child = program(here.path())
        .args(["solve", &design, "--refine", "4", "--quiet"])
        .spawn()
        .expect("the program starts");
    wait_until_it_writes(&output);
    child.kill().expect("killed");
    child.wait().expect("the program ends");
    assert!(
        entries(&output).len() > 1,
        "nothing was left: the test shows nothing"
    );
    assert!(before == contents(&output.join("twist-v2")));
    let said = washout(here.path(), &coarse);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert_eq!(entries(&output), ["twist-v2"]);
    assert!(before == contents(&output.join("twist-v2")));
}

#[cfg(unix)]
#[test]
fn a_set_of_files_is_replaced_in_one_step_and_never_file_by_file() {
    use std::os::unix::fs::MetadataExt;
    let here = folder();
    campaign(here.path(), &MANY);
    let made = ["synthesize", "study.toml", "--output", "set", "--seed"];
    let rigid = design("rigid.toml");
    let swept = ["sweep", &rigid, "--output", "set", "--set", "mesh.refine=0.2"];
    let swept = [&swept[..], &["--vary"]].concat();
    let sets = [
        (&made[..], ["1", "2"]),
        (&swept[..], ["flapping.frequency_hz=20,21"; 2]),
    ];
    for (verb, values) in sets {
        let set = here.path().join("set");
        let folders = values.map(|value| {
            let said = washout(here.path(), &[verb, &[value]].concat());
            assert_eq!(said.code, Some(0), "{}", said.err);
            fs::metadata(&set).expect("a folder").ino()
        });
        assert_ne!(folders[0], folders[1], "{verb:?} wrote into the earlier folder");
        fs::remove_dir_all(&set).expect("removed");
    }
}

/// The folder that a run fills stands beside the earlier run as soon as it solves.
fn wait_until_it_writes(output: &Path) {
    let start = Instant::now();
    let is_partial = |name: &String| name.contains(".partial-");
    while !entries(output).iter().any(is_partial) {
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "the run never began to write"
        );
        sleep(Duration::from_millis(2));
    }
}

fn interrupt(child: &Child) {
    let status = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(status.expect("kill").success());
}
