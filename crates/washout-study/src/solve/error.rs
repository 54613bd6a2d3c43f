//! Why a design is not solved.

use thiserror::Error;

use crate::study::StudyError;
use crate::wing::WingError;

/// Why a design is not solved, or not all that was asked for.
#[derive(Debug, Error)]
pub enum SolveError {
    /// The wing gives no answer.
    #[error(transparent)]
    Wing(#[from] WingError),
    /// The ranges of the assumed inputs give no band.
    #[error("--uncertainty: {0}")]
    Band(StudyError),
}
