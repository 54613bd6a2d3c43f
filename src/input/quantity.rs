//! A number in a design file: stated, or assumed with a range and a reason.

use serde::{Deserialize, Serialize};

/// A number as it stands in a design file.
///
/// Either stated (`half_amplitude_deg = 34.5`) or assumed
/// (`half_amplitude_deg = { assumed = 34.5, range = [24.0, 45.0], why = "not stated in the paper" }`).
/// The unit is in the name of the key that holds it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum Quantity {
    /// A value that the design states as a fact.
    Stated(f64),
    /// A value that is assumed, with the range that is thought possible.
    Assumed(Assumed),
}

/// An assumed value with its range.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Assumed {
    /// The value that is used, in the unit of the key.
    pub assumed: f64,
    /// Lower and upper end of the plausible range, same unit.
    pub range: [f64; 2],
    /// Why it is assumed, in a few words.
    #[serde(default)]
    pub why: String,
}

impl Quantity {
    /// The value that is used, in the unit of the key.
    pub fn value(&self) -> f64 {
        match self {
            Quantity::Stated(value) => *value,
            Quantity::Assumed(assumed) => assumed.assumed,
        }
    }

    /// The assumption, if the value is assumed.
    pub fn assumption(&self) -> Option<&Assumed> {
        match self {
            Quantity::Stated(_) => None,
            Quantity::Assumed(assumed) => Some(assumed),
        }
    }
}

impl From<f64> for Quantity {
    fn from(value: f64) -> Self {
        Quantity::Stated(value)
    }
}
