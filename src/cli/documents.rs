//! The JSON documents that verbs print.

use crate::blind::Scoreboard;
use crate::diagnose::Plan;
use crate::effects::card::Card;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::difference::Difference;
use crate::export::modes::ModesSummary;
use crate::export::study::StudyReport;
use crate::export::summary::RunSummary;
use crate::export::sweep::SweepSummary;
use crate::export::verification::VerifyReport;
use crate::synthesize::Answer;
use clap::ValueEnum;

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
            Output::Divergence => schemars::schema_for!(crate::wing::divergence::DivergenceReport),
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
