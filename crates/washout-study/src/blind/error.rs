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
    /// A drawn effect is hardly seen where it was drawn to sit.
    #[error("{effect} at its plausible size is seen at {seen:.1} sigma there, fewer than a case asks for")]
    TooFaint {
        /// The effect.
        effect: String,
        /// Distance at which it is seen, sigma.
        seen: f64,
    },
    /// A drawn effect can be told from every other after all.
    #[error("{effect} at {strength} is {apart:.1} sigma apart from every other effect: no twin")]
    NoTwin {
        /// The effect.
        effect: String,
        /// Its strength.
        strength: f64,
        /// Distance to the nearest effect of another family, sigma.
        apart: f64,
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

impl BlindError {
    /// Whether it ends the run: the user asked to stop, or the campaign allows no case of that kind. Others are of one case.
    pub fn is_of_run(&self) -> bool {
        matches!(
            self,
            BlindError::NoCase { .. }
                | BlindError::Diagnosis(DiagnoseError::Cancelled(_))
                | BlindError::Study(StudyError::Cancelled(_))
                | BlindError::Synthesis(SynthesizeError::Study(StudyError::Cancelled(_)))
        )
    }
}
