//! Why there is no diagnosis.

use std::path::PathBuf;

use thiserror::Error;

use crate::input::InputError;
use crate::progress::Cancelled;
use crate::study::StudyError;

/// Why there is no diagnosis.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DiagnoseError {
    /// Nothing to fit.
    #[error(
        "the study has no measured number outside its held-out cases: add a measurement, or hold out less"
    )]
    NoData,
    /// No effect to try.
    #[error(
        "no effect that may be tried can join the model: name others in candidates of the study, or leave candidates out, to try \
         all that can act"
    )]
    NoEffects,
    /// A setting out of range.
    #[error("{name} = {value} is out of range: {cure}")]
    BadSetting {
        /// Name of the setting.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What to give instead.
        cure: &'static str,
    },
    /// Something that should be finite is not.
    #[error("the model's answer to {what} is not a finite number: check its input and its plausible range")]
    NotFinite {
        /// Unknown or result.
        what: String,
    },
    /// Effects were asked for that there are not, or of which none can join the model.
    #[error("{reason}")]
    Asked {
        /// Which, and what to name instead.
        reason: String,
    },
    /// Measurements that a diagnosis would only read back.
    #[error(
        "{made} as this diagnosis has: finding the answer there would prove nothing. Make the measurements anew with {without} (washout \
         synthesize), or diagnose them all the same: washout diagnose {} --own-data",
        study.display()
    )]
    OwnData {
        /// The study file.
        study: PathBuf,
        /// Which measurements, and what they share.
        made: String,
        /// How to make them without that.
        without: String,
    },
    /// A key of the study is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The study has no result.
    #[error(transparent)]
    Study(StudyError),
    /// The user asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<StudyError> for DiagnoseError {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Cancelled(cancelled) => DiagnoseError::Cancelled(cancelled),
            other => DiagnoseError::Study(other),
        }
    }
}

/// An answer of the model where it may have no solution: none there.
///
/// # Errors
/// If the user asked to stop.
pub fn where_solved<T>(answer: Result<T, StudyError>) -> Result<Option<T>, Cancelled> {
    match answer {
        Ok(answer) => Ok(Some(answer)),
        Err(StudyError::Cancelled(cancelled)) => Err(cancelled),
        Err(_) => Ok(None),
    }
}
