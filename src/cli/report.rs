//! `washout report`: one HTML file of a run or a study, for a browser or a printer.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::compare::ComparedStudy;
use crate::export::added::{self, AddReport};
use crate::export::compare_report::CompareReport;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::file::refuse_other;
use crate::export::html::cases::{at_work, explained};
use crate::export::html::effects::EffectsAtWork;
use crate::export::html::folder::{Contents, page, title_of};
use crate::export::html::study::StudyParts;
use crate::export::html::wings::Wings;
use crate::export::html::{Document, Page, REPORT, compared, diagnosis, is_report, run, study};
use crate::export::json::Document as _;
use crate::export::layouts::LayoutSummary;
use crate::export::lift::LiftSummary;
use crate::export::modes::ModesSummary;
use crate::export::pareto::ParetoSummary;
use crate::export::run::{SUMMARY, read_summary, write_member};
use crate::export::study::StudyReport;
use crate::export::summary::RunSummary;
use crate::export::verification::VerifyReport;
use crate::export::{ExportError, json};
use crate::input::study::LoadedStudy;
use crate::page::Page as Answer;
use crate::page::text::hanging;

use super::add::LADDER;
use super::compare::COMPARISON;
use super::verify::DOCUMENT as VERIFY;
use super::{Console, Failure};

/// What may be written over by a report.
const A_REPORT: &str = "a report of washout";

/// Arguments of `washout report`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout solve designs/twist-v2.toml
  # output/twist-v2/report.html
  washout report output/twist-v2
  # solved, compared, and every wing before and after calibration
  washout report studies/paper-wings.toml
  # what the model lacks besides
  washout report studies/paper-wings.toml --diagnose
  # the same as the first two in one
  washout solve designs/twist-v2.toml --report

A run is the folder that solve, compare, diagnose, add, lift, pareto, design, modes, sweep or verify wrote; each of them takes --report too. The file needs no network and no other file; what is not 3D is there without JavaScript too. The documents that its numbers come from stand in it, for programs.")]
pub struct Report {
    /// Folder of a run, or a study file
    #[arg(value_name = "RUN|STUDY")]
    pub what: PathBuf,
    /// Diagnose the study besides
    #[arg(long)]
    pub diagnose: bool,
    /// Change a key in every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// File to write [default: report.html in the folder of the run; output/NAME-report.html of a study]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// What `washout report` prints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReportMade {
    /// The file.
    pub file: String,
    /// Its size.
    pub bytes: usize,
    /// Its sections, in their order.
    pub sections: Vec<String>,
}

impl Report {
    /// Makes the report.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let (page, path) = if self.what.is_dir() {
            self.refuse_options()?;
            let path = self.path(self.what.join(REPORT))?;
            (of_folder(&self.what)?, path)
        } else {
            let loaded = self.study()?;
            let name = format!("{}-{REPORT}", loaded.study.name);
            let path = self.path(PathBuf::from("output").join(name))?;
            (self.of_study(&loaded, console)?, path)
        };
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(ExportError::file("create", folder))?;
        }
        let html = page.html();
        console.progress().check()?;
        write_member(&path, html.as_bytes(), A_REPORT, is_report)?;
        let shown = page.sections.iter().filter(|section| !section.html.is_empty());
        let made = ReportMade {
            file: path.display().to_string(),
            bytes: html.len(),
            sections: shown.map(|section| section.title.to_string()).collect(),
        };
        let kilobytes = made.bytes.div_ceil(1000);
        let sections = made.sections.join(", ");
        let report = hanging(
            "",
            &format!("Report in {} ({kilobytes} kB): {sections}", made.file),
            2,
        );
        let text = format!("{}\n\n{report}", page.title);
        console.result(&text, &made)
    }

    /// Options that a folder has no use for.
    fn refuse_options(&self) -> Result<(), Failure> {
        let others = [("--diagnose", self.diagnose), ("--set", !self.set.is_empty())];
        match others.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(()),
            Some((option, _)) => Err(Failure::Option {
                option,
                reason: "belongs to a study; a run is reported as it was solved".to_string(),
            }),
        }
    }

    /// Where the report goes; refused before anything is computed if something else stands there.
    fn path(&self, default: PathBuf) -> Result<PathBuf, Failure> {
        let path = self.output.clone().unwrap_or(default);
        refuse_other(&path, A_REPORT, is_report)?;
        Ok(path)
    }

    fn study(&self) -> Result<LoadedStudy, Failure> {
        if !LoadedStudy::is_study(&self.what)? {
            return Err(Failure::NothingToShow {
                path: self.what.clone(),
                reason: format!(
                    "a design; a report is made of a run or a study. Try: washout solve {} --report",
                    self.what.display()
                ),
            });
        }
        Ok(LoadedStudy::load(&self.what, &self.set)?)
    }

    fn of_study(&self, loaded: &LoadedStudy, console: &Console) -> Result<Page, Failure> {
        let progress = console.progress();
        let compared = ComparedStudy::new(loaded, progress);
        let compared = compared.map_err(|source| Failure::OfStudy {
            study: self.what.clone(),
            source,
        })?;
        let diagnosed = self
            .diagnose
            .then(|| super::diagnose::diagnosed(loaded, console))
            .transpose()?;
        let mut parts = StudyParts::new(&compared, loaded, progress)?;
        if let Some(found) = diagnosed {
            let explained = explained(&found.campaign, &found.diagnosis, progress)?;
            parts.wings.extend(explained);
            let at_work = at_work(&found.campaign, &found.diagnosis, progress)?;
            let report = DiagnosisReport::new(found.diagnosis, found.work, loaded);
            parts.diagnosis = Some((report, at_work));
        }
        Ok(study::page(
            &StudyReport::new(compared.comparison, loaded),
            &parts,
        )?)
    }
}

