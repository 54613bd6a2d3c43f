//! Why a case cannot be tried.

use thiserror::Error;

use crate::diagnose::DiagnoseError;
use crate::study::StudyError;
use crate::synthesize::SynthesizeError;

/// Why a case cannot be tried.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BlindError {
    /// The campaign is too poor for such cases.
    #[error("this campaign allows no {kind} cases: {reason}")]
    NoCase {
        /// Kind of the case.
        kind: &'static str,
        /// Why.
        reason: &'static str,
    },
    /// The study has no solution.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// Measurements cannot be made.
    #[error(transparent)]
    Synthesis(#[from] SynthesizeError),
    /// The diagnosis fails.
    #[error(transparent)]
    Diagnosis(#[from] DiagnoseError),
}
