//! Ctrl-C.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

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

/// The folder that a run fills stands beside the earlier run as soon as it solves.
fn wait_until_it_writes(output: &Path) {
    let start = Instant::now();
    while entries(output).len() < 2 {
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
