//! What may be replaced: what washout wrote where it is to write, as long as that holds what it wrote, and nothing else.

use std::fs;
use std::path::Path;

use crate::hidden::{MANY, campaign};
use crate::{Said, contents, design, entries, folder, washout};

/// Ends with 2 and says these words.
fn refused(said: &Said, words: &str) {
    assert_eq!(said.code, Some(2), "{}{}", said.out, said.err);
    assert!(said.err.contains(words), "{words:?} is not in {}", said.err);
}

fn done(said: &Said) {
    assert_eq!(said.code, Some(0), "{}", said.err);
}

fn solve(here: &Path, output: &str) -> Said {
    let wing = design("rigid.toml");
    washout(here, &["solve", &wing, "--refine", "0.2", "--output", output])
}

fn sweep(here: &Path, output: &str) -> Said {
    let wing = design("rigid.toml");
    let vary = [
        "--set",
        "mesh.refine=0.2",
        "--vary",
        "flapping.frequency_hz=20,21",
    ];
    washout(here, &[&["sweep", &wing, "--output", output], &vary[..]].concat())
}

#[test]
fn synthesize_replaces_only_what_it_wrote() {
    let here = folder();
    campaign(here.path(), &MANY);
    let hide = |seed: &str| {
        let made = ["synthesize", "study.toml", "--seed", seed, "--output", "made"];
        washout(here.path(), &made)
    };
    let made = here.path().join("made");
    for mine in ["m.csv", "study.toml", "answer.json"] {
        fs::create_dir_all(&made).unwrap();
        fs::write(made.join(mine), "mine").unwrap();
        refused(
            &hide("1"),
            &format!("holds '{mine}', and no record that washout wrote it"),
        );
        assert_eq!(contents(&made), [(mine.to_string(), b"mine".to_vec())]);
        fs::remove_dir_all(&made).unwrap();
    }
    done(&hide("1"));
    let first = contents(&made);
    done(&hide("2"));
    assert_ne!(contents(&made), first);
    // what add writes there is washout's too, what an editor writes there is not
    let add = ["add", "root-flexure", "--to", "made/study.toml"];
    done(&washout(here.path(), &add));
    done(&hide("3"));
    let study = fs::read_to_string(made.join("study.toml")).unwrap();
    fs::write(made.join("study.toml"), study + "# mine\n").unwrap();
    let before = contents(&made);
    refused(
        &hide("4"),
        "holds 'study.toml', which was changed since washout wrote it",
    );
    assert_eq!(contents(&made), before);
}

#[test]
fn a_sweep_replaces_only_a_sweep() {
    let here = folder();
    done(&solve(here.path(), "run"));
    let before = contents(&here.path().join("run"));
    refused(&sweep(here.path(), "run"), "run holds what washout solve wrote");
    assert_eq!(contents(&here.path().join("run")), before);
    let mine = here.path().join("mine");
    fs::create_dir(&mine).unwrap();
    fs::write(mine.join("sweep.csv"), "mine").unwrap();
    refused(&sweep(here.path(), "mine"), "'sweep.csv'");
    assert_eq!(contents(&mine), [("sweep.csv".to_string(), b"mine".to_vec())]);
    assert_eq!(entries(here.path()), ["mine", "run"], "nothing was begun");
    done(&sweep(here.path(), "swept"));
    done(&sweep(here.path(), "swept"));
    refused(
        &solve(here.path(), "swept"),
        "swept holds what washout sweep wrote",
    );
}

#[test]
fn files_that_somebody_lists_in_a_summary_are_not_deleted() {
    let here = folder();
    let run = here.path().join("run");
    fs::create_dir(&run).unwrap();
    fs::write(
        run.join("summary.json"),
        r#"{"files":["thesis.docx","summary.json"]}"#,
    )
    .unwrap();
    fs::write(run.join("thesis.docx"), "mine").unwrap();
    let before = contents(&run);
    refused(&solve(here.path(), "run"), "'summary.json'");
    assert_eq!(contents(&run), before);
}

#[test]
fn add_writes_over_no_file_but_the_study_that_it_changes() {
    let here = folder();
    campaign(here.path(), &MANY);
    let made = ["synthesize", "study.toml", "--seed", "3", "--output", "made"];
    done(&washout(here.path(), &made));
    let add = |output: &str| {
        let to = ["add", "root-flexure", "--to", "made/study.toml"];
        washout(here.path(), &[&to[..], &["--output", output]].concat())
    };
    let rod = fs::read(here.path().join("rod.toml")).unwrap();
    refused(&add("rod.toml"), "rod.toml exists already");
    assert_eq!(fs::read(here.path().join("rod.toml")).unwrap(), rod);
    assert!(!here.path().join("output").exists(), "nothing was computed");
    done(&add("made/with.toml"));
    refused(&add("made/with.toml"), "made/with.toml exists already");
    done(&add("made/../made/study.toml"));
}

#[test]
fn pages_are_written_over_pages_of_their_kind_alone() {
    let here = folder();
    fs::write(here.path().join("notes.md"), "mine").unwrap();
    for arguments in [
        &["effects", "--page", "notes.md"][..],
        &["schema", "--study", "--page", "notes.md"],
        &["verify", "cook-membrane", "--short", "--page", "notes.md"],
    ] {
        refused(&washout(here.path(), arguments), "notes.md exists already");
        assert_eq!(fs::read(here.path().join("notes.md")).unwrap(), b"mine");
    }
    for _ in 0..2 {
        done(&washout(here.path(), &["effects", "--page", "effects.md"]));
        done(&washout(here.path(), &["man", "pages"]));
    }
    fs::write(here.path().join("pages/washout-solve.1"), "mine").unwrap();
    refused(
        &washout(here.path(), &["man", "pages"]),
        "washout-solve.1 exists already",
    );
}

#[cfg(unix)]
#[test]
fn outputs_that_are_not_plain_are_followed_or_refused_before_anything_is_computed() {
    use std::os::unix::fs::symlink;
    let here = folder();
    fs::create_dir(here.path().join("real")).unwrap();
    symlink("real", here.path().join("link")).unwrap();
    symlink("nothing", here.path().join("dangling")).unwrap();
    for output in ["link", "link/", "real/.", "link"] {
        done(&solve(here.path(), output));
        assert!(here.path().join("real/summary.json").is_file());
    }
    assert!(here.path().join("link").is_symlink());
    refused(
        &solve(here.path(), "dangling"),
        "is a link to something that is not there",
    );
    refused(&solve(here.path(), "."), "is the folder that you are in");
    refused(
        &solve(&here.path().join("real"), ".."),
        "is the folder that you are in, or one above it",
    );
    let measure = [
        "measure",
        &design("../examples/video.toml"),
        "--force",
        "--output",
    ];
    for (output, words) in [("/dev/full", "is a device"), ("real", "is a folder")] {
        refused(&washout(here.path(), &[&measure[..], &[output]].concat()), words);
    }
    assert_eq!(entries(here.path()), ["dangling", "link", "real"]);
}
