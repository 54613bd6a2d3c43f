//! Blind runs, fronts and design searches in tasks: the same answer in one or in many, and nothing done twice.

use std::fs;
use std::path::Path;
use std::time::SystemTime;

use crate::hidden::{MANY, campaign};
use crate::{Said, contents, design, entries, folder, program, washout};

const SHELF: &str = "name,shape,diameter_mm,material,tolerance_mm\nhalf-1.0,half-round,1.0,carbon-rod,0.03\n\
                     round-0.3,round,0.3,carbon-rod,0.01\n";

fn front(here: &Path, more: &[&str]) -> Said {
    let rigid = design("rigid.toml");
    let search = [
        "pareto",
        &rigid,
        "--no-gain",
        "--population",
        "20",
        "--generations",
        "8",
    ];
    washout(here, &[&search[..], more].concat())
}

/// Twelve layouts on a coarse mesh.
fn layout(here: &Path, more: &[&str]) -> Said {
    fs::write(here.join("shelf.csv"), SHELF).unwrap();
    let base = design("twist-v2.toml");
    let search = ["design", &base, "--stock", "shelf.csv", "--lift", "25"];
    let coarse = ["--set", "mesh.refine=0.25", "--first-look", "1"];
    washout(here, &[&search[..], &coarse, more].concat())
}

fn blind(here: &Path, more: &[&str]) -> Said {
    washout(here, &[&["blind", "4", "--study", "study.toml"], more].concat())
}

fn written(file: &Path) -> SystemTime {
    fs::metadata(file).unwrap().modified().unwrap()
}

fn done(said: &Said) {
    assert_eq!(said.code, Some(0), "{}", said.err);
}

/// Ends with 2 and says which tasks there are.
fn has_no_such_task(said: &Said, last: usize) {
    assert_eq!(said.code, Some(2), "{}", said.out);
    assert!(said.err.contains(&format!("from 0 to {last}")), "{}", said.err);
}

#[test]
fn a_front_of_many_seeds_is_that_of_them_all_and_each_seed_is_searched_once() {
    let here = folder();
    let alone: Vec<serde_json::Value> = ["1", "2", "3"]
        .iter()
        .map(|seed| {
            let said = front(here.path(), &["--seed", seed, "--output", "alone", "--json"]);
            done(&said);
            said.document()["fronts"][0]["points"].clone()
        })
        .collect();
    let many = ["--restarts", "3", "--json"];
    let said = front(
        here.path(),
        &[&many[..], &["--threads", "1", "--output", "one"]].concat(),
    );
    done(&said);
    let (one, points) = (contents(&here.path().join("one")), said.document());
    let merged = points["fronts"][0]["points"].as_array().unwrap();
    let all: Vec<&serde_json::Value> = alone
        .iter()
        .flat_map(|points| points.as_array().unwrap())
        .collect();
    let aims =
        |point: &serde_json::Value| [&point["lift"], &point["efficiency"]].map(|aim| aim.as_f64().unwrap());
    assert!(merged.iter().all(|point| all.contains(&point)));
    for point in &all {
        let ([lift, efficiency], of) = (aims(point), merged.iter().map(aims));
        let mut reached = of.filter(|[l, e]| *l >= lift && *e >= efficiency);
        assert!(
            reached.next().is_some(),
            "{point} is beaten by none and not in the front"
        );
    }
    for seeds in &alone {
        let share = merged
            .iter()
            .filter(|point| seeds.as_array().unwrap().contains(point));
        assert!(
            share.count() < merged.len(),
            "one seed has it all: the test shows nothing"
        );
    }

    let many = [&many[..], &["--output", "many"]].concat();
    let said = front(here.path(), &[&many[..], &["--task", "1"]].concat());
    done(&said);
    assert_eq!(
        (said.out.as_str(), here.path().join("many").exists()),
        ("", false)
    );
    let parts = here.path().join("many-tasks");
    let first = parts.join(&entries(&parts)[0]);
    assert_eq!(entries(&parts).len(), 1);
    let before = written(&first);
    has_no_such_task(&front(here.path(), &[&many[..], &["--task", "3"]].concat()), 2);
    done(&front(here.path(), &many));
    assert_eq!(contents(&here.path().join("many")), one);
    // what an interruption may leave
    let other = entries(&parts)
        .into_iter()
        .map(|name| parts.join(name))
        .find(|part| *part != first);
    fs::write(other.unwrap(), "{\"key\": \"half a fi").unwrap();
    done(&front(here.path(), &many));
    assert_eq!(contents(&here.path().join("many")), one);
    assert_eq!(written(&first), before, "a seed is searched twice");
}

