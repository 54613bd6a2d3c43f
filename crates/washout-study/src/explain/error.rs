//! Why there is no explanation.

use thiserror::Error;

use crate::diagnose::DiagnoseError;
use crate::progress::Cancelled;
use crate::study::StudyError;

/// Why there is no explanation.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ExplainError {
    /// Nothing to explain.
    #[error(
        "the study has no measured number outside its held-out cases: add a measurement, or hold out less"
    )]
    NoData,
    /// The study, or what was asked of the model.
    #[error(transparent)]
    Diagnose(DiagnoseError),
    /// The user asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<StudyError> for ExplainError {
    fn from(error: StudyError) -> Self {
        ExplainError::from(DiagnoseError::from(error))
    }
}

impl From<DiagnoseError> for ExplainError {
    fn from(error: DiagnoseError) -> Self {
        match error {
            DiagnoseError::Cancelled(cancelled) => ExplainError::Cancelled(cancelled),
            DiagnoseError::NoData => ExplainError::NoData,
            other => ExplainError::Diagnose(other),
        }
    }
}
