//! Why a sweep cannot be made.

use thiserror::Error;

use crate::input::InputError;
use crate::progress::Cancelled;
use crate::study::StudyError;

/// Why a sweep cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SweepError {
    /// An axis that cannot be read.
    #[error(
        "--vary {text}: {problem}; write KEY=LOW..HIGH:COUNT, KEY=A,B,C or, with --samples, KEY=LOW..HIGH"
    )]
    Axis {
        /// As it was written.
        text: String,
        /// What is wrong.
        problem: String,
    },
    /// A range has no values of its own.
    #[error(
        "--vary {key}={low}..{high} has no number of values: write {key}={low}..{high}:5, or give --samples"
    )]
    RangeInGrid {
        /// Its key.
        key: String,
        /// Where it starts.
        low: f64,
        /// Where it ends.
        high: f64,
    },
    /// Too many cases.
    #[error("{asked} cases are more than {most}: take fewer values, or --samples")]
    TooMany {
        /// Cases asked for.
        asked: usize,
        /// Most that can be made.
        most: usize,
    },
    /// The base, or a key, is at fault.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The base has no solution for a reason of its own.
    #[error("the base as it stands: {reason}")]
    Base {
        /// Why.
        reason: String,
    },
    /// A case may have read something else than its task is known by.
    #[error(
        "{file} changed while the cases were solved; give the same command again, what still holds is kept"
    )]
    Changed {
        /// The file, or the base.
        file: String,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<StudyError> for SweepError {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Cancelled(cancelled) => SweepError::Cancelled(cancelled),
            error => SweepError::Base {
                reason: error.to_string(),
            },
        }
    }
}
