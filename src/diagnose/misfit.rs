//! Where the model as it is fails: by condition, channel and station, in units and in standard deviations.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::study::calibrate::misfit;

use super::baseline::Baseline;

/// Pulls beyond this are flagged.
const FLAGGED_PULL: f64 = 2.0;

/// Where the calibrated model fails.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Misfit {
    /// Misfit plus price of the priors; about the count of numbers if nothing is missing.
    pub q: f64,
    /// Numbers fitted.
    pub numbers: usize,
    /// Each channel of each condition.
    pub by_condition: Vec<MisfitGroup>,
    /// Each tenth of the span, all conditions together, by channel.
    pub by_station: Vec<MisfitStation>,
    /// What the fit moved.
    pub pulls: Vec<Pull>,
}

/// One channel of one condition.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MisfitGroup {
    /// Name of the condition.
    pub condition: String,
    /// What was measured.
    pub channel: Channel,
    /// Count of numbers.
    pub numbers: usize,
    /// Share of the sum of squares of all standardised errors.
    pub share: f64,
    /// Mean of measured minus modelled, in the unit of the channel: E of ASME V&V 20.
    pub mean_error: f64,
    /// Its standard uncertainty by noise, error of the model and priors: u_val of ASME V&V 20.
    pub mean_uncertainty: f64,
    /// Root mean square error, in the unit of the channel.
    pub rms: f64,
    /// The same in standard deviations of the noise.
    pub rms_sigma: f64,
}

/// One tenth of the span.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MisfitStation {
    /// Middle of the tenth, over the length of the wing.
    pub r_over_length: f64,
    /// What was measured.
    pub channel: Channel,
    /// Share of the sum of squares of all standardised errors.
    pub share: f64,
    /// Mean standardised error.
    pub mean_sigma: f64,
}

/// What the fit did to an unknown.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Pull {
    /// The unknown.
    pub unknown: String,
    /// Fitted value.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Distance from the mean of its prior, in standard deviations of the prior.
    pub pull: f64,
    /// Whether that is far: the unknown may be standing in for what is missing.
    pub is_flagged: bool,
}

/// Of the calibrated model.
pub fn of(baseline: &Baseline) -> Misfit {
    let (forward, data, fit) = (baseline.forward, &baseline.data, &baseline.fit);
    let observables = forward.observables();
    let sigma = |position: usize| {
        let stated = observables[data.rows[position]].sigma;
        stated * baseline.scatter.scale * baseline.scatter.widening[position]
    };
    let errors: Vec<f64> = data
        .rows
        .iter()
        .map(|&row| misfit(&observables[row], fit.predicted[row]))
        .collect();
    let square = |position: usize| (errors[position] / sigma(position)).powi(2);
    let total: f64 = (0..errors.len()).map(square).sum::<f64>().max(f64::MIN_POSITIVE);
    let covariance = |a: usize, b: usize| {
        let slopes = &baseline.local.slopes;
        baseline.scatter.covariance[(a, b)] + slopes.row(a).dot(&slopes.row(b))
    };
    let mut by_condition = Vec::new();
    for (condition, positions) in data.conditions(forward) {
        let mut channels: Vec<Channel> = positions
            .iter()
            .map(|&p| observables[data.rows[p]].channel)
            .collect();
        channels.sort_unstable();
        channels.dedup();
        for channel in channels {
            let own: Vec<usize> = positions
                .iter()
                .copied()
                .filter(|&p| observables[data.rows[p]].channel == channel)
                .collect();
            let count = own.len() as f64;
            let variance: f64 = own
                .iter()
                .flat_map(|&a| own.iter().map(move |&b| (a, b)))
                .map(|(a, b)| covariance(a, b))
                .sum();
            let squares: f64 = own.iter().map(|&p| square(p)).sum();
            by_condition.push(MisfitGroup {
                condition: forward.conditions()[condition].name.clone(),
                channel,
                numbers: own.len(),
                share: squares / total,
                mean_error: own.iter().map(|&p| errors[p]).sum::<f64>() / count,
                mean_uncertainty: variance.max(0.0).sqrt() / count,
                rms: (own.iter().map(|&p| errors[p].powi(2)).sum::<f64>() / count).sqrt(),
                rms_sigma: (squares / count).sqrt(),
            });
        }
    }
    let mut tenths: BTreeMap<(Channel, usize), Vec<usize>> = BTreeMap::new();
    for (position, &row) in data.rows.iter().enumerate() {
        let observable = &observables[row];
        let Some(inner) = observable.r_mm else { continue };
        let middle = 0.5 * (inner + observable.r_to_mm.unwrap_or(inner));
        let place = middle / (1e3 * forward.conditions()[observable.condition].length_m);
        let tenth = ((10.0 * place) as usize).min(9);
        tenths
            .entry((observable.channel, tenth))
            .or_default()
            .push(position);
    }
    let by_station = tenths.into_iter().map(|((channel, tenth), own)| MisfitStation {
        r_over_length: (tenth as f64 + 0.5) / 10.0,
        channel,
        share: own.iter().map(|&p| square(p)).sum::<f64>() / total,
        mean_sigma: own.iter().map(|&p| errors[p] / sigma(p)).sum::<f64>() / own.len() as f64,
    });
    let pulls = fit.free.iter().enumerate().map(|(position, &i)| {
        let unknown = &forward.unknowns()[i];
        let pull = (fit.at[i] - unknown.mean) / unknown.sigma;
        Pull {
            unknown: unknown.name.clone(),
            value: fit.at[i],
            standard_error: fit.covariance[(position, position)].sqrt(),
            pull,
            is_flagged: pull.abs() > FLAGGED_PULL,
        }
    });
    Misfit {
        q: fit.q,
        numbers: errors.len(),
        by_condition,
        by_station: by_station.collect(),
        pulls: pulls.collect(),
    }
}
