//! Why a move is refused: at which input, and what to do.

use serde::Serialize;

use crate::input::InputError;
use crate::wing::WingError;

/// Why something was not done; all is as it was before.
#[derive(Debug, Clone, PartialEq, Serialize, thiserror::Error)]
#[error("{message}")]
pub struct Refusal {
    /// Dotted key of the input, or the name of the effect, that is at fault; none if no single one is.
    pub key: Option<String>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub cure: Option<String>,
}

impl Refusal {
    /// One that no single input is at fault of.
    pub fn new(message: impl ToString) -> Refusal {
        Refusal {
            key: None,
            message: message.to_string(),
            cure: None,
        }
    }

    /// The same with what to do about it.
    pub fn cured(self, cure: &str) -> Refusal {
        Refusal {
            cure: Some(cure.to_string()),
            ..self
        }
    }

    /// One at an input or an effect.
    pub fn at(key: &str, message: impl ToString, cure: &str) -> Refusal {
        Refusal {
            key: Some(key.to_string()),
            message: message.to_string(),
            cure: (!cure.is_empty()).then(|| cure.to_string()),
        }
    }
}

impl From<InputError> for Refusal {
    fn from(error: InputError) -> Refusal {
        match error.key.as_str() {
            "" => Refusal::new(&error),
            key => Refusal::at(key, &error.problem, &error.cure),
        }
    }
}

impl From<WingError> for Refusal {
    fn from(error: WingError) -> Refusal {
        match error {
            WingError::Input(error) => error.into(),
            WingError::Effect { source, .. } => Refusal {
                key: source.key(),
                message: source.to_string(),
                cure: None,
            },
            WingError::Design { reason, .. } => Refusal::new(reason),
            WingError::Solve { source, remark, .. } => Refusal::new(format!("{source}{remark}")),
            other => Refusal::new(other),
        }
    }
}
