//! What a diagnosis may be told: significance, trust in the noise, prior probabilities.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::DiagnoseError;

/// What a diagnosis may be told. [`Settings::default`] holds what was tried on generated cases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// Admitted error of the model as a share of what it predicts.
    pub discrepancy: f64,
    /// Probability of a false alarm that is accepted where nothing is missing.
    pub significance: f64,
    /// How many numbers the stated standard deviations are worth when the noise is estimated from the data.
    pub noise_trust: usize,
    /// Where the unknowns start, in their units; at the means of their priors otherwise. An effect that starts off zero is
    /// part of the model.
    pub start: Option<Vec<f64>>,
    /// Factor on the stated standard deviations, if it is known; estimated from the data otherwise.
    pub noise_scale: Option<f64>,
    /// Seed by which a user's own draws are known: data that were made with it are refused.
    pub seed: u64,
    /// Probabilities before the data.
    pub prior: PriorOdds,
    /// Places along the span by which a missing load is reconstructed.
    pub stations: usize,
    /// Step by which effects with a kink at zero are seen, as a share of their scale; without it the derivative that
    /// the model states is taken, which then must have seen such effects from a step itself.
    pub switch_step: Option<f64>,
    /// Power to which evidence is raised before it becomes a probability: below 1 it is less sure of itself.
    pub tempering: f64,
}

/// Probabilities before the data, assumed; they need not sum to 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct PriorOdds {
    /// Nothing is missing.
    pub nothing: f64,
    /// One known effect is, shared among all families.
    pub one: f64,
    /// Two known effects are, shared among all pairs of families.
    pub two: f64,
    /// Something is that no known effect is.
    pub novel: f64,
}

impl Default for PriorOdds {
    fn default() -> Self {
        PriorOdds {
            nothing: 0.5,
            one: 0.39,
            two: 0.07,
            novel: 0.04,
        }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            discrepancy: 0.01,
            significance: 0.01,
            noise_trust: 5,
            start: None,
            noise_scale: None,
            seed: 1,
            prior: PriorOdds::default(),
            stations: 16,
            switch_step: None,
            tempering: 1.0,
        }
    }
}

impl Settings {
    /// Refuses what cannot be meant.
    ///
    /// # Errors
    /// With the name of the first setting that is out of range.
    pub fn check(&self) -> Result<(), DiagnoseError> {
        let positive = "give a number larger than 0";
        let ranges = [
            (
                "discrepancy",
                self.discrepancy,
                0.0,
                0.5,
                "give a share from 0 to 0.5, such as 0.01",
            ),
            (
                "significance",
                self.significance,
                1e-3,
                0.5,
                "give 0.001 to 0.5, such as 0.01",
            ),
            (
                "noise_trust",
                self.noise_trust as f64,
                1.0,
                1e4,
                "give 1 to 10000, such as 5",
            ),
            (
                "noise_scale",
                self.noise_scale.unwrap_or(1.0),
                1e-6,
                1e6,
                positive,
            ),
            ("prior.nothing", self.prior.nothing, 1e-9, 1e9, positive),
            ("prior.one", self.prior.one, 1e-9, 1e9, positive),
            ("prior.two", self.prior.two, 1e-9, 1e9, positive),
            ("prior.novel", self.prior.novel, 1e-9, 1e9, positive),
            (
                "stations",
                self.stations as f64,
                4.0,
                200.0,
                "give 4 to 200, such as 16",
            ),
            (
                "switch_step",
                self.switch_step.unwrap_or(0.05),
                1e-6,
                1.0,
                "give a share from 0.000001 to 1",
            ),
            ("tempering", self.tempering, 0.05, 1.0, "give 0.05 to 1"),
        ];
        for (name, value, low, high, cure) in ranges {
            if !(low..=high).contains(&value) {
                return Err(DiagnoseError::BadSetting { name, value, cure });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_pass_and_nonsense_is_named() {
        assert_eq!(Settings::default().check(), Ok(()));
        let settings = Settings {
            significance: f64::NAN,
            ..Settings::default()
        };
        let error = settings.check().unwrap_err();
        assert!(error.to_string().starts_with("significance = NaN"), "{error}");
    }
}
