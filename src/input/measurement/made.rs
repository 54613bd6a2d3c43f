//! What a measurement file says of itself if a program made it: how, so that nobody takes it for nature's word.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

const HEAD: &str = "made by washout synthesize:";

/// How measurements were made.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Made {
    /// Factor on the refinement of the meshes of the study.
    pub mesh: f64,
    /// Which formulas the hidden effects had.
    pub formulas: Formulas,
    /// Relative error of outline, stiffness and air law, one standard deviation.
    pub background: f64,
    /// Seed of all that was drawn.
    pub seed: u64,
}

/// Which formulas hidden effects have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Formulas {
    /// Another formula of the same physics, where there is one.
    Other,
    /// Those of the program's own effects.
    Same,
}

impl Formulas {
    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Formulas::Other => "other",
            Formulas::Same => "same",
        }
    }
}

impl Made {
    /// Reads the comment line that [`Made`] displays as.
    pub fn parse(comment: &str) -> Option<Made> {
        let words = comment.trim().strip_prefix(HEAD)?;
        let value = |key: &str| {
            let parts = words.split(',').map(str::trim);
            parts
                .filter_map(|part| part.split_once(' '))
                .find_map(|(name, value)| (name == key).then_some(value))
        };
        Some(Made {
            mesh: value("mesh")?.parse().ok()?,
            formulas: match value("formulas")? {
                "other" => Formulas::Other,
                "same" => Formulas::Same,
                _ => return None,
            },
            background: value("background")?.parse().ok()?,
            seed: value("seed")?.parse().ok()?,
        })
    }

    /// Why a diagnosis with this seed would only be asked what it told itself; none if it would not.
    pub fn is_own_word(&self, seed: u64) -> Option<&'static str> {
        match self {
            made if made.mesh == 1.0 => Some("the same meshes"),
            made if made.formulas == Formulas::Same => Some("the same formulas"),
            made if made.background == 0.0 => Some("a model without any error"),
            made if made.seed == seed => Some("the same seed"),
            _ => None,
        }
    }
}

impl fmt::Display for Made {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Made {
            mesh,
            formulas,
            background,
            seed,
        } = self;
        let word = formulas.word();
        write!(
            f,
            "{HEAD} mesh {mesh}, formulas {word}, background {background}, seed {seed}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_and_own_words_are_told() {
        let made = Made {
            mesh: 1.25,
            formulas: Formulas::Other,
            background: 0.01,
            seed: 7,
        };
        assert_eq!(Made::parse(&made.to_string()), Some(made));
        assert_eq!(Made::parse("made by hand: mesh 1"), None);
        assert_eq!(made.is_own_word(1), None);
        assert!(made.is_own_word(7).is_some());
        for own in [
            Made { mesh: 1.0, ..made },
            Made {
                formulas: Formulas::Same,
                ..made
            },
            Made {
                background: 0.0,
                ..made
            },
        ] {
            assert!(own.is_own_word(1).is_some(), "{own}");
        }
    }
}
