//! Which axis moves a figure: shares of the axes in its variance.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axis::Values;
use super::evaluate::Row;
use super::plan::SweepPlan;
use crate::study::Share;
use crate::study::shares::shares;
use crate::study::surrogate::Surrogate;

/// Shares of the axes in the variance of a figure (Sobol indices), by a polynomial of second degree through the cases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Sensitivity {
    /// The figure.
    pub figure: String,
    /// Axes with a share, largest first.
    pub shares: Vec<Share>,
    /// Part of the variance that the polynomial explains.
    pub explained: f64,
}

/// Sensitivities of all figures; of axes whose values are no numbers, by their places in the list. Figures that do not vary, or of
/// too few cases, are left out.
pub fn sensitivities(plan: &SweepPlan, rows: &[Row]) -> Vec<Sensitivity> {
    let keys: Vec<String> = plan.axes.iter().map(|axis| axis.key.clone()).collect();
    let mut names: Vec<&str> = Vec::new();
    for figure in rows.iter().flat_map(|row| &row.figures) {
        if !names.contains(&figure.name.as_str()) {
            names.push(&figure.name);
        }
    }
    let found = names.into_iter().filter_map(|name| {
        let known: Vec<(&Row, f64)> = rows
            .iter()
            .filter_map(|row| Some((row, row.figure(name)?)))
            .collect();
        let points: Vec<Vec<f64>> = known.iter().map(|(row, _)| places(plan, row)).collect();
        let values: Vec<f64> = known.iter().map(|(_, value)| *value).collect();
        let surrogate = Surrogate::fit(&points, &values)?;
        let shares = shares(&surrogate, &keys);
        Some(Sensitivity {
            figure: name.to_string(),
            shares,
            explained: surrogate.r_squared,
        })
    });
    found.collect()
}

/// Places of a row on the axes, −1 to 1.
fn places(plan: &SweepPlan, row: &Row) -> Vec<f64> {
    let axes = plan.axes.iter().zip(&row.values);
    axes.map(|(axis, value)| {
        let [low, high, value] = match &axis.values {
            Values::Range([low, high]) => [*low, *high, value.parse().unwrap_or(*low)],
            Values::List(values) => {
                let numbers: Option<Vec<f64>> = values.iter().map(|value| value.parse().ok()).collect();
                match (numbers, value.parse::<f64>()) {
                    (Some(numbers), Ok(value)) => {
                        let low = numbers.iter().copied().fold(f64::INFINITY, f64::min);
                        let high = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                        [low, high, value]
                    }
                    _ => {
                        let place = values.iter().position(|known| known == value).unwrap_or(0);
                        [0.0, (values.len() - 1) as f64, place as f64]
                    }
                }
            }
        };
        if high > low {
            2.0 * (value - low) / (high - low) - 1.0
        } else {
            0.0
        }
    })
    .collect()
}
