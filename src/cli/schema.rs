//! `washout schema`: the JSON schema of a file or of an output, generated from the types.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::blind::Scoreboard;
use crate::diagnose::Plan;
use crate::effects::card::Card;
use crate::export::ExportError;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::difference::Difference;
use crate::export::file::write_page;
use crate::export::modes::ModesSummary;
use crate::export::studies::studies_page;
use crate::export::study::StudyReport;
use crate::export::summary::RunSummary;
use crate::export::sweep::SweepSummary;
use crate::export::verification::VerifyReport;
use crate::synthesize::Answer;

use super::reference::reference_pages;
use super::{Console, Failure};

/// Arguments of `washout schema`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout schema > design.schema.json           of design files, for editors
  washout schema --output                       of `washout solve --json` and summary.json
  washout schema --study                        of study files
  washout schema --video                        of video files
  washout schema --output diff                  of `washout diff --json`")]
pub struct Schema {
    /// Of the JSON document that a verb prints, instead of design files
    #[arg(long, value_name = "VERB", num_args = 0..=1, default_missing_value = "solve")]
    pub output: Option<Output>,
    /// Of study files, instead of design files
    #[arg(long, conflicts_with = "output")]
    pub study: bool,
    /// Of video files for `washout measure`, instead of design files
    #[arg(long, conflicts_with_all = ["output", "study"])]
    pub video: bool,
    /// Write the page of documentation on study files
    #[arg(long, value_name = "FILE", requires = "study")]
    pub page: Option<PathBuf>,
    /// Write the reference pages of the documentation into this folder: design, measurement, video, outputs, commands
    #[arg(long, value_name = "DIR", conflicts_with_all = ["output", "study", "video"])]
    pub pages: Option<PathBuf>,
}

/// Verbs whose JSON document has a schema.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Output {
    /// `washout solve --json`, and `summary.json`
    Solve,
    /// `washout compare --json`
    Compare,
    /// `washout lift --json`
    Lift,
    /// `washout pareto --json`
    Pareto,
    /// `washout sweep --json`
    Sweep,
    /// `washout design --json`
    Design,
    /// `washout divergence --json`
    Divergence,
    /// `washout diff --json`
    Diff,
    /// `washout modes --json`
    Modes,
    /// `washout mesh --json`
    Mesh,
    /// `washout measure --json`
    Measure,
    /// `washout init --json`
    Init,
    /// `washout doctor --json`
    Doctor,
    /// `washout compare STUDY --json`
    Study,
    /// `washout diagnose --json`
    Diagnose,
    /// `washout add --json`
    Add,
    /// `washout diagnose --plan --json`
    Plan,
    /// `washout synthesize --json`
    Synthesize,
    /// answer.json of `washout synthesize`
    Answer,
    /// `washout blind --json`
    Blind,
    /// `washout effects --json`: a list; of one effect its item
    Effects,
    /// `washout report --json`
    Report,
    /// `washout plot --json`, and `plot.json`
    Plot,
    /// `washout export --json`
    Export,
    /// `washout verify --json`, and `verify.json`
    Verify,
}

impl Schema {
    /// Prints the schema.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        if let Some(path) = &self.page {
            write_page(path, &studies_page())?;
        }
        if let Some(folder) = &self.pages {
            return self.write_pages(folder, console);
        }
        let schema = match self.output {
            None if self.study => crate::input::schema::study_schema(),
            None if self.video => crate::input::schema::video_schema(),
            None => crate::input::schema::design_schema(),
            Some(output) => output.schema(),
        };
        console.document(&schema)
    }

    fn write_pages(&self, folder: &Path, console: &Console) -> Result<(), Failure> {
        std::fs::create_dir_all(folder).map_err(ExportError::file("create", folder))?;
        let mut written = Vec::new();
        for (name, page) in reference_pages() {
            let path = folder.join(name);
            write_page(&path, &page)?;
            written.push(path.display().to_string());
        }
        console.result(&(written.join("\n") + "\n"), &written)
    }
}

impl Output {
    /// The schema of the document.
    pub fn schema(self) -> schemars::Schema {
        match self {
            Output::Solve => schemars::schema_for!(RunSummary),
            Output::Compare => schemars::schema_for!(super::compare::CompareReport),
            Output::Lift => schemars::schema_for!(crate::export::lift::LiftSummary),
            Output::Pareto => schemars::schema_for!(crate::export::pareto::ParetoSummary),
            Output::Sweep => schemars::schema_for!(SweepSummary),
            Output::Design => schemars::schema_for!(crate::export::layouts::LayoutSummary),
            Output::Divergence => schemars::schema_for!(super::divergence::DivergenceReport),
            Output::Diff => schemars::schema_for!(Difference),
            Output::Modes => schemars::schema_for!(ModesSummary),
            Output::Mesh => schemars::schema_for!(super::mesh::MeshReport),
            Output::Measure => schemars::schema_for!(crate::export::video::MeasureReport),
            Output::Study => schemars::schema_for!(StudyReport),
            Output::Diagnose => schemars::schema_for!(DiagnosisReport),
            Output::Add => schemars::schema_for!(super::add::AddReport),
            Output::Plan => schemars::schema_for!(Plan),
            Output::Synthesize => schemars::schema_for!(super::synthesize::SynthesizeReport),
            Output::Answer => schemars::schema_for!(Answer),
            Output::Blind => schemars::schema_for!(Scoreboard),
            Output::Effects => schemars::schema_for!(Vec<Card>),
            Output::Init => schemars::schema_for!(super::init::InitReport),
            Output::Doctor => schemars::schema_for!(super::doctor::DoctorReport),
            Output::Report => schemars::schema_for!(super::report::ReportMade),
            Output::Plot => schemars::schema_for!(super::plot::Plotted),
            Output::Export => schemars::schema_for!(super::export::ExportReport),
            Output::Verify => schemars::schema_for!(VerifyReport),
        }
    }
}
