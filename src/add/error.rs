//! Why an effect does not join a study.

use std::path::PathBuf;

use thiserror::Error;

use crate::input::InputError;
use crate::study::StudyError;

/// Why an effect does not join a study.
#[derive(Debug, Error)]
pub enum AddError {
    /// Something that was asked for is refused.
    #[error("{question}: {reason}")]
    Question {
        /// What, as the command line has it.
        question: &'static str,
        /// Why not, and the cure.
        reason: String,
    },
    /// The study, or a file that it names, is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The study with the effect gives no result.
    #[error("{}: {source}", study.display())]
    Study {
        /// The study file.
        study: PathBuf,
        /// Why.
        source: StudyError,
    },
}
