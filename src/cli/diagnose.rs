//! `washout diagnose`: which physics the model of a study lacks, and how sure that is.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::diagnose::{DiagnoseError, Diagnosis, Settings, diagnose_with};
use crate::effects::all;
use crate::export::diagnosis::{DiagnosisReport, page};
use crate::export::html::{self, REPORT};
use crate::export::pictures::write::add_diagnosis;
use crate::export::plan::page as page_of_plan;
use crate::export::run::RunFolder;
use crate::input::study::LoadedStudy;
use crate::study::{Campaign, Forward};

use super::study::{listed, target};
use super::{Console, Failure};

/// The document that lists the files of a diagnosis.
pub const DIAGNOSIS: &str = "diagnosis.json";

/// Arguments of `washout diagnose`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout diagnose studies/pre-pazy-skin.toml
  washout diagnose my-study.toml --effect root-flexure --effect tip-loss-prandtl       these two only
  washout diagnose my-study.toml --plan                  before any measurement: what could be seen, what told apart
  washout diagnose my-study.toml --report                report.html besides: the wings with and without what is found
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
    /// Write report.html besides: the wings without and with what is found, pictures and tables in one file for a browser
    #[arg(long, conflicts_with = "plan")]
    pub report: bool,
}

impl Diagnose {
    /// Diagnoses.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let progress = console.progress();
        let study = match self.plan {
            true => LoadedStudy::load_planned(&self.study, &self.set)?,
            false => LoadedStudy::load(&self.study, &self.set)?,
        };
        if !self.own_data && !self.plan {
            refuse_own_word(&self.study, &study, self.seed)?;
        }
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
        self.written(&campaign, diagnosis, folder, console)
    }

    fn written(
        &self,
        campaign: &Campaign,
        diagnosis: Diagnosis,
        folder: Option<RunFolder>,
        console: &Console,
    ) -> Result<(), Failure> {
        let (study, work) = (campaign.name.as_str(), campaign.work());
        let mut report = DiagnosisReport {
            diagnosis,
            work,
            files: Vec::new(),
        };
        let mut text = format!("{}\n{work}\n", page(study, &report.diagnosis));
        if let Some(mut folder) = folder {
            add_diagnosis(&mut folder, study, &report.diagnosis)?;
            report.files = folder.listed();
            if self.report {
                report.files.insert(report.files.len() - 1, REPORT.to_string());
                let wings = super::study::found(campaign, &report.diagnosis, console)?;
                let page = html::diagnosis::page(study, &report, &wings)?;
                folder.add(REPORT, page.html().as_bytes())?;
            }
            folder.add_summary(&report)?;
            console.progress().check()?;
            let written = folder.commit()?;
            text.push_str(&format!("\n{}", listed(&written, &report.files)));
        }
        console.result(&text, &report)
    }
}

/// Data that were made with what the diagnosis itself would use prove nothing.
fn refuse_own_word(path: &Path, study: &LoadedStudy, seed: u64) -> Result<(), Failure> {
    let own = study
        .cases
        .iter()
        .find_map(|case| Some((case, case.made?.is_own_word(seed)?)));
    match own {
        Some((case, what)) => Err(Failure::OwnWord {
            study: path.to_path_buf(),
            case: case.name.clone(),
            what,
        }),
        None => Ok(()),
    }
}

/// A study diagnosed as `washout diagnose STUDY` does it, with the campaign that it was diagnosed by.
pub fn diagnosed(
    path: &Path,
    study: &LoadedStudy,
    console: &Console,
) -> Result<(Campaign, DiagnosisReport), Failure> {
    let progress = console.progress();
    let settings = Settings::default();
    refuse_own_word(path, study, settings.seed)?;
    let fault = |source: DiagnoseError| Failure::Diagnosis {
        study: path.to_path_buf(),
        source,
    };
    let names = candidates(study, &[]);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let campaign = Campaign::new(study, &names, progress).map_err(|error| fault(error.into()))?;
    let settings = Settings {
        slop: campaign.slop,
        start: Some(campaign.start()),
        ..settings
    };
    let experiments = Campaign::of_experiments(study, &names, progress);
    let experiments = experiments.map_err(|error| fault(error.into()))?;
    let next = experiments.as_ref().map(|campaign| campaign as &dyn Forward);
    let diagnosis = diagnose_with(&campaign, next, &settings, progress).map_err(fault)?;
    let report = DiagnosisReport {
        diagnosis,
        work: campaign.work(),
        files: Vec::new(),
    };
    Ok((campaign, report))
}

/// Effects to be tried: those asked for, those that the study names, or all.
pub fn candidates(study: &LoadedStudy, asked: &[String]) -> Vec<String> {
    match (asked, &study.study.candidates) {
        ([], None) => all().map(|effect| effect.card().name.to_string()).collect(),
        ([], Some(named)) => named.clone(),
        (asked, _) => asked.to_vec(),
    }
}
