//! `washout explain`: what it would take to bring a few readings within their scatter.

use std::path::PathBuf;

use clap::Args;

use crate::diagnose::Cache;
use crate::diagnose::candidates::known;
use crate::explain::{
    Answers, Choice, ExplainError, Explanation, Model, Prepared, Settings, choices, explain,
};
use crate::export::explanation::{ExplanationReport, page};
use crate::export::pictures::write::add_explained;
use crate::export::run::RunFolder;
use crate::input::study::LoadedStudy;
use crate::program::MadeOf;

use super::diagnose::candidates;
use super::written::target;
use super::{Console, Failure};

/// The document that lists the files of an explanation.
pub const EXPLANATION: &str = "explain.json";

/// Arguments of `washout explain`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout explain studies/paper-twist.toml --set mesh.refine=0.5
  # these effects only
  washout explain my-study.toml --effect root-flexure --effect camera-tilt
  # at most two changes at once
  washout explain my-study.toml --most 2
  washout explain my-study.toml --json | jq '.sets[0].name'

For a handful of numbers that the model misses: the least implausible sets of changes, within what is plausible for each, that bring every reading within its scatter. Changes are effects of the library, numbers that designs assume or the study holds uncertain, nuisances of the ruler, words that designs assume, and the tables [[alternative]] of the study. For each set: what it says of every reading, how far each number is into its range, what it predicts, and the cheapest readings that would refute it. No set is a proof. docs/what-would-explain-it.md says what a set costs and how they are found. Writes output/NAME-explain/: explain.txt, all that is said, and explain.json. How the model answers to every change alone is kept in the cache folder of the user, as for diagnose.")]
pub struct Explain {
    /// The study
    pub study: PathBuf,
    /// Change a key in every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Try this effect; can be given many times [default: those that the study names, or all that can act]
    #[arg(long, value_name = "NAME")]
    pub effect: Vec<String>,
    /// Most changes of a set
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(1..=4))]
    pub most: u8,
    /// Folder to write into [default: output/NAME-explain]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

impl Explain {
    /// Explains and writes.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let study = self.subject()?;
        let target = target(self.output.as_ref(), &study.study.name, "explain");
        let mut folder = RunFolder::listed_by(&target, "explain", EXPLANATION)?;
        let mut report = self.report(&study, console)?;
        let answer = page(&study.study.name, &report.explanation);
        folder.add("explain.txt", answer.text().as_bytes())?;
        add_explained(&mut folder, &study.study.name, &report.explanation)?;
        report.files = folder.listed_with(false);
        folder.add_summary(&report)?;
        console.progress().check()?;
        let written = folder.commit()?;
        console.answer(&answer, &console.listed(&written, &report.files), &report)
    }

    fn subject(&self) -> Result<LoadedStudy, Failure> {
        known(&self.effect).map_err(|error| Failure::of_diagnosis(&self.study, error))?;
        Ok(LoadedStudy::load(&self.study, &self.set)?)
    }

    fn report(&self, study: &LoadedStudy, console: &Console) -> Result<ExplanationReport, Failure> {
        let names = candidates(study, &self.effect, console)?.names;
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let all = choices(study, &self.set)?;
        let found = self.explained(all, &names, console);
        Ok(ExplanationReport {
            explanation: found.map_err(|source| Failure::Explanation {
                study: self.study.clone(),
                source,
            })?,
            made_of: MadeOf::files(&study.files),
            files: Vec::new(),
        })
    }

    fn explained(
        &self,
        all: Vec<Choice>,
        names: &[&str],
        console: &Console,
    ) -> Result<Explanation, ExplainError> {
        let progress = console.progress();
        let count = all.len();
        let (mut prepared, mut left_out): (Vec<Prepared>, Vec<String>) = (Vec::new(), Vec::new());
        for (place, choice) in all.into_iter().enumerate() {
            progress.say(format_args!(
                "choice {} of {count} of words and alternatives",
                place + 1
            ));
            let model = match Model::new(&choice.study, names, &progress.unseen()) {
                Ok(model) => model,
                // another word may leave the wing without an equilibrium: then it explains nothing
                Err(error) if place > 0 && error.exit_code() == 3 => {
                    let names = choice.flipped.iter().map(|own| own.name.as_str());
                    let names = names.collect::<Vec<_>>().join(" + ");
                    left_out.push(format!("Left out: {names}: {error}"));
                    continue;
                }
                Err(error) => return Err(error.into()),
            };
            let answers = Answers::kept(&model, &Cache::of_user(), &progress.unseen())?;
            prepared.push(Prepared {
                choice,
                model,
                answers,
            });
        }
        let settings = Settings {
            most_changes: usize::from(self.most),
            ..Settings::default()
        };
        let mut found = explain(&prepared, names, &settings, progress)?;
        found.notes.extend(left_out);
        Ok(found)
    }
}
