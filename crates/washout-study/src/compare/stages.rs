//! Stages of the modelled profile, in millimetres and degrees.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::observation::stages::{DEG_PER_MM, StageFit};
use crate::observation::{StageSettings, TwistProfile, fit_stages};

/// Stages of a modelled profile by its own fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ModelledStages {
    /// The stages from base to tip.
    pub stages: Vec<FittedStage>,
    /// Distance of the profile from the fit, root of RSS/(n − p); absent where nothing is left over.
    pub scatter_deg: Option<f64>,
    /// What the errors of the stages mean.
    pub meaning_of_errors: String,
}

/// One fitted stage.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FittedStage {
    /// Where it starts.
    pub from_mm: f64,
    /// Where it ends.
    pub to_mm: f64,
    /// Standard error of the break at its end; absent for the last stage and where the points do not fix it: it would be larger than a stage
    /// beside it.
    pub to_error_mm: Option<f64>,
    /// Twist rate.
    pub rate_deg_per_mm: f64,
    /// Its standard error; absent where the points do not fix it.
    pub rate_error_deg_per_mm: Option<f64>,
}

impl ModelledStages {
    /// Of a profile, anchored at its base; none where it has too few readings.
    pub fn of(profile: &TwistProfile) -> Option<ModelledStages> {
        let fit = fit_stages(&profile.points(), profile.base(), StageSettings::default())?;
        Some(ModelledStages::new(&fit))
    }

    /// In millimetres and degrees.
    pub fn new(fit: &StageFit) -> ModelledStages {
        let length = |k: usize| fit.stages.get(k).map_or(0.0, |stage| stage.to_m - stage.from_m);
        let error_of_end = |k: usize| {
            let error_m = fit.break_error_m.get(k).copied().flatten()?;
            (error_m < length(k).min(length(k + 1))).then_some(error_m)
        };
        let stages = fit.stages.iter().enumerate().map(|(k, stage)| FittedStage {
            from_mm: stage.from_m * 1e3,
            to_mm: stage.to_m * 1e3,
            to_error_mm: error_of_end(k).map(|error_m| error_m * 1e3),
            rate_deg_per_mm: stage.rate_rad_per_m * DEG_PER_MM,
            rate_error_deg_per_mm: stage.rate_error_rad_per_m.map(|error| error * DEG_PER_MM),
        });
        ModelledStages {
            stages: stages.collect(),
            scatter_deg: fit.scatter_rad.map(f64::to_degrees),
            meaning_of_errors: fit.source.meaning_of_errors().to_string(),
        }
    }
}
