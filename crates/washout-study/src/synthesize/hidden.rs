//! Effects hidden in a wing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::SynthesizeError;
use crate::effects::custom::Custom;
use crate::input::Design;

/// An effect to hide.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hidden {
    /// Its name: of an effect that the program knows, or of the user's own.
    pub name: String,
    /// Its strength.
    pub strength: f64,
    /// Its other numbers, as in a design; with `kind`, an effect of the user's own.
    #[schemars(with = "std::collections::BTreeMap<String, serde_json::Value>")]
    pub table: toml::Table,
    /// The wing that has it, by the name of its design; every wing on which it can act where none is named.
    #[serde(default)]
    pub wing: Option<String>,
}

impl Hidden {
    /// One that the program knows, its other numbers at their defaults.
    pub fn known(name: &str, strength: f64) -> Hidden {
        Hidden {
            name: name.to_string(),
            strength,
            table: toml::Table::new(),
            wing: None,
        }
    }

    /// One of the user's own.
    pub fn own(name: &str, acts_on: &str, expression: &str) -> Hidden {
        Hidden {
            name: name.to_string(),
            strength: 1.0,
            table: Custom::table(acts_on, expression),
            wing: None,
        }
    }

    /// Whether it is meant for a design.
    pub(super) fn is_on(&self, design: &Design) -> bool {
        self.wing.as_ref().is_none_or(|wing| *wing == design.name)
    }

    pub(super) fn fault(&self, reason: impl Into<String>) -> SynthesizeError {
        SynthesizeError::Hidden {
            effect: self.name.clone(),
            reason: reason.into(),
        }
    }
}
