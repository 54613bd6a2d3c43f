//! Why no measurements can be made.

use thiserror::Error;

use crate::input::InputError;
use crate::study::StudyError;

/// Why no measurements can be made.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SynthesizeError {
    /// An effect that cannot be hidden.
    #[error("{effect}: {reason}")]
    Hidden {
        /// The effect.
        effect: String,
        /// Why not, and the cure.
        reason: String,
    },
    /// The wing with the background errors is none.
    #[error("with background errors: {0}")]
    Background(InputError),
    /// The wing has no solution.
    #[error("the wing that was to be measured: {0}")]
    Study(#[from] StudyError),
}
