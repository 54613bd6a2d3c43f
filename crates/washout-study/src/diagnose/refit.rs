//! Explanations: one or two effects fitted together with everything that the model has.

use nalgebra::{Cholesky, DMatrix, DVector};

use crate::study::boxed::least_in_box;
use crate::study::left_out::Local;
use crate::study::{Fit, Forward, WarmStart};

use super::baseline::Baseline;
use super::data::Data;
use super::error::DiagnoseError;
use super::evidence::Likelihood;
use super::library::Trial;
use super::scatter::Scatter;
use super::screening::{place_of, whole_strength};

/// Largest step from zero at which a refit starts, in prior standard deviations.
const LONGEST_START: f64 = 2.0;

/// One or two effects that may be what is missing.
#[derive(Debug, Clone)]
pub struct Explanation {
    /// Positions of their strengths among the missing effects.
    pub members: Vec<usize>,
    /// Least Q.
    pub q: f64,
    /// Strengths, in their units.
    pub strength: Vec<f64>,
    /// Their standard errors.
    pub standard_error: Vec<f64>,
    /// Where each sits and the standard error of that, if it could move.
    pub places: Vec<Option<[f64; 2]>>,
    /// The fit.
    pub fit: Fit,
    /// The data about the fit.
    pub local: Local,
}

/// What is common to all refits of one study.
pub struct Refits<'a> {
    /// The model.
    pub forward: &'a dyn Forward,
    /// What is fitted.
    pub data: &'a Data,
    /// Its scatter.
    pub scatter: &'a Scatter,
    /// The fit without any missing effect.
    pub baseline: &'a Fit,
    /// Derivatives of all observables with the missing effects, per prior standard deviation.
    pub slopes: &'a DMatrix<f64>,
    /// What the model left where these hold.
    pub warm_start: Option<&'a WarmStart>,
    /// How the noise enters.
    pub likelihood: Likelihood,
}

