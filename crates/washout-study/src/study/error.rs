//! Why a study gives no result.

use thiserror::Error;

use crate::progress::Cancelled;

/// Why a study gives no result.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StudyError {
    /// Nothing is assumed.
    #[error(
        "the design assumes nothing, so there is no range to propagate: write uncertain inputs as \
         {{ assumed = VALUE, range = [LOW, HIGH], why = \"...\" }}"
    )]
    NothingAssumed,
    /// Fewer samples than a band needs.
    #[error("{asked} samples are too few for a band from 5 to 95 %: take at least {fewest}, better 64")]
    TooFewSamples {
        /// Samples asked for.
        asked: usize,
        /// Fewest that are accepted.
        fewest: usize,
    },
    /// More samples than the sequence has.
    #[error("{asked} samples are more than the sequence has: take at most {most}")]
    TooManySamples {
        /// Samples asked for.
        asked: usize,
        /// Most that are accepted.
        most: usize,
    },
    /// A finer mesh shows other readings than the one that is solved on.
    #[error("some rows can be read on one of two meshes alone")]
    OtherRows,
    /// A range that is no range.
    #[error(
        "{key}: the range [{low}, {high}] of the assumed value {value} is not a range around it: mend it in the design"
    )]
    BadRange {
        /// Dotted key.
        key: String,
        /// Assumed value.
        value: f64,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// The design itself cannot be evaluated.
    #[error("the design itself gives no result, so its ranges give none either: {reason}")]
    Nominal {
        /// Why.
        reason: String,
    },
    /// Hardly any sample could be evaluated.
    #[error(
        "{failed} of {samples} samples gave no result, which leaves too few for a band; the first: {reason}. \
         Narrow the assumed ranges, or mend what fails"
    )]
    SamplesFailed {
        /// Samples that gave no result.
        failed: usize,
        /// Samples in all.
        samples: usize,
        /// Reason of the first.
        reason: String,
    },
    /// A scatter that is none.
    #[error("the scatter of the measurement is not positive: give every row a sigma larger than 0")]
    BadNoise,
    /// A condition without a result.
    #[error("case {case}: {reason}")]
    Case {
        /// Name of the case.
        case: String,
        /// Why.
        reason: String,
    },
    /// Not one of the measured numbers can be read off the model.
    #[error(
        "none of the {rows} measured numbers can be read off the model; the first, case {case}: {reason}"
    )]
    NothingRead {
        /// How many there are.
        rows: usize,
        /// Name of the case of the first.
        case: String,
        /// Why it cannot.
        reason: String,
    },
    /// Something that is to be moved and cannot.
    #[error("{reason}")]
    Unknown {
        /// What, and the cure.
        reason: String,
    },
    /// A case that did not converge.
    #[error("case {case}: {reason}")]
    Unsolved {
        /// Name of the case.
        case: String,
        /// Why.
        reason: String,
    },
    /// A fit that does not settle.
    #[error("the fit did not settle in {steps} steps{}: state what moves as a number, or narrow its range", moving(.still))]
    NotCalibrated {
        /// Steps taken.
        steps: usize,
        /// What the last step moved farthest, by name.
        still: Vec<String>,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// What a search still moves, in words.
fn moving(still: &[String]) -> String {
    match still {
        [] => String::new(),
        still => format!(" (it still moves {})", still.join(", ")),
    }
}

impl StudyError {
    /// The same of a fit, which had moved `unknowns` to where there is no solution.
    #[must_use]
    pub fn while_fitting(self, unknowns: &str) -> StudyError {
        match self {
            StudyError::Unsolved { case, reason } if !unknowns.is_empty() => StudyError::Unsolved {
                case,
                reason: format!(
                    "{reason}. A fit led there, with {unknowns}; the design as it stands has a solution. Give what is uncertain a \
                     narrower range"
                ),
            },
            other => other,
        }
    }

    /// The exit code of a process that ends with it: 2 input, 3 not converged, 130 interrupted.
    pub fn exit_code(&self) -> u8 {
        match self {
            StudyError::Cancelled(_) => 130,
            StudyError::Nominal { .. }
            | StudyError::SamplesFailed { .. }
            | StudyError::NotCalibrated { .. }
            | StudyError::Unsolved { .. } => 3,
            _ => 2,
        }
    }
}
