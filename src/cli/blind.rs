//! `washout blind`: many diagnoses whose answer is known, and the scoreboard.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use clap::Args;

use crate::blind::{Blind, BlindError, Kind, Outcome, Scoreboard, scoreboard};
use crate::diagnose::DiagnoseError;
use crate::export::ExportError;
use crate::export::blind::page;
use crate::export::file::write_whole;
use crate::input::study::LoadedStudy;
use crate::study::StudyError;

use super::diagnose::candidates;
use super::{Console, Failure};

/// Arguments of `washout blind`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout blind 12                              a dozen cases of all kinds
  washout blind 290 --output night              150 without anything missing, 60 single, 30 pairs, 30 novel, 20 twins
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
        let mut outcomes: Vec<Outcome> = Vec::new();
        let mut blind: Option<Blind> = None;
        self.same_run(&study, &names)?;
        for index in 0..self.cases as usize {
            let (kind, seed) = (Kind::at(index), self.seed + index as u64);
            let path = folder.join(format!("{}-{seed}.json", kind.word()));
            if let Some(known) = read(&path)? {
                outcomes.push(known);
                continue;
            }
            let started = match &blind {
                Some(blind) => blind,
                None => {
                    let new = Blind::new(&study, names.clone(), progress).map_err(|e| self.failed(e))?;
                    blind.insert(new)
                }
            };
            progress.say(format_args!(
                "case {} of {}: {}",
                index + 1,
                self.cases,
                kind.word()
            ));
            let outcome = started
                .case(kind, seed, &progress.unseen())
                .map_err(|error| self.failed(error))?;
            let text =
                serde_json::to_string_pretty(&outcome).map_err(|error| Failure::Output(error.into()))?;
            write_whole(&path, text.as_bytes())?;
            outcomes.push(outcome);
        }
        let board: Scoreboard = scoreboard(&outcomes);
        let page = page(&study.study.name, &board, &outcomes);
        let json = serde_json::to_string_pretty(&board).map_err(|error| Failure::Output(error.into()))?;
        write_whole(&self.output.join("scoreboard.md"), page.as_bytes())?;
        write_whole(&self.output.join("scoreboard.json"), json.as_bytes())?;
        console.result(&page, &board)
    }

    /// Refuses a folder that holds the cases of another run: their figures must not be added up.
    fn same_run(&self, study: &LoadedStudy, names: &[&str]) -> Result<(), Failure> {
        let mut content = study.clone();
        content.path = PathBuf::new();
        let mut hash = DefaultHasher::new();
        format!("{content:?}{names:?}").hash(&mut hash);
        let key = format!(
            "washout {}, content {:016x}\n",
            env!("CARGO_PKG_VERSION"),
            hash.finish()
        );
        let path = self.output.join("run.txt");
        match std::fs::read_to_string(&path) {
            Ok(known) if known == key => Ok(()),
            Ok(_) => Err(Failure::Option {
                option: "--output",
                reason: format!(
                    "{} holds cases of another study, other effects or another version; give another folder",
                    self.output.display()
                ),
            }),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(write_whole(&path, key.as_bytes())?),
            Err(error) => Err(ExportError::file("read", path)(error).into()),
        }
    }

    fn failed(&self, error: BlindError) -> Failure {
        match error {
            BlindError::Diagnosis(DiagnoseError::Cancelled(cancelled))
            | BlindError::Study(StudyError::Cancelled(cancelled)) => cancelled.into(),
            source => Failure::Blind {
                study: self.study.clone(),
                source,
            },
        }
    }
}

/// A case that was done before; none if its file is not there or was written by another version.
fn read(path: &Path) -> Result<Option<Outcome>, Failure> {
    match std::fs::read_to_string(path) {
        Ok(text) => Ok(serde_json::from_str(&text).ok()),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ExportError::file("read", path)(error).into()),
    }
}
