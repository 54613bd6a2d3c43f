//! What happens when results cannot be written.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::hidden::{MANY, campaign};
use crate::{Said, contents, design, entries, folder, program, washout};

#[test]
fn a_target_below_a_file_ends_with_1_and_names_path_and_cure() {
    let here = folder();
    fs::write(here.path().join("taken"), "mine").expect("written");
    for target in ["taken", "taken/run"] {
        let said = washout(here.path(), &["mesh", &design("rigid.toml"), "--output", target]);
        assert_eq!((said.code, said.out.as_str()), (Some(1), ""), "{target}");
        assert!(
            said.err.contains("taken") && said.err.contains("--output"),
            "{}",
            said.err
        );
    }
    assert_eq!(entries(here.path()), ["taken"]);
}

#[test]
fn an_unwritable_folder_ends_with_1_and_names_path_and_cure() {
    let here = folder();
    let locked = here.path().join("locked");
    fs::create_dir(&locked).expect("a folder");
    set_writable(&locked, false);
    if File::create(locked.join("probe")).is_ok() {
        eprintln!("skipped: this user may write everywhere");
        return;
    }
    let said = washout(
        here.path(),
        &["mesh", &design("rigid.toml"), "--output", "locked/run"],
    );
    set_writable(&locked, true);
    assert_eq!((said.code, said.out.as_str()), (Some(1), ""));
    assert!(
        said.err.contains("locked") && said.err.contains("Permission denied"),
        "{}",
        said.err
    );
    assert!(said.err.contains("may write to with --output"), "{}", said.err);
}

#[test]
fn a_folder_that_the_system_does_not_let_anybody_write_ends_with_1() {
    if !Path::new("/proc/self").exists() {
        eprintln!("skipped: no /proc here");
        return;
    }
    let said = washout(
        folder().path(),
        &["mesh", &design("rigid.toml"), "--output", "/proc/washout/run"],
    );
    assert_eq!((said.code, said.out.as_str()), (Some(1), ""));
    assert!(
        said.err.contains("/proc/washout") && said.err.contains("--output"),
        "{}",
        said.err
    );
}

