//! Which effect a model lacks, how sure that is, and what else it could be.

pub mod added_variable;

pub mod baseline;

pub mod conclude;

pub mod data;

pub mod error;

pub mod evidence;

pub mod far;

pub mod fields;

pub mod foretold;

pub mod hump;

pub mod judge;

pub mod ladder;

pub mod laws;

pub mod library;

pub mod misfit;

pub mod next;

pub mod notes;

pub mod novel;

pub mod novel_words;

pub mod null;

pub mod pairs;

pub mod plan;

pub mod posterior;

pub mod prior;

pub mod refit;

pub mod report;

pub mod robust;

pub mod rough;

pub mod rows;

pub mod scaling;

pub mod screening;

pub mod second_look;

pub mod settings;

pub mod strength_error;

pub mod verdict;

pub mod whitened;

pub mod words;

pub use error::DiagnoseError;
pub use plan::{Plan, plan};
pub use settings::{PriorOdds, Settings};
pub use verdict::{Diagnosis, Verdict};

use crate::progress::Progress;
use crate::study::Forward;

use baseline::{Baseline, Shared};
use judge::Judgement;

/// Finds what the model lacks.
///
/// # Errors
/// If there is nothing to fit or no effect to try, a result is not finite, a fit does not settle, or the user asked
/// to stop.
pub fn diagnose(
    forward: &dyn Forward,
    settings: &Settings,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    diagnose_with(forward, None, settings, progress)
}

/// The same, and which of the conditions of `candidates` (a model with unknowns of the same names) to measure next.
///
/// # Errors
/// As [`diagnose`].
pub fn diagnose_with(
    forward: &dyn Forward,
    candidates: Option<&dyn Forward>,
    settings: &Settings,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    let (baseline, judgement) = judged(forward, settings, None, progress)?;
    report::report(&baseline, &judgement, candidates, progress)
}

/// The model as it is, and everything that was weighed against it: what a report is made of; `shared`: derivatives of another
/// diagnosis of the same campaign.
///
/// # Errors
/// As [`diagnose`].
pub fn judged<'a>(
    forward: &'a dyn Forward,
    settings: &'a Settings,
    shared: Option<&Shared>,
    progress: &Progress,
) -> Result<(Baseline<'a>, Judgement), DiagnoseError> {
    let mut baseline = Baseline::new(forward, settings, shared, progress)?;
    let mut judgement = judge::judge(&baseline, progress)?;
    if let Some((_, best)) = judgement.best_refit()
        && let Some(calmed) = baseline.calmed(best, progress)?
    {
        baseline = calmed;
        judgement = judge::judge(&baseline, progress)?;
    }
    Ok((baseline, judgement))
}
