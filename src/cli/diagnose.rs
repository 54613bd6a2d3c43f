//! `washout diagnose`: which physics the model of a study lacks, and how sure that is.

use std::path::PathBuf;

use clap::Args;

use crate::diagnose::{DiagnoseError, Diagnosis, Settings, diagnose_with};
use crate::effects::all;
use crate::export::diagnosis::{DiagnosisReport, page};
use crate::export::pictures::write::add_diagnosis;
use crate::export::plan::page as page_of_plan;
use crate::export::run::RunFolder;
use crate::input::study::LoadedStudy;
use crate::study::{Campaign, Forward, Work};

use super::study::{listed, target};
use super::{Console, Failure};

/// The document that lists the files of a diagnosis.
const DIAGNOSIS: &str = "diagnosis.json";

/// Arguments of `washout diagnose`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout diagnose studies/pre-pazy-skin.toml
  washout diagnose my-study.toml --effect root-flexure --effect tip-loss-prandtl       these two only
  washout diagnose my-study.toml --plan                  before any measurement: what could be seen, what told apart
  washout diagnose my-study.toml --json | jq .verdict

The verdict comes first, in one sentence; then what it rests on. With tables [[experiment]] in the study (as [[case]], the
values of their measurement files empty) it says which of them to make next.
Writes output/NAME-diagnosis/: effects against the residual, residuals in sigma, the error step by step and what is
missing as pictures (SVG), with the numbers behind each (CSV); diagnosis.json. With --plan it writes no files.")]
pub struct Diagnose {
    /// The study
    pub study: PathBuf,
    /// Change a key in every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Try this effect; can be given many times [default: those that the study names, or all that can act]
    #[arg(long, value_name = "NAME")]
    pub effect: Vec<String>,
    /// Probability of a false alarm that is accepted where nothing is missing
    #[arg(long, value_name = "P", default_value_t = 0.01)]
    pub significance: f64,
    /// Judge the campaign instead of its measurements, whose values may still be missing
    #[arg(long)]
    pub plan: bool,
    /// Diagnose even data that were made by washout synthesize with the meshes, formulas or seed used here
    #[arg(long)]
    pub own_data: bool,
    /// Seed of the draws of noise
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Folder to write into [default: output/NAME-diagnosis]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

impl Diagnose {
    /// Diagnoses.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let progress = console.progress();
        let study = match self.plan {
            true => LoadedStudy::load_planned(&self.study, &self.set)?,
            false => LoadedStudy::load(&self.study, &self.set)?,
        };
        self.refuse_own_word(&study)?;
        let target = target(self.output.as_ref(), &study.study.name, "diagnosis");
        // A plan is words only.
        let folder = (!self.plan)
            .then(|| RunFolder::listed_by(&target, DIAGNOSIS))
            .transpose()?;
        let fault = |source: DiagnoseError| Failure::Diagnosis {
            study: self.study.clone(),
            source,
        };
        let names = candidates(&study, &self.effect);
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let campaign = Campaign::new(&study, &names, progress).map_err(|error| fault(error.into()))?;
        let settings = Settings {
            slop: campaign.slop,
            start: Some(campaign.start()),
            significance: self.significance,
            seed: self.seed,
            ..Settings::default()
        };
        if self.plan {
            let plan = crate::diagnose::plan(&campaign, &settings, progress).map_err(fault)?;
            return console.result(&page_of_plan(&campaign.name, &plan), &plan);
        }
        let experiments = Campaign::of_experiments(&study, &names, progress);
        let experiments = experiments.map_err(|error| fault(error.into()))?;
        let candidates = experiments.as_ref().map(|campaign| campaign as &dyn Forward);
        let diagnosis = diagnose_with(&campaign, candidates, &settings, progress).map_err(fault)?;
        self.written(&campaign.name, diagnosis, campaign.work(), folder, console)
    }

    fn written(
        &self,
        study: &str,
        diagnosis: Diagnosis,
        work: Work,
        folder: Option<RunFolder>,
        console: &Console,
    ) -> Result<(), Failure> {
        let mut report = DiagnosisReport {
            diagnosis,
            work,
            files: Vec::new(),
        };
        let mut text = format!("{}\n{work}\n", page(study, &report.diagnosis));
        if let Some(mut folder) = folder {
            add_diagnosis(&mut folder, study, &report.diagnosis)?;
            report.files = folder.listed();
            folder.add_summary(&report)?;
            console.progress().check()?;
            let written = folder.commit()?;
            text.push_str(&format!("\n{}", listed(&written, &report.files)));
        }
        console.result(&text, &report)
    }

    fn refuse_own_word(&self, study: &LoadedStudy) -> Result<(), Failure> {
        let own = study
            .cases
            .iter()
            .find_map(|case| Some((case, case.made?.is_own_word(self.seed)?)));
        match own {
            Some((case, what)) if !self.own_data && !self.plan => Err(Failure::OwnWord {
                study: self.study.clone(),
                case: case.name.clone(),
                what,
            }),
            _ => Ok(()),
        }
    }
}

/// Effects to be tried: those asked for, those that the study names, or all.
pub fn candidates(study: &LoadedStudy, asked: &[String]) -> Vec<String> {
    match (asked, &study.study.candidates) {
        ([], None) => all().map(|effect| effect.card().name.to_string()).collect(),
        ([], Some(named)) => named.clone(),
        (asked, _) => asked.to_vec(),
    }
}
