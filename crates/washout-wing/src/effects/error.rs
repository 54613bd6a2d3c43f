//! What is wrong with an effect's table.

use thiserror::Error;

use crate::input::ExpressionError;

/// What is wrong with an effect's table.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum EffectError {
    /// An effect is to be added under a name that another has.
    #[error("there is an effect {name} already; give yours another name")]
    NameTaken {
        /// The name.
        name: String,
    },
    /// Effects were added before.
    #[error("effects are added once: give all of them to one call of register")]
    RegisteredBefore,
    /// No effect has this name.
    #[error("effects.{name}: there is no such effect; {cure}")]
    Unknown {
        /// Name in the design.
        name: String,
        /// What to do.
        cure: String,
    },
    /// The effect has no such number.
    #[error("effects.{name}.{key}: {name} has no such number; it has {known}")]
    UnknownKey {
        /// Name of the effect.
        name: String,
        /// Key in its table.
        key: String,
        /// Its numbers.
        known: String,
    },
    /// Not a number.
    #[error("effects.{name}.{key} = {value}: must be a number ({meaning}), e.g. {key} = {example}")]
    NoNumber {
        /// Name of the effect.
        name: String,
        /// Key in its table.
        key: String,
        /// What stands there.
        value: String,
        /// What the number is.
        meaning: String,
        /// A number that would do.
        example: f64,
    },
    /// Outside of what the effect accepts.
    #[error("effects.{name}.{key} = {value}: must lie in {low} … {high}{unit}; it is {meaning}")]
    OutOfRange {
        /// Name of the effect.
        name: String,
        /// Key in its table.
        key: String,
        /// What stands there.
        value: f64,
        /// Smallest value.
        low: f64,
        /// Largest value.
        high: f64,
        /// Unit.
        unit: String,
        /// What the number is.
        meaning: String,
    },
    /// No strength.
    #[error("effects.{name}: give its strength, e.g. strength = {example} ({meaning})")]
    NoStrength {
        /// Name of the effect.
        name: String,
        /// What the strength is.
        meaning: String,
        /// A number that would do.
        example: f64,
    },
    /// The design lacks what the effect acts on.
    #[error("effects.{name}: {reason}; delete the table, or set its strength to 0")]
    NotApplicable {
        /// Name of the effect.
        name: String,
        /// What is lacking.
        reason: String,
    },
    /// The table of an effect of the user's own is wrong.
    #[error("effects.{name}.{key}: {problem}; {cure}")]
    Own {
        /// Name of the effect.
        name: String,
        /// Key in its table.
        key: String,
        /// What is wrong.
        problem: String,
        /// What to do.
        cure: String,
    },
    /// The formula of an effect of the user's own cannot be computed somewhere on the wing.
    #[error("effects.{name}.expression = '{}': {problem}; {cure}", shortened(.text))]
    NoValue {
        /// Name of the effect.
        name: String,
        /// The formula.
        text: String,
        /// What it is instead, and where.
        problem: String,
        /// What to do.
        cure: String,
    },
    /// The formula of an effect of the user's own cannot be read.
    #[error("effects.{name}.expression: {error}")]
    Formula {
        /// Name of the effect.
        name: String,
        /// Where and why.
        error: ExpressionError,
    },
}

impl EffectError {
    /// The dotted key in the design that is at fault, if it is one.
    pub fn key(&self) -> Option<String> {
        let (name, key) = match self {
            EffectError::NameTaken { .. } | EffectError::RegisteredBefore => return None,
            EffectError::Unknown { name, .. }
            | EffectError::NoStrength { name, .. }
            | EffectError::NotApplicable { name, .. } => return Some(format!("effects.{name}")),
            EffectError::UnknownKey { name, key, .. }
            | EffectError::NoNumber { name, key, .. }
            | EffectError::OutOfRange { name, key, .. }
            | EffectError::Own { name, key, .. } => (name, key.as_str()),
            EffectError::NoValue { name, .. } | EffectError::Formula { name, .. } => (name, "expression"),
        };
        Some(format!("effects.{name}.{key}"))
    }
}

/// A formula as far as it fits into a sentence.
fn shortened(text: &str) -> String {
    const MOST: usize = 100;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_string(),
    }
}