/// The report of the folder of a run.
fn of_folder(folder: &Path) -> Result<Page, Failure> {
    let comparison = folder.join(COMPARISON);
    let diagnosed = folder.join(super::diagnose::DIAGNOSIS);
    let read = |name: &str| {
        let path = folder.join(name);
        fs::read(&path).map_err(ExportError::file("read", path))
    };
    if comparison.is_file() {
        let document: Value = read_document(&comparison)?;
        return match json::kind(&document) {
            Some(kind) if kind == CompareReport::KIND => {
                Ok(compared::page_alone(&known(&document, &comparison)?)?)
            }
            _ => Ok(study::page(
                &known(&document, &comparison)?,
                &StudyParts::default(),
            )?),
        };
    }
    if diagnosed.is_file() {
        let report: DiagnosisReport = read_document(&diagnosed)?;
        let name = folder.file_name().map(|name| name.to_string_lossy().into_owned());
        let name = name.unwrap_or_default();
        let study = name.strip_suffix("-diagnosis").unwrap_or(&name);
        return Ok(diagnosis::page(
            study,
            &report,
            &Wings::default(),
            &EffectsAtWork::default(),
        )?);
    }
    for (name, id) in [(SUMMARY, "summary"), (LADDER, "ladder"), (VERIFY, "verify")] {
        if !folder.join(name).is_file() {
            continue;
        }
        let document = read_document(&folder.join(name))?;
        let kind = json::kind(&document).unwrap_or(RunSummary::KIND);
        if kind == RunSummary::KIND {
            return Ok(run::of_files(&read_summary(folder)?, folder, &read)?);
        }
        let answer = answer(kind, &document, folder)?;
        let contents = Contents {
            title: &title_of(folder),
            answer: answer.as_ref(),
            files: &shown(folder)?,
            document: Document::of(id, document),
        };
        return Ok(page(contents, &read)?);
    }
    Err(Failure::NothingToShow {
        path: folder.to_path_buf(),
        reason: "no run: none of the documents that washout writes is in it; give the folder that washout solve, compare, diagnose, \
                 lift or another verb wrote, or a study file"
            .to_string(),
    })
}

/// What the verb says that wrote a document of this kind; none of a sweep, of which it says what stands in another file.
fn answer(kind: &str, document: &Value, folder: &Path) -> Result<Option<Answer>, Failure> {
    Ok(Some(match kind {
        LiftSummary::KIND => known::<LiftSummary>(document, folder)?.page(),
        ParetoSummary::KIND => known::<ParetoSummary>(document, folder)?.page(),
        LayoutSummary::KIND => known::<LayoutSummary>(document, folder)?.page(),
        ModesSummary::KIND => known::<ModesSummary>(document, folder)?.page(),
        VerifyReport::KIND => known::<VerifyReport>(document, folder)?.page(),
        AddReport::KIND => added::page(&known(document, folder)?),
        _ => return Ok(None),
    }))
}

/// A document as what its kind says it is.
fn known<T: DeserializeOwned>(document: &Value, path: &Path) -> Result<T, Failure> {
    json::of(document).map_err(|error| foreign(path, &error))
}

/// The pictures and tables of a folder, by name.
fn shown(folder: &Path) -> Result<Vec<String>, Failure> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(ExportError::file("read", folder))? {
        let name = entry.map_err(ExportError::file("read", folder))?.file_name();
        files.push(name.to_string_lossy().into_owned());
    }
    files.sort();
    Ok(files)
}

fn read_document<T: DeserializeOwned>(path: &Path) -> Result<T, Failure> {
    let text = fs::read_to_string(path).map_err(ExportError::file("read", path))?;
    json::read(text.as_bytes()).map_err(|error| foreign(path, &error))
}

fn foreign(path: &Path, error: &serde_json::Error) -> Failure {
    Failure::Export(ExportError::ForeignSummary {
        path: path.to_path_buf(),
        reason: error.to_string(),
    })
}
