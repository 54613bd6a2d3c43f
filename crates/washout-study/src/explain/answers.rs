//! How the readings answer to every change alone: what the search adds up. It does not depend on what was measured.

use nalgebra::DVector;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use serde::{Deserialize, Serialize};

use crate::diagnose::Cache;
use crate::diagnose::data::Data;
use crate::diagnose::error::where_solved;
use crate::diagnose::interpolate::{Curve, Measure};
use crate::diagnose::responses::Responses;
use crate::diagnose::screening::slopes_of_missing;
use crate::program::program_sha256;
use crate::progress::Progress;
use crate::study::{Forward, Unknown, UnknownKind, WarmStart};

use super::error::ExplainError;
use super::model::Model;

/// Where between its mean and an end of its range a number is looked at.
const STEPS: [f64; 2] = [0.5, 1.0];

/// How the readings of a study answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Answers {
    /// The readings as the model stands.
    pub base: Vec<f64>,
    /// Strengths of effects, by index of the unknown.
    pub effects: Vec<usize>,
    /// How they answer to each of these.
    pub responses: Responses,
    /// Numbers and nuisances of the ruler: index of the unknown, and the change of the readings by its distance from where it starts.
    pub inputs: Vec<(usize, Curve)>,
}

impl Answers {
    /// Of a model.
    ///
    /// # Errors
    /// If there is nothing to explain, the model has no solution as it stands, or the user asked to stop.
    pub fn new(model: &Model, progress: &Progress) -> Result<Answers, ExplainError> {
        let start = model.start();
        let data = Data::new(model, &start)?;
        let settings = crate::diagnose::Settings::default();
        let slopes = slopes_of_missing(model, &data, &start, &settings, None)?;
        progress.check()?;
        let warm_start = slopes.warm_start.as_ref().map(WarmStart::roughly);
        let responses = Responses::new(
            model,
            &data,
            &start,
            (&slopes.missing, warm_start.as_ref()),
            progress,
        )?;
        let (base, left) = model.linearize_from(None, &start, &|_| false)?;
        let left = left.as_ref().map(WarmStart::roughly);
        let moved = |i: usize| -> Result<(usize, Curve), ExplainError> {
            progress.check()?;
            let unknown = &model.unknowns()[i];
            let mut knots = vec![(0.0, DVector::zeros(base.value.len()))];
            for step in steps(unknown, start[i]) {
                let mut there = start.clone();
                there[i] = start[i] + step;
                let found = where_solved(model.linearize_from(left.as_ref(), &there, &|_| false))?;
                knots.extend(found.map(|(linear, _)| (step, linear.value - &base.value)));
            }
            knots.sort_by(|a, b| a.0.total_cmp(&b.0));
            let curve = Curve {
                knots,
                slope: Vec::new(),
                measure: Measure::Even,
            };
            Ok((i, curve))
        };
        let is_moved = |&i: &usize| {
            let unknown = &model.unknowns()[i];
            let is_number = matches!(unknown.kind, UnknownKind::Input | UnknownKind::Ruler);
            is_number || (matches!(unknown.kind, UnknownKind::Effect { .. }) && !data.missing.contains(&i))
        };
        let numbers: Vec<usize> = (0..model.unknowns().len()).filter(is_moved).collect();
        let inputs: Result<Vec<(usize, Curve)>, ExplainError> = numbers.into_par_iter().map(moved).collect();
        Ok(Answers {
            base: base.value.as_slice().to_vec(),
            effects: data.missing.clone(),
            responses,
            inputs: inputs?,
        })
    }

    /// The same, or what an earlier run has kept of it.
    ///
    /// # Errors
    /// As [`Answers::new`].
    pub fn kept(model: &Model, cache: &Cache, progress: &Progress) -> Result<Answers, ExplainError> {
        let made_of = format!("{}{}explain", program_sha256(), model.campaign().made_of());
        if let Some(known) = cache.read(&made_of).filter(|known: &Answers| known.is_of(model)) {
            return Ok(known);
        }
        let answers = Answers::new(model, progress)?;
        cache.keep(&made_of, &answers);
        Ok(answers)
    }

    /// Whether it is of this model.
    pub fn is_of(&self, model: &Model) -> bool {
        let (rows, count) = (model.observables().len(), model.unknowns().len());
        self.base.len() == rows
            && self.responses.each.len() == self.effects.len()
            && self.responses.each.iter().all(|own| own.is_of(rows))
            && self
                .effects
                .iter()
                .chain(self.inputs.iter().map(|own| &own.0))
                .all(|own| *own < count)
            && self
                .inputs
                .iter()
                .all(|(_, curve)| curve.knots.iter().all(|knot| knot.1.len() == rows))
    }
}

/// Distances from its start at which a number is looked at, to either side.
fn steps(unknown: &Unknown, start: f64) -> Vec<f64> {
    let wide = 3.0 * unknown.sigma;
    let [low, high] = unknown.range;
    let ends = [(low - start).max(-wide), (high - start).min(wide)];
    let steps = ends.iter().flat_map(|end| STEPS.map(|share| share * end));
    steps.filter(|step| *step != 0.0).collect()
}
