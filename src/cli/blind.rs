//! `washout blind`: many diagnoses whose answer is known, and the scoreboard.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Args;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde::{Deserialize, Serialize};

use crate::blind::{Blind, BlindError, Failed, Kind, Outcome, Ranges, Scoreboard, Turned, scoreboard};
use crate::diagnose::DiagnoseError;
use crate::diagnose::candidates::known;
use crate::export::blind::page;
use crate::export::lock::Lock;
use crate::export::run::RunFolder;
use crate::export::tasks::{read_json, write_json};
use crate::export::{ExportError, json};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::StudyError;
use crate::sweep::Base;
use crate::synthesize::SynthesizeError;
use crate::task::{key, stretches};

use super::diagnose::candidates;
use super::job::Job;
use super::tasks::{TaskArguments, Work, beside, gone};
use super::{Console, Failure};

const VERB: &str = "blind";

/// A case as its file holds it.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
enum Case {
    Judged(Box<Outcome>),
    Failed(Failed),
}

/// What a folder of cases is of.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Run {
    version: String,
    /// Of study, effects and version.
    content: String,
    /// What is not hidden; none before that is known.
    turned: Option<Vec<Turned>>,
}

/// Arguments of `washout blind`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # a dozen cases of all kinds
  washout blind 12
  # 150 without anything missing, 60 single, 30 pairs, 30 novel, 20 twins
  washout blind 290 --output night
  # ten of each
  washout blind 20 --kind pair --kind twin
  # effects that stand out
  washout blind 20 --kind single --detectability 30..60
  # wings further from their model than the study admits
  washout blind 29 --background 0.01..0.03
  # the same again after an interruption: goes on where it stopped
  washout blind 290 --output night
  washout blind 290 --output night --slurm --partition night --minutes 120 \\
    --task-size 2

A development benchmark: the cases are made by washout itself, with other meshes and formulas and with background errors. Writes output/blind/: scoreboard.md, which lists the figures, every case and every miss, and scoreboard.json. Every case is a file in output/blind-tasks/cases/, and is diagnosed only once.")]
pub struct TryBlind {
    /// How many cases
    #[arg(value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub cases: u32,
    /// The study whose campaign is tried
    #[arg(long, value_name = "STUDY", default_value = "studies/three-rods.toml")]
    pub study: PathBuf,
    /// Try this effect; can be given many times [default: those that the study names, or all that can act]
    #[arg(long, value_name = "NAME")]
    pub effect: Vec<String>,
    /// Only cases of this kind: null, null-quiet, null-outlier, single, pair, novel or twin; can be given many times
    #[arg(long, value_name = "KIND", value_parser = kind)]
    pub kind: Vec<Kind>,
    /// Seed of the first case
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// How well the hidden effects could be seen, sigma: strengths are drawn evenly from this range
    #[arg(long, value_name = "LOW..HIGH", default_value = "5..25", value_parser = sigmas)]
    pub detectability: Within,
    /// Errors of chord, stiffness and air law that nobody states: their standard deviation is drawn evenly from this range of shares
    #[arg(long, value_name = "LOW..HIGH", default_value = "0.005..0.015", value_parser = shares)]
    pub background: Within,
    /// Change a key in every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder to write into
    #[arg(long, short, value_name = "DIR", default_value = "output/blind")]
    pub output: PathBuf,
    /// Cases in one task
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub task_size: u32,
    /// Tasks
    #[command(flatten)]
    pub tasks: TaskArguments,
}

/// A run that is ready: its cases, each with its file, and how they are cut into tasks.
struct Ready<'a> {
    verb: &'a TryBlind,
    study: &'a LoadedStudy,
    names: Vec<&'a str>,
    run: Run,
    cases: Vec<(Kind, u64, PathBuf)>,
    tasks: Vec<Range<usize>>,
}

