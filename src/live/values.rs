//! What was moved: numbers by key, strengths of effects, the text of a study. All that undo brings back.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::input::study::LoadedStudy;

/// What was moved since a file was opened.
#[derive(Debug, Clone, Default)]
pub struct Values {
    /// Numbers of designs by dotted key, in the unit of the key.
    pub numbers: BTreeMap<String, f64>,
    /// Strengths of effects of a design; those of a study stand in its text.
    pub effects: BTreeMap<String, f64>,
    /// The study, if it is one.
    pub study: Option<Arc<StudyText>>,
}

/// The text of a study with what was added to it.
#[derive(Debug)]
pub struct StudyText {
    /// As it would be written.
    pub text: String,
    /// As read.
    pub loaded: LoadedStudy,
    /// What makes it of the one that was opened.
    pub steps: Vec<Step>,
}

/// What is done to the text of a study.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// An effect joins it, fitted as `washout add` does it.
    Fitted {
        /// The effect.
        addition: Addition,
        /// What changes all designs before, `key=value`.
        sets: Vec<String>,
    },
    /// An effect is held at a strength.
    Held {
        /// Its name.
        effect: String,
        /// Its strength.
        strength: f64,
    },
}

/// An effect that joins a study.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Addition {
    /// Its name.
    pub effect: String,
    /// Its strength as a diagnosis found it.
    pub strength: f64,
    /// Its numbers besides the strength, each `name=value`.
    pub numbers: Vec<String>,
    /// The wing that has it; all on which it can act, if there is none.
    pub wing: Option<String>,
}

impl Values {
    /// Whether a number, or the strength of an effect, was set by hand: the model is then not that of the file with what was fitted.
    pub fn is_set_by_hand(&self) -> bool {
        let steps = self.study.iter().flat_map(|study| &study.steps);
        let mut held = steps.filter(|step| matches!(step, Step::Held { .. }));
        !self.sets().is_empty() || held.next().is_some()
    }

    /// Numbers and strengths as `--set` takes them.
    pub fn sets(&self) -> Vec<String> {
        let numbers = self.numbers.iter();
        let numbers = numbers.map(|(key, value)| format!("{key}={}", written(*value)));
        let effects = self.effects.iter();
        numbers
            .chain(effects.map(|(name, value)| format!("effects.{name}.strength={}", written(*value))))
            .collect()
    }
}

impl Step {
    /// The effect that it is about.
    pub fn effect(&self) -> &str {
        match self {
            Step::Fitted { addition, .. } => &addition.effect,
            Step::Held { effect, .. } => effect,
        }
    }
}

impl PartialEq for Values {
    fn eq(&self, other: &Values) -> bool {
        let text = |values: &Values| values.study.as_ref().map(|study| study.text.clone());
        self.numbers == other.numbers && self.effects == other.effects && text(self) == text(other)
    }
}

/// A number as a file has it: read back it is the same.
pub fn written(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-4..1e15).contains(&size) => format!("{value}"),
        _ => format!("{value:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_read_back_the_same() {
        for value in [0.0, -0.0, 30.0, 0.1, 1e-7, -2.5e-9, 1e300, 123_456_789.123] {
            assert_eq!(
                written(value).parse::<f64>().expect("a number").to_bits(),
                f64::to_bits(value)
            );
        }
    }
}
