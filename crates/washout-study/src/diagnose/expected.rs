//! What rival explanations predict for a reading that was not taken yet.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::digits::short;
use crate::input::measurement::Channel;

/// A reading, and what rivals predict for it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ExpectedReading {
    /// What would be measured.
    pub channel: Channel,
    /// Station or inner end of the interval, mm; none where it has none.
    pub r_mm: Option<f64>,
    /// The rivals.
    pub by: Vec<Expected>,
}

/// What a rival predicts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Expected {
    /// Its name: that of its effects, `nothing missing`, or `an unknown cause`.
    pub rival: String,
    /// Its prediction, in the unit of the channel.
    pub value: f64,
    /// Standard error of that, by what the fit leaves open.
    pub standard_error: f64,
}

impl ExpectedReading {
    /// What each rival predicts, in words.
    pub fn words(&self) -> String {
        let at = self
            .r_mm
            .map_or(String::new(), |r_mm| format!(" at {} mm", short(r_mm)));
        let what = format!(
            " {} of {}{at}",
            self.channel.unit(),
            self.channel.name().replace('_', " ")
        );
        let each = self.by.iter().enumerate().map(|(place, own)| {
            let (verb, what) = if place == 0 {
                ("leads to", what.as_str())
            } else {
                ("to", "")
            };
            format!(
                "{} {verb} {} ± {}{what}",
                own.rival,
                short(own.value),
                short(own.standard_error)
            )
        });
        each.collect::<Vec<_>>().join(", ")
    }
}