impl TryBlind {
    /// Runs what is missing of the cases and prints the scoreboard.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        known(&self.effect).map_err(|error| Failure::of_diagnosis(&self.study, error))?;
        let study = LoadedStudy::load_planned(&self.study, &self.set)?;
        let effects = candidates(&study, &self.effect, console)?;
        let names: Vec<&str> = effects.names.iter().map(String::as_str).collect();
        if self.tasks.task.is_none() {
            RunFolder::refuse(&self.output, VERB)?;
        }
        let folder = self.parts().join("cases");
        std::fs::create_dir_all(&folder).map_err(ExportError::file("create", &folder))?;
        let cases: Vec<(Kind, u64, PathBuf)> = (0..self.cases as usize)
            .map(|index| {
                let of_this = self.kind.get(index % self.kind.len().max(1));
                let kind = of_this.copied().unwrap_or_else(|| Kind::at(index));
                let seed = self.seed + index as u64;
                (kind, seed, folder.join(format!("{}-{seed}.json", kind.word())))
            })
            .collect();
        let mut ready = Ready {
            verb: self,
            study: &study,
            run: self.same_run(&study, &names)?,
            names,
            tasks: stretches(cases.len(), self.task_size as usize).collect(),
            cases,
        };
        let job = Job::as_said(&self.parts())?;
        if !self.tasks.finish(&mut ready, &job, console)? {
            return Ok(());
        }
        let (mut outcomes, mut failed) = (Vec::new(), Vec::new());
        for (index, (_, _, path)) in ready.cases.iter().enumerate() {
            match read_json(path)?.ok_or_else(|| gone(index / self.task_size as usize))? {
                Case::Judged(outcome) => outcomes.push(*outcome),
                Case::Failed(reason) => failed.push(reason),
            }
        }
        // what is not hidden may have been found by other processes
        let run = read_json::<Run>(&self.run_file())?.unwrap_or(ready.run);
        let board: Scoreboard = scoreboard(&outcomes, &failed, run.turned.as_deref().unwrap_or_default());
        let page = page(&study.study.name, &board, &outcomes);
        let text = json::text(&json::document(&board)?)?;
        let mut written = RunFolder::create(&self.output, VERB)?;
        written.add("scoreboard.md", page.as_bytes())?;
        written.add("scoreboard.json", text.as_bytes())?;
        written.commit()?;
        console.result(&page, &board)
    }

    /// One case; without an answer, with the reason. An error if the user asked to stop or the campaign allows no such case.
    fn case(&self, blind: &Blind, kind: Kind, seed: u64, progress: &Progress) -> Result<Case, Failure> {
        match blind.case(kind, seed, &progress.unseen()) {
            Ok(outcome) => Ok(Case::Judged(Box::new(outcome))),
            Err(error) if error.is_of_run() => Err(self.failed(error)),
            Err(error) => Ok(Case::Failed(Failed {
                kind,
                seed,
                failed: error.to_string(),
            })),
        }
    }

    /// What the folder is of; refuses one that holds the cases of another run: their figures must not be added up.
    fn same_run(&self, study: &LoadedStudy, names: &[&str]) -> Result<Run, Failure> {
        let content = Base::Study(Box::new(study.clone())).content();
        let run = Run {
            version: env!("CARGO_PKG_VERSION").to_string(),
            content: key([&[content.as_str(), &format!("{:?}", self.ranges())], names].concat()),
            turned: None,
        };
        let path = self.run_file();
        let _lock = Lock::when_free(&self.parts())?;
        if !path.exists() {
            write_json(&path, &run)?;
            return Ok(run);
        }
        match read_json::<Run>(&path)? {
            Some(known) if known.version == run.version && known.content == run.content => Ok(known),
            _ => Err(Failure::Option {
                option: "--output",
                reason: format!(
                    "{} holds cases of another study, other effects or another program; give another folder",
                    self.parts().display()
                ),
            }),
        }
    }

    fn ranges(&self) -> Ranges {
        Ranges {
            detectable: self.detectability.0,
            background: self.background.0,
        }
    }

    fn parts(&self) -> PathBuf {
        beside(&self.output)
    }

    fn run_file(&self) -> PathBuf {
        self.parts().join("run.json")
    }

    fn failed(&self, error: BlindError) -> Failure {
        match error {
            BlindError::Diagnosis(DiagnoseError::Cancelled(cancelled))
            | BlindError::Study(StudyError::Cancelled(cancelled))
            | BlindError::Synthesis(SynthesizeError::Study(StudyError::Cancelled(cancelled))) => {
                cancelled.into()
            }
            source => Failure::Blind {
                study: self.study.clone(),
                source,
            },
        }
    }
}

impl Ready<'_> {
    /// Cases of a task that have no file yet, or one of another version.
    fn left(&self, task: usize) -> Result<Vec<usize>, Failure> {
        let mut left = Vec::new();
        for case in self.tasks[task].clone() {
            if read_json::<Case>(&self.cases[case].2)?.is_none() {
                left.push(case);
            }
        }
        Ok(left)
    }
}

impl Work for Ready<'_> {
    fn count(&self) -> usize {
        self.tasks.len()
    }

    fn is_done(&self, task: usize) -> Result<bool, Failure> {
        Ok(self.left(task)?.is_empty())
    }

    fn run(&mut self, tasks: &[usize], progress: &Progress) -> Result<(), Failure> {
        let left: Vec<Vec<usize>> = tasks
            .iter()
            .map(|task| self.left(*task))
            .collect::<Result<_, _>>()?;
        let left = left.concat();
        progress.say(format_args!(
            "{} of {} cases to be diagnosed",
            left.len(),
            self.cases.len()
        ));
        let known = self.run.turned.take();
        let blind = Blind::new(
            self.study,
            self.names.clone(),
            self.verb.ranges(),
            known,
            progress,
        );
        let blind = blind.map_err(|error| self.verb.failed(error))?;
        self.run.turned = Some(blind.turned.clone());
        write_json(&self.verb.run_file(), &self.run)?;
        let done = AtomicUsize::new(0);
        left.par_iter().try_for_each(|case| {
            let (kind, seed, path) = &self.cases[*case];
            write_json(path, &self.verb.case(&blind, *kind, *seed, progress)?)?;
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress.say(format_args!("{count} of {}: {} {seed}", left.len(), kind.word()));
            Ok(())
        })
    }
}

/// A range.
#[derive(Debug, Clone, Copy)]
pub struct Within([f64; 2]);

fn sigmas(word: &str) -> Result<Within, String> {
    within(word, [1.0, 1000.0])
        .ok_or("give two numbers from 1 to 1000, the smaller first, as 5..25".to_string())
}

fn shares(word: &str) -> Result<Within, String> {
    within(word, [0.001, 0.1])
        .ok_or("give two shares from 0.001 to 0.1, the smaller first, as 0.005..0.015".to_string())
}

/// The two ends that a word names, if they lie within `ends`.
fn within(word: &str, ends: [f64; 2]) -> Option<Within> {
    let (low, high) = word.split_once("..")?;
    let (low, high): (f64, f64) = (low.trim().parse().ok()?, high.trim().parse().ok()?);
    (ends[0] <= low && low <= high && high <= ends[1]).then_some(Within([low, high]))
}

fn kind(word: &str) -> Result<Kind, String> {
    let known = Kind::ALL.into_iter().find(|kind| kind.word() == word);
    known.ok_or_else(|| {
        format!(
            "there is none; kinds are {}",
            Kind::ALL.map(Kind::word).join(", ")
        )
    })
}
