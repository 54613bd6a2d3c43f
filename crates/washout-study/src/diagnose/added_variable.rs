//! See where it fails and learn which effect, in one picture: the residual against an effect's signature.

use nalgebra::{Cholesky, DMatrix};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;

use super::baseline::Baseline;

/// Points of an added-variable plot: their slope through zero is the strength by one step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AddedVariable {
    /// The effect.
    pub effect: String,
    /// The points.
    pub points: Vec<AddedPoint>,
    /// Strength by one step.
    pub slope: f64,
}

/// One observable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AddedPoint {
    /// Name of its condition.
    pub condition: String,
    /// Name of its wing.
    pub wing: String,
    /// What was measured.
    pub channel: Channel,
    /// Run of the measurement; may be empty.
    pub run: String,
    /// Station, or inner end of the interval, mm.
    pub r_mm: Option<f64>,
    /// Outer end of the interval, mm.
    pub r_to_mm: Option<f64>,
    /// Signature per unit of strength, in standard deviations, what the model absorbs left out.
    pub signature: f64,
    /// Residual, in standard deviations.
    pub residual: f64,
}

/// Of the missing effect at position `k`.
pub fn added_variable(baseline: &Baseline, k: usize, effect: &str) -> AddedVariable {
    let (forward, data) = (baseline.forward, &baseline.data);
    let sigma = forward.unknowns()[data.missing[k]].sigma;
    let column = baseline.slopes.column(k).select_rows(data.rows.iter());
    let whitened = baseline.scatter.noise.whiten(&column) / sigma;
    let slopes = &baseline.fit.slopes;
    let size = slopes.ncols();
    let curvature = DMatrix::identity(size, size) + slopes.transpose() * slopes;
    let absorbed =
        Cholesky::new(curvature).map(|factor| slopes * factor.solve(&(slopes.transpose() * &whitened)));
    let signature = absorbed.map_or_else(|| whitened.clone(), |absorbed| &whitened - absorbed);
    let points = data.rows.iter().enumerate().map(|(position, &row)| {
        let observable = &forward.observables()[row];
        let condition = &forward.conditions()[observable.condition];
        AddedPoint {
            condition: condition.name.clone(),
            wing: condition.wing.clone(),
            channel: observable.channel,
            run: observable.run.clone(),
            r_mm: observable.r_mm,
            r_to_mm: observable.r_to_mm,
            signature: signature[position],
            residual: baseline.fit.residual[position],
        }
    });
    let length = baseline.directions.lengths[k] / sigma;
    AddedVariable {
        effect: effect.to_string(),
        points: points.collect(),
        slope: if length > 0.0 {
            baseline.directions.scores[k] / length
        } else {
            0.0
        },
    }
}
