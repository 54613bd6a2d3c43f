//! Which effect a model lacks, how sure that is, and what else it could be.

pub mod added_variable;

pub mod baseline;

pub mod bump;

pub mod cache;

pub mod candidates;

mod columns;

pub mod data;

mod digits;

pub mod effect_row;

pub mod error;

pub mod evidence;

pub mod expected;

pub mod fields;

pub mod gains;

pub mod hypothesis;

pub mod interpolate;

pub mod judge;

pub mod ladder;

pub mod laws;

pub mod library;

pub mod misfit;

pub mod model_error;

mod naming;

pub mod next;

pub mod notes;

pub mod novel;

pub mod novel_words;

pub mod of_study;

pub mod pairs;

mod places;

pub mod plan;

pub mod posterior;

mod prepared;

pub mod refit;

pub mod report;

pub mod responses;

pub mod root;

mod root_edge;

pub mod robust;

pub mod scaling;

pub mod scatter;

pub mod screening;

pub mod settings;

pub mod steps;

pub mod strengths;

pub mod table;

pub mod unknown;

pub mod verdict;

pub mod weigh;

pub mod weights;

pub mod whitened;

pub mod words;

pub use cache::Cache;
pub use candidates::Candidates;
pub use error::DiagnoseError;
pub use next::Experiments;
pub use of_study::{StudyDiagnosis, plan_study};
pub use plan::{Plan, plan};
pub use settings::{PriorOdds, Settings};
pub use verdict::{Diagnosis, Verdict};

use crate::progress::Progress;
use crate::study::Forward;

use baseline::Baseline;
use judge::Judgement;
use table::Table;

/// Finds what the model lacks.
///
/// # Errors
/// If there is nothing to fit or no effect to try, a result is not finite, a fit does not settle, or the user asked
/// to stop.
///
/// # Example
/// ```
/// # use washout_study as washout;
/// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
/// # use std::path::Path;
/// # use washout::{input::study::LoadedStudy, progress::Progress, study::Campaign};
/// use washout::diagnose::{Settings, Verdict, diagnose};
///
/// let (quiet, tried) = (Progress::quiet(), ["root-flexure", "rod-creep"]);
/// let study = LoadedStudy::load(Path::new("studies/minguet.toml"), &[])?;
/// let campaign = Campaign::new(&study, &tried, &quiet)?;
/// let diagnosis = diagnose(&campaign, &Settings::default(), &quiet)?;
/// println!("{:?}", diagnosis.verdict);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn diagnose(
    forward: &dyn Forward,
    settings: &Settings,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    diagnose_with(forward, None, None, settings, progress)
}

/// The same, and which of the conditions of `candidates` (a model with unknowns of the same names) to measure next; `table`: how the
/// campaign answers, if that is known.
///
/// # Errors
/// As [`diagnose`].
pub fn diagnose_with(
    forward: &dyn Forward,
    candidates: Option<&dyn Forward>,
    table: Option<&Table>,
    settings: &Settings,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    let experiments = candidates.map_or(Experiments::Unknown, Experiments::Listed);
    diagnose_among(forward, experiments, table, settings, progress)
}

/// The same of any experiments: those of a study, or those that can be added to it.
///
/// # Errors
/// As [`diagnose`].
pub fn diagnose_among(
    forward: &dyn Forward,
    experiments: Experiments,
    table: Option<&Table>,
    settings: &Settings,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    let (baseline, judgement) = judged(forward, settings, table, progress)?;
    report::report(&baseline, &judgement, experiments, progress)
}

/// The model as it is, and everything that was weighed against it: what a report is made of; `table`: how the campaign
/// answers, if that is known.
///
/// # Errors
/// As [`diagnose`].
pub fn judged<'a>(
    forward: &'a dyn Forward,
    settings: &'a Settings,
    table: Option<&Table>,
    progress: &Progress,
) -> Result<(Baseline<'a>, Judgement), DiagnoseError> {
    let baseline = Baseline::new(forward, settings, table, progress)?;
    let judgement = judge::judge(&baseline, progress)?;
    Ok((baseline, judgement))
}
