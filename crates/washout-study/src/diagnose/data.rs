//! What is fitted, what may move, what may be added; in an order that does not depend on that of the files.

use std::cmp::Ordering;

use nalgebra::DVector;

use crate::input::measurement::Bound;
use crate::study::left_out::conditions_of;
use crate::study::{Forward, Unknown, UnknownKind};

use super::error::DiagnoseError;
use super::settings::Settings;

/// Indices of what a diagnosis works with.
#[derive(Debug, Clone, PartialEq)]
pub struct Data {
    /// Observables that are fitted, sorted by what they are.
    pub rows: Vec<usize>,
    /// Observables that are kept out of every fit.
    pub held_out: Vec<usize>,
    /// Unknowns that the model has: inputs, ruler, effects that were added.
    pub model: Vec<usize>,
    /// Strengths of effects that the model lacks.
    pub missing: Vec<usize>,
}

/// Whether an unknown is the strength of an effect that the model lacks: its prior is centred at none, and so it starts.
pub fn is_missing(unknown: &Unknown, start: f64) -> bool {
    matches!(unknown.kind, UnknownKind::Effect { .. }) && unknown.mean == 0.0 && start == 0.0
}

/// Where the unknowns start: as the settings say, or at the means of their priors.
///
/// # Errors
/// If the settings give another count of values.
pub fn start(forward: &dyn Forward, settings: &Settings) -> Result<Vec<f64>, DiagnoseError> {
    let unknowns = forward.unknowns();
    match &settings.start {
        None => Ok(unknowns.iter().map(|unknown| unknown.mean).collect()),
        Some(start) if start.len() == unknowns.len() => Ok(start.clone()),
        Some(start) => Err(DiagnoseError::BadSetting {
            name: "count of start values",
            value: start.len() as f64,
            cure: "give one value for each unknown",
        }),
    }
}

impl Data {
    /// Of a model whose unknowns start at `start`.
    ///
    /// # Errors
    /// If there is nothing to fit or no effect to try.
    pub fn new(forward: &dyn Forward, start: &[f64]) -> Result<Data, DiagnoseError> {
        let (observables, conditions) = (forward.observables(), forward.conditions());
        let order = |&a: &usize, &b: &usize| compare(forward, a, b);
        let (mut held_out, mut rows): (Vec<usize>, Vec<usize>) =
            (0..observables.len()).partition(|&row| conditions[observables[row].condition].is_held_out);
        rows.sort_by(order);
        held_out.sort_by(order);
        let unknowns = forward.unknowns();
        let (missing, model): (Vec<usize>, Vec<usize>) = (0..unknowns.len())
            .filter(|&i| {
                !matches!(
                    unknowns[i].kind,
                    UnknownKind::Place { .. } | UnknownKind::Unnamed { .. }
                )
            })
            .partition(|&i| is_missing(&unknowns[i], start[i]));
        if rows.is_empty() {
            return Err(DiagnoseError::NoData);
        }
        if missing.is_empty() {
            return Err(DiagnoseError::NoEffects);
        }
        Ok(Data {
            rows,
            held_out,
            model,
            missing,
        })
    }

    /// Fitted observables that are bounds which the model keeps with predictions `value`: they carry no information.
    pub fn kept_bounds(&self, forward: &dyn Forward, value: &DVector<f64>) -> Vec<usize> {
        let observables = forward.observables();
        let is_kept =
            |row: usize| observables[row].bound != Bound::None && observables[row].misfit(value[row]) == 0.0;
        self.rows.iter().copied().filter(|&row| is_kept(row)).collect()
    }

    /// Conditions that are fitted, each with the positions of its observables in [`Data::rows`].
    pub fn conditions(&self, forward: &dyn Forward) -> Vec<(usize, Vec<usize>)> {
        conditions_of(forward, &self.rows)
    }
}

fn compare(forward: &dyn Forward, a: usize, b: usize) -> Ordering {
    let key = |row: usize| {
        let observable = &forward.observables()[row];
        let condition = &forward.conditions()[observable.condition];
        let numbers = [
            condition.length_m,
            condition.frequency_hz.unwrap_or(-1.0),
            condition.half_amplitude_deg.unwrap_or(-1.0),
            condition.dynamic_pressure_pa,
            observable.r_mm.unwrap_or(-1.0),
            observable.r_to_mm.unwrap_or(-1.0),
            observable.value,
            observable.sigma,
        ];
        (observable.channel, numbers)
    };
    let ((channel_a, numbers_a), (channel_b, numbers_b)) = (key(a), key(b));
    let numbers = numbers_a.iter().zip(&numbers_b);
    channel_a.cmp(&channel_b).then_with(|| {
        numbers
            .map(|(x, y)| x.total_cmp(y))
            .fold(Ordering::Equal, Ordering::then)
    })
}
