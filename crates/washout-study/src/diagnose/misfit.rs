//! Where the model as it is fails: by condition, channel and station, in units and in standard deviations.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::study::{Fit, Forward, Observable, UnknownKind};

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
    /// Its unit; `1` for pure numbers.
    #[serde(default)]
    pub unit: String,
    /// Fitted value.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Distance from the mean of its prior, in standard deviations of the prior.
    pub pull: f64,
    /// Whether that is far: the unknown may be standing in for what is missing.
    pub is_flagged: bool,
    /// Whether it ended at an end of its range.
    #[serde(default)]
    pub at_end: bool,
}

/// Of the calibrated model.
pub fn of(baseline: &Baseline) -> Misfit {
    let errors = Errors::new(baseline);
    Misfit {
        q: baseline.fit.q,
        numbers: errors.each.len(),
        by_condition: errors.by_condition(),
        by_station: errors.by_station(),
        pulls: pulls(baseline.forward, &baseline.fit),
    }
}

/// Errors of the calibrated model, by position among the fitted numbers.
struct Errors<'a> {
    baseline: &'a Baseline<'a>,
    observables: &'a [Observable],
    /// Measured minus modelled.
    each: Vec<f64>,
    /// Sum of squares of all standardised errors.
    total: f64,
}

impl<'a> Errors<'a> {
    fn new(baseline: &'a Baseline<'a>) -> Errors<'a> {
        let (data, fit) = (&baseline.data, &baseline.fit);
        let observables = baseline.forward.observables();
        let each: Vec<f64> = data
            .rows
            .iter()
            .map(|&row| observables[row].misfit(fit.predicted[row]))
            .collect();
        let mut errors = Errors {
            baseline,
            observables,
            each,
            total: 0.0,
        };
        let squares = (0..errors.each.len()).map(|position| errors.square(position));
        errors.total = squares.sum::<f64>().max(f64::MIN_POSITIVE);
        errors
    }

    fn observable(&self, position: usize) -> &Observable {
        &self.observables[self.baseline.data.rows[position]]
    }

    fn sigma(&self, position: usize) -> f64 {
        let stated = self.observable(position).sigma;
        stated * self.baseline.scatter.scale * self.baseline.scatter.widening[position]
    }

    fn square(&self, position: usize) -> f64 {
        (self.each[position] / self.sigma(position)).powi(2)
    }

    fn covariance(&self, a: usize, b: usize) -> f64 {
        let slopes = &self.baseline.local.slopes;
        self.baseline.scatter.covariance[(a, b)] + slopes.row(a).dot(&slopes.row(b))
    }

    fn by_condition(&self) -> Vec<MisfitGroup> {
        let forward = self.baseline.forward;
        let mut by_condition = Vec::new();
        for (condition, positions) in self.baseline.data.conditions(forward) {
            let channel_of = |p: usize| self.observable(p).channel;
            let mut channels: Vec<Channel> = positions.iter().map(|&p| channel_of(p)).collect();
            channels.sort_unstable();
            channels.dedup();
            for channel in channels {
                let own: Vec<usize> = positions
                    .iter()
                    .copied()
                    .filter(|&p| channel_of(p) == channel)
                    .collect();
                by_condition.push(self.group(&forward.conditions()[condition].name, channel, &own));
            }
        }
        by_condition
    }

    /// The numbers `own` of one channel of one condition.
    fn group(&self, condition: &str, channel: Channel, own: &[usize]) -> MisfitGroup {
        let count = own.len() as f64;
        let variance: f64 = own
            .iter()
            .flat_map(|&a| own.iter().map(move |&b| (a, b)))
            .map(|(a, b)| self.covariance(a, b))
            .sum();
        let squares: f64 = own.iter().map(|&p| self.square(p)).sum();
        MisfitGroup {
            condition: condition.to_string(),
            channel,
            numbers: own.len(),
            share: squares / self.total,
            mean_error: own.iter().map(|&p| self.each[p]).sum::<f64>() / count,
            mean_uncertainty: variance.max(0.0).sqrt() / count,
            rms: (own.iter().map(|&p| self.each[p].powi(2)).sum::<f64>() / count).sqrt(),
            rms_sigma: (squares / count).sqrt(),
        }
    }

    fn by_station(&self) -> Vec<MisfitStation> {
        let conditions = self.baseline.forward.conditions();
        let mut tenths: BTreeMap<(Channel, usize), Vec<usize>> = BTreeMap::new();
        for position in 0..self.each.len() {
            let observable = self.observable(position);
            let Some(inner) = observable.r_mm else { continue };
            let middle = 0.5 * (inner + observable.r_to_mm.unwrap_or(inner));
            let place = middle / (1e3 * conditions[observable.condition].length_m);
            let tenth = ((10.0 * place) as usize).min(9);
            tenths
                .entry((observable.channel, tenth))
                .or_default()
                .push(position);
        }
        let by_station = tenths.into_iter().map(|((channel, tenth), own)| MisfitStation {
            r_over_length: (tenth as f64 + 0.5) / 10.0,
            channel,
            share: own.iter().map(|&p| self.square(p)).sum::<f64>() / self.total,
            mean_sigma: own.iter().map(|&p| self.each[p] / self.sigma(p)).sum::<f64>() / own.len() as f64,
        });
        by_station.collect()
    }
}

/// What a fit did to each unknown that was free in it.
pub fn pulls(forward: &dyn Forward, fit: &Fit) -> Vec<Pull> {
    let pulls = fit.free.iter().enumerate().map(|(position, &i)| {
        let unknown = &forward.unknowns()[i];
        let pull = (fit.at[i] - unknown.mean) / unknown.sigma;
        Pull {
            unknown: unknown.name.clone(),
            unit: unknown.unit.clone(),
            value: fit.at[i],
            standard_error: fit.covariance[(position, position)].sqrt(),
            pull,
            is_flagged: pull.abs() > FLAGGED_PULL,
            at_end: fit.at_end.contains(&i),
        }
    });
    pulls.collect()
}

/// The same of what every fit moves: inputs of the design, zeros and scales of the instruments.
pub fn pulls_of_inputs(forward: &dyn Forward, fit: &Fit) -> Vec<Pull> {
    let inputs = forward.unknowns().iter();
    let inputs = inputs.filter(|unknown| matches!(unknown.kind, UnknownKind::Input | UnknownKind::Ruler));
    let names: Vec<&str> = inputs.map(|unknown| unknown.name.as_str()).collect();
    let mut pulls = pulls(forward, fit);
    pulls.retain(|pull| names.contains(&pull.unknown.as_str()));
    pulls
}
