//! `washout schema`: the JSON schema of a file or of an output, generated from the types.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::blind::Scoreboard;
use crate::diagnose::Plan;
use crate::effects::card::Card;
use crate::export::ExportError;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::difference::Difference;
use crate::export::modes::ModesSummary;
use crate::export::studies::studies_page;
use crate::export::study::StudyReport;
use crate::export::summary::RunSummary;
use crate::export::sweep::SweepSummary;
use crate::export::verification::VerifyReport;
use crate::synthesize::Answer;

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
            std::fs::write(path, studies_page()).map_err(ExportError::file("write", path))?;
        }
        let schema = match self.output {
            None if self.study => crate::input::schema::study_schema(),
            None if self.video => crate::input::schema::video_schema(),
            None => crate::input::schema::design_schema(),
            Some(Output::Solve) => schemars::schema_for!(RunSummary),
            Some(Output::Compare) => schemars::schema_for!(super::compare::CompareReport),
            Some(Output::Lift) => schemars::schema_for!(crate::export::lift::LiftSummary),
            Some(Output::Pareto) => schemars::schema_for!(crate::export::pareto::ParetoSummary),
            Some(Output::Sweep) => schemars::schema_for!(SweepSummary),
            Some(Output::Design) => schemars::schema_for!(crate::export::layouts::LayoutSummary),
            Some(Output::Divergence) => schemars::schema_for!(super::divergence::DivergenceReport),
            Some(Output::Diff) => schemars::schema_for!(Difference),
            Some(Output::Modes) => schemars::schema_for!(ModesSummary),
            Some(Output::Mesh) => schemars::schema_for!(super::mesh::MeshReport),
            Some(Output::Measure) => schemars::schema_for!(crate::export::video::MeasureReport),
            Some(Output::Study) => schemars::schema_for!(StudyReport),
            Some(Output::Diagnose) => schemars::schema_for!(DiagnosisReport),
            Some(Output::Add) => schemars::schema_for!(super::add::AddReport),
            Some(Output::Plan) => schemars::schema_for!(Plan),
            Some(Output::Synthesize) => schemars::schema_for!(super::synthesize::SynthesizeReport),
            Some(Output::Answer) => schemars::schema_for!(Answer),
            Some(Output::Blind) => schemars::schema_for!(Scoreboard),
            Some(Output::Effects) => schemars::schema_for!(Vec<Card>),
            Some(Output::Init) => schemars::schema_for!(super::init::InitReport),
            Some(Output::Doctor) => schemars::schema_for!(super::doctor::DoctorReport),
            Some(Output::Report) => schemars::schema_for!(super::report::ReportMade),
            Some(Output::Plot) => schemars::schema_for!(super::plot::Plotted),
            Some(Output::Export) => schemars::schema_for!(super::export::ExportReport),
            Some(Output::Verify) => schemars::schema_for!(VerifyReport),
        };
        console.document(&schema)
    }
}
