//! Band of one output over the assumed ranges, and the shares of the inputs in it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::output::Output;
use super::quantile::quantile;
use super::shares::{Share, shares};
use super::surrogate::Surrogate;

/// Band of one output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OutputBand {
    /// What it is.
    pub output: Output,
    /// Name with unit.
    pub name: String,
    /// Value of the design as it stands.
    pub nominal: f64,
    /// 5 % of the samples lie below.
    pub q05: f64,
    /// Half of the samples lie below.
    pub median: f64,
    /// 95 % of the samples lie below.
    pub q95: f64,
    /// What the mesh leaves of it, by a mesh half as fine; absent where that is not known.
    #[serde(default)]
    pub mesh_error: Option<f64>,
    /// How well a quadratic polynomial explains the samples; absent where they do not vary.
    pub surrogate: Option<SurrogateQuality>,
    /// Shares of the inputs in the variance, largest first; inputs that are not seen in it are left out.
    pub shares: Vec<Share>,
}

/// How well a surrogate explains the samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SurrogateQuality {
    /// Terms besides the mean.
    pub terms: usize,
    /// Share of the variance that it explains.
    pub r_squared: f64,
    /// Share of the variance that it predicts of samples left out.
    pub predictive_r_squared: f64,
}

impl OutputBand {
    /// Band of `values` of an output, sampled at `places` of [−1, 1]ⁿ, one coordinate per key.
    pub fn of(
        output: &Output,
        nominal: f64,
        places: &[Vec<f64>],
        values: &[f64],
        keys: &[String],
    ) -> OutputBand {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |level: f64| quantile(&sorted, level).unwrap_or(nominal);
        let surrogate = Surrogate::fit(places, values);
        OutputBand {
            output: output.clone(),
            name: output.to_string(),
            nominal,
            q05: at(0.05),
            median: at(0.5),
            q95: at(0.95),
            shares: surrogate.as_ref().map_or_else(Vec::new, |fit| shares(fit, keys)),
            mesh_error: None,
            surrogate: surrogate.map(|fit| SurrogateQuality {
                terms: fit.terms.len(),
                r_squared: fit.r_squared,
                predictive_r_squared: fit.predictive_r_squared,
            }),
        }
    }
}
