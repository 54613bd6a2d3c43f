//! The numbers of a solved wing whose uncertainty is asked for: twist at places, twist rate over stretches.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::observation::rate::interpolated;
use crate::observation::stages::DEG_PER_MM;
use crate::observation::{Place, TwistProfile, mean_rate};

/// A number that a solved wing gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "kind")]
pub enum Output {
    /// Twist at a place, deg.
    Twist {
        /// Distance from the wing base.
        r_mm: f64,
    },
    /// Mean twist rate over a stretch, deg/mm.
    TwistRate {
        /// Where it starts.
        from_mm: f64,
        /// Where it ends.
        to_mm: f64,
    },
    /// Anything else, by its name with unit.
    Named {
        /// The name.
        name: String,
    },
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Output::Twist { r_mm } => write!(f, "twist at {r_mm:.1} mm (deg)"),
            Output::TwistRate { from_mm, to_mm } => {
                write!(f, "twist rate {from_mm:.1}-{to_mm:.1} mm (deg/mm)")
            }
            Output::Named { name } => f.write_str(name),
        }
    }
}

/// Twist at the stations of a nominal profile and mean rates over given stretches, for any other profile.
///
/// Spars move between samples, and in a bay the film sags: so every profile is read at its own spar ends, and
/// straight between them at the nominal stations.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileOutputs {
    /// What [`ProfileOutputs::read`] gives, in its order.
    pub outputs: Vec<Output>,
}

impl ProfileOutputs {
    /// Stations of `nominal` outboard of the base, and `stretches_mm`, `[from, to]`, none twice; a stretch is clipped
    /// to the last station and left out if nothing of it remains.
    pub fn new(nominal: &TwistProfile, stretches_mm: &[[f64; 2]]) -> ProfileOutputs {
        let stations = nominal
            .readings
            .iter()
            .filter(|reading| reading.place != Place::Base);
        let mut outputs: Vec<Output> = stations
            .map(|reading| Output::Twist {
                r_mm: reading.r_m * 1e3,
            })
            .collect();
        for [from_mm, to_mm] in stretches_mm {
            let Some(rate) = mean_rate(nominal, from_mm / 1e3, to_mm / 1e3) else {
                continue;
            };
            let output = Output::TwistRate {
                from_mm: rate.from_m * 1e3,
                to_mm: rate.to_m * 1e3,
            };
            if !outputs.contains(&output) {
                outputs.push(output);
            }
        }
        ProfileOutputs { outputs }
    }

    /// Their values in another profile, deg and deg/mm; the error says what could not be read.
    pub fn read(&self, profile: &TwistProfile) -> Result<Vec<f64>, String> {
        let value = |output: &Output| {
            let found = match output {
                Output::Twist { r_mm } => {
                    interpolated(profile, r_mm / 1e3).map(|(twist, _)| twist.to_degrees())
                }
                Output::TwistRate { from_mm, to_mm } => mean_rate(profile, from_mm / 1e3, to_mm / 1e3)
                    .filter(|rate| !rate.is_clipped)
                    .map(|rate| rate.rate_rad_per_m * DEG_PER_MM),
                Output::Named { .. } => None,
            };
            found.ok_or_else(|| format!("the {output} cannot be read on this sample"))
        };
        self.outputs.iter().map(value).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observation::imposed::{design, wing};
    use crate::observation::read_profile;

    fn profile(first_spar_mm: f64, rate_deg_per_mm: f64) -> TwistProfile {
        let mut design = design("");
        design.spar[0].at_mm = first_spar_mm.into();
        let twist = |r_m: f64| (rate_deg_per_mm * r_m * 1e3).to_radians();
        let (planform, solution) = wing(&design, twist, |_| [0.0, 0.0]);
        read_profile(&design, &planform, &solution).unwrap()
    }

    #[test]
    fn outputs_of_the_nominal_wing_are_read_on_a_wing_with_other_spars() {
        let outputs = ProfileOutputs::new(&profile(2.8, 0.3), &[[0.0, 48.0], [48.0, 70.0], [69.0, 70.0]]);
        assert_eq!(outputs.outputs.len(), 8, "six stations and two stretches");
        assert_eq!(outputs.outputs[7].to_string(), "twist rate 48.0-67.9 mm (deg/mm)");
        let values = outputs.read(&profile(4.8, 0.5)).unwrap();
        assert!((values[0] - 1.4).abs() < 1e-9, "{values:?}");
        assert!((values[3] - 0.5 * 51.1).abs() < 1e-9);
        assert!(
            (values[6] - 0.5).abs() < 1e-9 && (values[7] - 0.5).abs() < 0.01,
            "{values:?}"
        );
    }

    #[test]
    fn a_profile_that_ends_too_early_is_refused_by_name() {
        let outputs = ProfileOutputs::new(&profile(2.8, 0.3), &[]);
        let mut short = profile(2.8, 0.3);
        short.readings.pop();
        let error = outputs.read(&short).unwrap_err();
        assert!(error.contains("twist at 67.9 mm (deg) cannot be read"), "{error}");
    }
}