#[test]
fn a_layout_is_the_same_for_any_tasks_and_a_search_goes_on_where_it_stopped() {
    let here = folder();
    done(&layout(
        here.path(),
        &["--task-size", "100", "--threads", "1", "--output", "one"],
    ));
    let one = contents(&here.path().join("one"));
    let many = ["--task-size", "5", "--output", "many"];
    done(&layout(here.path(), &[&many[..], &["--task", "1"]].concat()));
    assert!(!here.path().join("many").exists());
    has_no_such_task(&layout(here.path(), &[&many[..], &["--task", "3"]].concat()), 2);
    let parts = here.path().join("many-tasks");
    let first = parts.join(&entries(&parts)[0]);
    assert_eq!(entries(&parts).len(), 1);
    let before = written(&first);
    done(&layout(here.path(), &many));
    assert_eq!(contents(&here.path().join("many")), one);
    let closer = parts.join("closer");
    let looks = entries(&closer);
    let [lost, kept] = [0, 1].map(|look| closer.join(&looks[look]));
    fs::remove_file(lost).unwrap();
    let before = (before, written(&kept));
    done(&layout(here.path(), &many));
    assert_eq!(contents(&here.path().join("many")), one);
    assert_eq!(
        (written(&first), written(&kept)),
        before,
        "a layout is solved twice"
    );
    assert_eq!(entries(&closer), looks);
}

#[test]
fn a_task_of_a_blind_run_writes_its_cases_and_no_scoreboard() {
    let here = folder();
    campaign(here.path(), &MANY);
    let board = |said: &Said| {
        done(said);
        let mut board = said.document();
        board.as_object_mut().unwrap().remove("median_seconds");
        board
    };
    let one = board(&blind(here.path(), &["--output", "one", "--json"]));
    let many = ["--task-size", "3", "--output", "many", "--json"];
    let said = blind(here.path(), &[&many[..], &["--task", "1"]].concat());
    done(&said);
    assert_eq!(said.out, "");
    assert!(!here.path().join("many").exists());
    let folder = here.path().join("many-tasks");
    assert_eq!(entries(&folder), ["cases", "run.json"]);
    let last = entries(&folder.join("cases"));
    assert_eq!(last.len(), 1, "{last:?}");
    let before = written(&folder.join("cases").join(&last[0]));
    has_no_such_task(&blind(here.path(), &[&many[..], &["--task", "2"]].concat()), 1);
    assert_eq!(board(&blind(here.path(), &many)), one);
    assert_eq!(written(&folder.join("cases").join(&last[0])), before);
}

#[test]
fn a_cluster_that_is_not_there_is_said() {
    let here = folder();
    campaign(here.path(), &MANY);
    fs::write(here.path().join("shelf.csv"), SHELF).unwrap();
    let (rigid, base) = (design("rigid.toml"), design("twist-v2.toml"));
    for verb in [
        &["pareto", &rigid, "--no-gain"][..],
        &["design", &base, "--stock", "shelf.csv", "--lift", "25"],
        &["blind", "4", "--study", "study.toml"],
    ] {
        let output = program(here.path())
            .args(verb)
            .arg("--slurm")
            .env("PATH", here.path())
            .output()
            .unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{err}");
        assert!(err.contains("needs Slurm's commands"), "{err}");
    }
}

/// Stands for a scheduler: runs what it is given at once, somewhere else.
const SBATCH: &str = "#!/bin/bash\ncd /\nscript=${@: -1}\nfor part in $(sed -n 's/#SBATCH --array=//p' \"$script\" | tr , ' '); do\n\
                      for id in $(seq ${part%-*} ${part#*-}); do SLURM_ARRAY_TASK_ID=$id bash \"$script\" || exit 1; done\ndone\n\
                      grep -q array= \"$script\" || bash \"$script\" || exit 1\necho 7\n";

#[cfg(unix)]
#[test]
fn jobs_of_a_scheduler_find_the_same_front_from_wherever_they_are_started() {
    use std::os::unix::fs::PermissionsExt;
    let here = folder();
    let bin = here.path().join("bin");
    fs::create_dir(&bin).unwrap();
    fs::write(bin.join("sbatch"), SBATCH).unwrap();
    fs::set_permissions(bin.join("sbatch"), fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap());
    done(&front(here.path(), &["--restarts", "3", "--output", "one"]));
    for (more, output) in [(&[][..], "on jobs"), (&["--no-wait"], "left alone")] {
        let rigid = design("rigid.toml");
        let search = [
            "pareto",
            &rigid,
            "--no-gain",
            "--population",
            "20",
            "--generations",
            "8",
        ];
        let slurm = ["--restarts", "3", "--output", output, "--slurm", "--minutes", "5"];
        let said = program(here.path())
            .args([&search[..], &slurm, more].concat())
            .env("PATH", &path)
            .output()
            .unwrap();
        let err = String::from_utf8(said.stderr).unwrap();
        assert_eq!(said.status.code(), Some(0), "{err}");
        assert!(err.contains("3 tasks submitted; job 7"), "{err}");
        assert_eq!(
            contents(&here.path().join(output)),
            contents(&here.path().join("one"))
        );
    }
}
