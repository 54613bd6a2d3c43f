//! `washout blind`: many diagnoses whose answer is known, and the scoreboard.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Args;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use serde::{Deserialize, Serialize};

use crate::blind::{Blind, BlindError, Failed, Kind, Outcome, Scoreboard, Turned, scoreboard};
use crate::diagnose::DiagnoseError;
use crate::export::ExportError;
use crate::export::blind::page;
use crate::export::file::write_whole;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::StudyError;
use crate::synthesize::SynthesizeError;

use super::diagnose::candidates;
use super::{Console, Failure};

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
    /// Of study and effects.
    content: String,
    /// What is not hidden; none before that is known.
    turned: Option<Vec<Turned>>,
}

/// Arguments of `washout blind`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout blind 12                              a dozen cases of all kinds
  washout blind 290 --output night              150 without anything missing, 60 single, 30 pairs, 30 novel, 20 twins
  washout blind 20 --kind pair --kind twin      ten of each
  washout blind 290 --output night              the same again after an interruption: goes on where it stopped

A development benchmark: the cases are made by washout itself, with other meshes and formulas and with background errors.
Every case is a file in the output folder; scoreboard.md there lists the figures, every case and every miss.")]
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
    /// Change a key in every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder to write into [default: output/blind]
    #[arg(long, short, value_name = "DIR", default_value = "output/blind")]
    pub output: PathBuf,
}

impl TryBlind {
    /// Runs what is missing of the cases and prints the scoreboard.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let progress = console.progress();
        let study = LoadedStudy::load_planned(&self.study, &self.set)?;
        let names = candidates(&study, &self.effect);
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let folder = self.output.join("cases");
        std::fs::create_dir_all(&folder).map_err(ExportError::file("create", &folder))?;
        let mut run = self.same_run(&study, &names)?;
        let cases: Vec<(Kind, u64, PathBuf)> = (0..self.cases as usize)
            .map(|index| {
                let of_this = self.kind.get(index % self.kind.len().max(1));
                let kind = of_this.copied().unwrap_or_else(|| Kind::at(index));
                let seed = self.seed + index as u64;
                (kind, seed, folder.join(format!("{}-{seed}.json", kind.word())))
            })
            .collect();
        let mut known = Vec::new();
        for (_, _, path) in &cases {
            known.push(read(path)?);
        }
        let left = known.iter().filter(|case| case.is_none()).count();
        if left > 0 {
            progress.say(format_args!("{left} of {} cases to be diagnosed", self.cases));
            let known_turned = run.turned.take();
            let blind =
                Blind::new(&study, names.clone(), known_turned, progress).map_err(|e| self.failed(e))?;
            run.turned = Some(blind.turned.clone());
            self.note(&run)?;
            let done = AtomicUsize::new(0);
            cases
                .par_iter()
                .zip(&mut known)
                .filter(|(_, known)| known.is_none())
                .try_for_each(|((kind, seed, path), known)| {
                    let case = self.case(&blind, *kind, *seed, progress)?;
                    let text =
                        serde_json::to_string_pretty(&case).map_err(|error| Failure::Output(error.into()))?;
                    write_whole(path, text.as_bytes())?;
                    *known = Some(case);
                    let count = done.fetch_add(1, Ordering::Relaxed) + 1;
                    progress.say(format_args!("{count} of {left}: {} {seed}", kind.word()));
                    Ok::<(), Failure>(())
                })?;
        }
        let (mut outcomes, mut failed) = (Vec::new(), Vec::new());
        for case in known.into_iter().flatten() {
            match case {
                Case::Judged(outcome) => outcomes.push(*outcome),
                Case::Failed(reason) => failed.push(reason),
            }
        }
        let board: Scoreboard = scoreboard(&outcomes, &failed, run.turned.as_deref().unwrap_or_default());
        let page = page(&study.study.name, &board, &outcomes);
        let json = serde_json::to_string_pretty(&board).map_err(|error| Failure::Output(error.into()))?;
        write_whole(&self.output.join("scoreboard.md"), page.as_bytes())?;
        write_whole(&self.output.join("scoreboard.json"), json.as_bytes())?;
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
        let mut content = study.clone();
        content.path = PathBuf::new();
        let mut hash = DefaultHasher::new();
        format!("{content:?}{names:?}").hash(&mut hash);
        let run = Run {
            version: env!("CARGO_PKG_VERSION").to_string(),
            content: format!("{:016x}", hash.finish()),
            turned: None,
        };
        let path = self.run_file();
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => {
                self.note(&run)?;
                return Ok(run);
            }
            Err(error) => return Err(ExportError::file("read", path)(error).into()),
        };
        match serde_json::from_str::<Run>(&text) {
            Ok(known) if known.version == run.version && known.content == run.content => Ok(known),
            _ => Err(Failure::Option {
                option: "--output",
                reason: format!(
                    "{} holds cases of another study, other effects or another version; give another folder",
                    self.output.display()
                ),
            }),
        }
    }

    fn note(&self, run: &Run) -> Result<(), Failure> {
        let text = serde_json::to_string_pretty(run).map_err(|error| Failure::Output(error.into()))?;
        Ok(write_whole(&self.run_file(), text.as_bytes())?)
    }

    fn run_file(&self) -> PathBuf {
        self.output.join("run.json")
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

fn kind(word: &str) -> Result<Kind, String> {
    let known = Kind::ALL.into_iter().find(|kind| kind.word() == word);
    known.ok_or_else(|| {
        format!(
            "there is none; kinds are {}",
            Kind::ALL.map(Kind::word).join(", ")
        )
    })
}

/// A case that was done before; none if its file is not there or was written by another version.
fn read(path: &Path) -> Result<Option<Case>, Failure> {
    match std::fs::read_to_string(path) {
        Ok(text) => Ok(serde_json::from_str(&text).ok()),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ExportError::file("read", path)(error).into()),
    }
}