#[test]
fn a_folder_with_files_of_the_user_is_left_alone() {
    let here = folder();
    fs::create_dir(here.path().join("mine")).expect("a folder");
    fs::write(here.path().join("mine/notes.txt"), "mine").expect("written");
    let before = contents(&here.path().join("mine"));
    let said = washout(here.path(), &["mesh", &design("rigid.toml"), "--output", "mine"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("'notes.txt'"), "{}", said.err);
    assert_eq!(contents(&here.path().join("mine")), before);
}

#[test]
fn a_full_disk_ends_with_1_names_the_file_and_keeps_the_earlier_run() {
    let here = folder();
    // 128 kB hold one coarse mesh, not a fine one besides.
    let script = "mount -t tmpfs -o size=128k none \"$1\" || exit 99; shift; cd \"$1\" || exit 99; shift
        program=$1; design=$2
        \"$program\" mesh \"$design\" --output run --quiet || exit 98
        before=$(cat run/* | cksum)
        \"$program\" mesh \"$design\" --output run --refine 4; code=$?
        [ \"$before\" = \"$(cat run/* | cksum)\" ] || echo 'the earlier run has changed'
        ls -A . run
        exit $code";
    let disk = here.path().to_str().expect("UTF-8");
    let output = Command::new("unshare")
        .args([
            "-rm",
            "sh",
            "-c",
            script,
            "sh",
            disk,
            disk,
            env!("CARGO_BIN_EXE_washout"),
            &design("rigid.toml"),
        ])
        .output();
    let said = match output {
        Ok(output) => Said {
            code: output.status.code(),
            out: String::from_utf8_lossy(&output.stdout).into_owned(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        },
        Err(error) => {
            eprintln!("skipped: no `unshare` to make a small disk with ({error})");
            return;
        }
    };
    if said.code == Some(99) || said.err.contains("unshare failed") || said.err.contains("unshare:") {
        eprintln!(
            "skipped: this system does not let the test mount a small disk: {}",
            said.err
        );
        return;
    }
    assert_eq!(said.code, Some(1), "{}{}", said.out, said.err);
    assert!(
        said.err.contains("cannot write run/mesh.") && said.err.contains("No space left"),
        "{}",
        said.err
    );
    assert!(said.err.contains("free some space there"), "{}", said.err);
    assert_eq!(
        said.out,
        ".:\nrun\n\nrun:\n.washout.json\nmesh.msh\nmesh.vtu\noutline.geo\nsummary.json\n"
    );
}

#[test]
fn standard_output_that_takes_nothing_ends_with_1() {
    let Ok(full) = File::options().write(true).open("/dev/full") else {
        eprintln!("skipped: no /dev/full here");
        return;
    };
    let here = folder();
    let mut command = program(here.path());
    let output = command
        .args(["schema"])
        .stdout(full)
        .output()
        .expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        err.starts_with("washout: cannot write to standard output: No space left"),
        "{err}"
    );
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let here = folder();
    let mut child = program(here.path())
        .arg("schema")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let status = child.wait().expect("the program ends");
    let mut err = String::new();
    child
        .stderr
        .take()
        .expect("a pipe")
        .read_to_string(&mut err)
        .expect("UTF-8");
    assert_eq!((status.code(), err.as_str()), (Some(0), ""));
}

/// A campaign in a folder of its own, with its readings in others.
fn split_campaign(folder: &Path, readings: [&str; 2]) {
    let home = folder.join("study");
    fs::create_dir_all(&home).unwrap();
    campaign(&home, &MANY);
    let study = fs::read_to_string(home.join("study.toml")).unwrap();
    let case = "measurement = 'm.csv'\nmeasured = 'm-{moment}'";
    let beside = |of: &str| format!("measurement = '../{of}/m.csv'\nmeasured = 'm-{{moment}}'");
    let [first, second] = readings;
    let mut study = study.replacen(case, &beside(first), 1);
    if second != first {
        let again = "[[case]]\ndesign = 'rod.toml'\nset = ['load[0].moment_n_m=[{moment*0.002}, 0, 0]']\n";
        study.push_str(&format!("{again}{}\n", beside(second)));
    }
    fs::write(home.join("study.toml"), study).unwrap();
    for of in readings {
        fs::create_dir_all(folder.join(of)).unwrap();
        fs::copy(home.join("m.csv"), folder.join(of).join("m.csv")).unwrap();
    }
}

fn hide_in(folder: &Path, output: &str) -> Said {
    let study = ["synthesize", "study/study.toml"];
    washout(
        folder,
        &[&study[..], &["--effect", "root-flexure=0.2", "--output", output]].concat(),
    )
}

#[test]
fn measurements_of_a_study_are_not_written_over() {
    let folder = tempfile::tempdir().unwrap();
    split_campaign(folder.path(), ["data", "data"]);
    let before = fs::read_to_string(folder.path().join("data/m.csv")).unwrap();
    let said = hide_in(folder.path(), "data");
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("m.csv belongs to the study"), "{}", said.err);
    assert_eq!(
        fs::read_to_string(folder.path().join("data/m.csv")).unwrap(),
        before
    );
    assert_eq!(fs::read_dir(folder.path().join("data")).unwrap().count(), 1);
    let said = hide_in(folder.path(), "made");
    assert_eq!(said.code, Some(0), "{}", said.err);
}

#[test]
fn two_measurement_files_of_one_name_are_not_made_one() {
    let folder = tempfile::tempdir().unwrap();
    split_campaign(folder.path(), ["monday", "tuesday"]);
    let said = hide_in(folder.path(), "made");
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("give them different names"), "{}", said.err);
    assert!(!folder.path().join("made").exists());
}

#[cfg(unix)]
fn set_writable(folder: &Path, writable: bool) {
    use std::os::unix::fs::PermissionsExt;
    let mode = if writable { 0o755 } else { 0o555 };
    fs::set_permissions(folder, fs::Permissions::from_mode(mode)).expect("permissions");
}

#[cfg(not(unix))]
fn set_writable(_: &Path, _: bool) {}
