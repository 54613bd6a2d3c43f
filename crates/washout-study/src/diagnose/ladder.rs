//! Watch the error fall: raw, calibrated, with each effect, down to the noise; in the fit, left out, held out.

use nalgebra::DVector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::study::left_out::{Local, Others, by_condition};
use crate::study::{Fit, Observable};

use super::baseline::Baseline;

/// One step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LadderStep {
    /// `raw`, `calibrated`, `+ effect`, `noise`.
    pub name: String,
    /// Channel of the root mean squares: the one with the most numbers.
    pub channel: Channel,
    /// χ² per number of all that was fitted, with the scatter found and what the study admits to the model; none for `noise`.
    pub chi_square_per_number: Option<f64>,
    /// Root mean square error of what was fitted, in the unit of the channel.
    pub in_sample: f64,
    /// The same for each condition predicted from the others.
    pub left_out: Option<f64>,
    /// The same for held-out cases.
    pub held_out: Option<f64>,
    /// Root mean square error of all channels of held-out cases, each number in its stated standard deviation.
    pub held_out_sigma: Option<f64>,
}

/// A fit with what was found, and what it is called.
pub struct Explained<'a> {
    /// Its name.
    pub name: String,
    /// The fit.
    pub fit: &'a Fit,
    /// The data about it.
    pub local: Option<&'a Local>,
}

/// The steps; `explanations` are fitted with more and more effects.
pub fn ladder(baseline: &Baseline, explanations: &[Explained]) -> Vec<LadderStep> {
    let ladder = Ladder {
        baseline,
        channel: main_channel(baseline),
    };
    let mut steps = vec![
        ladder.step("raw", &baseline.raw, None),
        ladder.step("calibrated", &baseline.fit.predicted, Some(&baseline.local)),
    ];
    for Explained { name, fit, local } in explanations {
        steps.push(ladder.step(&format!("+ {name}"), &fit.predicted, *local));
    }
    steps.push(ladder.noise());
    steps
}

/// Root mean squares of the readings of one channel.
struct Ladder<'a> {
    baseline: &'a Baseline<'a>,
    channel: Channel,
}

impl Ladder<'_> {
    fn observable(&self, row: usize) -> &Observable {
        &self.baseline.forward.observables()[row]
    }

    fn rms(&self, rows: &[usize], predicted: &DVector<f64>) -> Option<f64> {
        let errors = rows.iter().filter_map(|&row| {
            let observable = self.observable(row);
            (observable.channel == self.channel).then(|| observable.misfit(predicted[row]))
        });
        root_mean_square(errors.collect())
    }

    fn left_out(&self, local: &Local) -> Option<f64> {
        let rows = &self.baseline.data.rows;
        let groups = by_condition(self.baseline.forward, rows);
        if groups.len() < 2 {
            return None;
        }
        let left = Others::new(local, &self.baseline.scatter.noise).leave_out(&groups)?;
        let errors = left
            .iter()
            .flat_map(|left| left.positions.iter().zip(&left.errors))
            .filter_map(|(&p, &error)| (self.observable(rows[p]).channel == self.channel).then_some(error));
        root_mean_square(errors.collect())
    }

    fn chi_square(&self, predicted: &DVector<f64>) -> f64 {
        let rows = &self.baseline.data.rows;
        let errors = rows
            .iter()
            .map(|&row| self.observable(row).misfit(predicted[row]));
        let errors = DVector::from_iterator(rows.len(), errors);
        self.baseline.scatter.noise.whiten(&errors).norm_squared() / rows.len().max(1) as f64
    }

    fn step(&self, name: &str, predicted: &DVector<f64>, local: Option<&Local>) -> LadderStep {
        let data = &self.baseline.data;
        LadderStep {
            name: name.to_string(),
            channel: self.channel,
            chi_square_per_number: Some(self.chi_square(predicted)),
            in_sample: self.rms(&data.rows, predicted).unwrap_or(0.0),
            left_out: local.and_then(|local| self.left_out(local)),
            held_out: self.rms(&data.held_out, predicted),
            held_out_sigma: held_out_sigma(self.baseline, predicted),
        }
    }

    fn noise(&self) -> LadderStep {
        let (data, scale) = (&self.baseline.data, self.baseline.scatter.scale);
        let noise = |rows: &[usize]| {
            let sigmas = rows.iter().filter_map(|&row| {
                let observable = self.observable(row);
                (observable.channel == self.channel).then_some(observable.sigma * scale)
            });
            root_mean_square(sigmas.collect())
        };
        LadderStep {
            name: "noise".into(),
            channel: self.channel,
            chi_square_per_number: None,
            in_sample: noise(&data.rows).unwrap_or(0.0),
            left_out: noise(&data.rows),
            held_out: noise(&data.held_out),
            held_out_sigma: (!data.held_out.is_empty()).then_some(scale),
        }
    }
}

/// Root mean square error of `predicted` for all held-out observables, each in its stated standard deviation.
pub fn held_out_sigma(baseline: &Baseline, predicted: &DVector<f64>) -> Option<f64> {
    let errors = baseline.data.held_out.iter().map(|&row| {
        let observable = &baseline.forward.observables()[row];
        observable.misfit(predicted[row]) / observable.sigma
    });
    root_mean_square(errors.collect())
}

fn main_channel(baseline: &Baseline) -> Channel {
    let mut channels: Vec<Channel> = baseline
        .data
        .rows
        .iter()
        .map(|&row| baseline.forward.observables()[row].channel)
        .collect();
    channels.sort_unstable();
    let count = |channel: Channel| channels.iter().filter(|other| **other == channel).count();
    channels
        .iter()
        .copied()
        .rev()
        .max_by_key(|&channel| count(channel))
        .unwrap_or(Channel::Twist)
}

fn root_mean_square(errors: Vec<f64>) -> Option<f64> {
    let count = errors.len() as f64;
    (!errors.is_empty()).then(|| (errors.iter().map(|error| error * error).sum::<f64>() / count).sqrt())
}