impl<'a> Refits<'a> {
    /// What fits with effects start from; `warm_start`: what the model left at the fit.
    pub fn of(baseline: &'a Baseline, warm_start: Option<&'a WarmStart>) -> Refits<'a> {
        Refits {
            forward: baseline.forward,
            data: &baseline.data,
            scatter: &baseline.scatter,
            baseline: &baseline.fit,
            slopes: &baseline.slopes,
            warm_start,
            likelihood: baseline.likelihood,
        }
    }

    /// Fits the effects of a trial with the model, in whose errors those of the effects' formulas stand. None if no fit settles below the
    /// misfit without them.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn refit(&self, baseline: &Baseline, trial: &Trial) -> Result<Option<Explanation>, DiagnoseError> {
        let size = self.data.rows.len();
        let mut own = DMatrix::zeros(size, size);
        for (&k, &best) in trial.members.iter().zip(&trial.best) {
            let share = self.forward.unknowns()[self.data.missing[k]].own_error();
            own += baseline.error.own(&baseline.change(k, best), share, 1.0);
        }
        let scatter = baseline.scatter_under(trial)?.with(&own)?;
        let starts = [
            self.stepped(&trial.members, &trial.best),
            self.start(&trial.members, &trial.best),
        ];
        self.refit_from(&trial.members, &starts, &scatter)
    }

    /// The same from given values of all unknowns, the first first.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn refit_from(
        &self,
        members: &[usize],
        starts: &[Vec<f64>],
        scatter: &Scatter,
    ) -> Result<Option<Explanation>, DiagnoseError> {
        let unknowns = self.forward.unknowns();
        let effects: Vec<usize> = members.iter().map(|&k| self.data.missing[k]).collect();
        let (whole, fitted): (Vec<usize>, Vec<usize>) = effects
            .iter()
            .partition(|&&effect| whole_strength(&unknowns[effect]).is_some());
        let mut free = self.data.model.clone();
        free.extend(&fitted);
        free.extend(self.places(&effects));
        let observables = self.forward.observables();
        let left = |&row: &usize| observables[row].misfit(self.baseline.predicted[row]);
        let left = DMatrix::from_iterator(self.data.rows.len(), 1, self.data.rows.iter().map(left));
        let without = scatter.noise.whiten_columns(&left).norm_squared();
        let without = without + self.baseline.q - self.baseline.misfit;
        let most = without + 1e-6 * (1.0 + without);
        for start in starts {
            let mut start = start.clone();
            for &effect in &whole {
                start[effect] = whole_strength(&unknowns[effect]).unwrap_or_default();
            }
            let fit = match scatter.fit(self.forward, self.data, &free, &start, self.warm_start) {
                Ok(fit) => fit,
                Err(DiagnoseError::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(_) => continue,
            };
            // what is all or none stands as it is, be the misfit larger with it
            if fit.q <= most || fitted.is_empty() {
                return Ok(Some(self.explanation(members, fit, scatter)));
            }
        }
        Ok(None)
    }

    /// Where the effects sit, as far as that is free.
    fn places(&self, effects: &[usize]) -> Vec<usize> {
        let unknowns = self.forward.unknowns();
        effects
            .iter()
            .filter_map(|&effect| place_of(unknowns, effect))
            .collect()
    }

    /// The explanation by a fit in which `members` were free, as far as they are not all or none.
    fn explanation(&self, members: &[usize], fit: Fit, scatter: &Scatter) -> Explanation {
        let unknowns = self.forward.unknowns();
        let column = |unknown: usize| fit.free.iter().position(|&i| i == unknown);
        let variance = self.likelihood.variance(fit.q).max(1.0);
        let (mut strength, mut standard_error) = (Vec::new(), Vec::new());
        let error_of = |column: usize| (variance * fit.covariance[(column, column)]).sqrt();
        let effects = members.iter().map(|&k| self.data.missing[k]);
        for unknown in effects.clone() {
            strength.push(fit.at[unknown]);
            standard_error.push(column(unknown).map_or(0.0, error_of));
        }
        let place = |unknown: usize| {
            let own = place_of(unknowns, unknown)?;
            Some([fit.at[own], error_of(column(own)?)])
        };
        let places = effects.map(place).collect();
        Explanation {
            members: members.to_vec(),
            q: fit.q,
            strength,
            standard_error,
            places,
            local: Local::about(&fit, self.forward, &scatter.noise),
            fit,
        }
    }

    /// Where the linear model is best within the ranges of all unknowns; of two effects at these strengths.
    fn start(&self, members: &[usize], strengths: &[f64]) -> Vec<f64> {
        let unknowns = self.forward.unknowns();
        let mut at = self.baseline.at.clone();
        let effects: Vec<usize> = members.iter().map(|&k| self.data.missing[k]).collect();
        let seen = self.slopes.select_columns(members).select_rows(&self.data.rows);
        let seen = self.scatter.noise.whiten_columns(&seen);
        let Fit {
            free,
            slopes,
            residual,
            ..
        } = self.baseline;
        let moving: Vec<usize> = free.iter().chain(&effects).copied().collect();
        let (rows, first, size) = (slopes.nrows(), free.len(), moving.len());
        let slopes = DMatrix::from_fn(rows, size, |i, j| match j.checked_sub(first) {
            None => slopes[(i, j)],
            Some(member) => seen[(i, member)],
        });
        let in_sigmas = |i: usize, value: f64| (value - at[i]) / unknowns[i].sigma;
        let room = |end: usize| {
            let room = moving.iter().enumerate().map(|(place, &i)| {
                let room = in_sigmas(i, unknowns[i].range[end]);
                match place.checked_sub(first) {
                    None => room,
                    Some(member) if members.len() > 1 => in_sigmas(i, strengths[member]).clamp(
                        in_sigmas(i, unknowns[i].range[0]).max(-LONGEST_START),
                        in_sigmas(i, unknowns[i].range[1]).min(LONGEST_START),
                    ),
                    Some(_) => room.clamp(-LONGEST_START, LONGEST_START),
                }
            });
            DVector::from_iterator(size, room)
        };
        let prior = moving.iter().map(|&i| -in_sigmas(i, unknowns[i].mean));
        let push = slopes.transpose() * residual - DVector::from_iterator(size, prior);
        let curvature = DMatrix::identity(size, size) + slopes.transpose() * &slopes;
        let step = least_in_box(&curvature, &push, &room(0), &room(1));
        for (&i, step) in moving.iter().zip(step.iter()) {
            let [low, high] = unknowns[i].range;
            at[i] = (at[i] + step * unknowns[i].sigma).clamp(low, high);
        }
        at
    }

    /// The fit without the effects, and the effects at these strengths.
    pub fn stepped(&self, members: &[usize], strengths: &[f64]) -> Vec<f64> {
        let mut at = self.baseline.at.clone();
        for (&k, &strength) in members.iter().zip(strengths) {
            let effect = self.data.missing[k];
            let [low, high] = self.forward.unknowns()[effect].range;
            at[effect] = strength.clamp(low, high);
        }
        at
    }
}

/// Logarithm of the determinant of a positive definite matrix; 0 if it is none.
pub(super) fn ln_determinant(matrix: DMatrix<f64>) -> f64 {
    Cholesky::new(matrix).map_or(0.0, |factor| {
        2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>()
    })
}
