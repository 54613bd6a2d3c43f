//! Explanations: one or two effects fitted together with everything that the model has.

use nalgebra::{Cholesky, DMatrix, DVector};

use crate::study::boxed::least_in_box;
use crate::study::left_out::Local;
use crate::study::{Fit, Footing, Forward};

use super::data::{Data, Scatter};
use super::error::DiagnoseError;
use super::evidence::Likelihood;
use super::prior::StrengthPrior;
use super::screening::{place_of, whole_strength};

/// Largest step from zero at which a refit starts, in prior standard deviations.
const LONGEST_START: f64 = 2.0;

/// One or two effects that may be what is missing.
#[derive(Debug, Clone)]
pub struct Explanation {
    /// Positions of their strengths among the missing effects.
    pub members: Vec<usize>,
    /// Logarithm of the evidence, on a scale common to all explanations of the same data.
    pub ln_evidence: f64,
    /// Least Q.
    pub q: f64,
    /// Strengths, in their units.
    pub strength: Vec<f64>,
    /// Their standard errors.
    pub standard_error: Vec<f64>,
    /// Where each sits and the standard error of that, if it could move.
    pub places: Vec<Option<[f64; 2]>>,
    /// The fit; none if only the linear model was asked.
    pub fit: Option<Fit>,
    /// The data about the fit.
    pub local: Option<Local>,
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
    pub footing: Option<&'a Footing>,
    /// How the noise enters.
    pub likelihood: Likelihood,
}

impl Refits<'_> {
    /// Fits the effects `members` with the model, from `estimates` (in prior standard deviations). None if no fit settles below
    /// the misfit without them.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn refit(&self, members: &[usize], estimates: &[f64]) -> Result<Option<Explanation>, DiagnoseError> {
        let starts = [
            self.start(members, estimates),
            self.cautious_start(members, estimates),
        ];
        self.refit_from(members, &starts)
    }

    /// The same from given values of all unknowns, the first first.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn refit_from(
        &self,
        members: &[usize],
        starts: &[Vec<f64>],
    ) -> Result<Option<Explanation>, DiagnoseError> {
        let unknowns = self.forward.unknowns();
        let effects: Vec<usize> = members.iter().map(|&k| self.data.missing[k]).collect();
        let (whole, fitted): (Vec<usize>, Vec<usize>) = effects
            .iter()
            .partition(|&&effect| whole_strength(&unknowns[effect]).is_some());
        let mut free = self.data.model.clone();
        free.extend(&fitted);
        free.extend(self.places(&effects));
        let most = self.baseline.q + 1e-6 * (1.0 + self.baseline.q);
        for start in starts {
            let mut start = start.clone();
            for &effect in &whole {
                start[effect] = whole_strength(&unknowns[effect]).unwrap_or_default();
            }
            let fit = match self
                .scatter
                .fit(self.forward, self.data, &free, &start, self.footing)
            {
                Ok(fit) => fit,
                Err(DiagnoseError::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(_) => continue,
            };
            // what is all or none stands as it is, be the misfit larger with it
            if fit.q <= most || fitted.is_empty() {
                return Ok(Some(self.explanation(members, fit)));
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
    fn explanation(&self, members: &[usize], fit: Fit) -> Explanation {
        let unknowns = self.forward.unknowns();
        let column = |unknown: usize| fit.free.iter().position(|&i| i == unknown);
        let size = fit.slopes.ncols();
        let curvature = DMatrix::identity(size, size) + fit.slopes.transpose() * &fit.slopes;
        let mut ln_evidence = self.likelihood.ln(fit.q) - 0.5 * ln_determinant(curvature);
        let variance = self.likelihood.variance(fit.q);
        let (mut strength, mut standard_error) = (Vec::new(), Vec::new());
        let error_of = |column: usize| (variance * fit.covariance[(column, column)]).sqrt();
        let effects = members.iter().map(|&k| self.data.missing[k]);
        for unknown in effects.clone() {
            let error = column(unknown).map_or(0.0, error_of);
            let own = &unknowns[unknown];
            if let Some(prior) = StrengthPrior::of(own).filter(|_| error > 0.0) {
                ln_evidence += prior.ln_factor(fit.at[unknown] / own.sigma, error / own.sigma);
            }
            strength.push(fit.at[unknown]);
            standard_error.push(error);
        }
        let place = |unknown: usize| {
            let own = place_of(unknowns, unknown)?;
            Some([fit.at[own], error_of(column(own)?)])
        };
        let places = effects.map(place).collect();
        Explanation {
            members: members.to_vec(),
            ln_evidence,
            q: fit.q,
            strength,
            standard_error,
            places,
            local: Some(Local::about(&fit, self.forward, &self.scatter.noise)),
            fit: Some(fit),
        }
    }

    /// Where the linear model is best within the ranges of all unknowns; of two effects at the strengths of the estimates.
    fn start(&self, members: &[usize], estimates: &[f64]) -> Vec<f64> {
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
                    Some(member) if members.len() > 1 => estimates[member].clamp(
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

    /// The fit without an effect, and the effect at an estimate (in prior standard deviations).
    pub fn stepped(&self, member: usize, estimate: f64) -> Vec<f64> {
        let effect = self.data.missing[member];
        let unknown = &self.forward.unknowns()[effect];
        let [low, high] = unknown.range;
        let mut at = self.baseline.at.clone();
        at[effect] = (unknown.mean + estimate * unknown.sigma).clamp(low, high);
        at
    }

    /// The fit without the effects, and the effects a little off zero.
    fn cautious_start(&self, members: &[usize], estimates: &[f64]) -> Vec<f64> {
        let unknowns = self.forward.unknowns();
        let mut at = self.baseline.at.clone();
        for (&k, estimate) in members.iter().zip(estimates) {
            let effect = self.data.missing[k];
            let [low, high] = unknowns[effect].range;
            at[effect] = (0.05 * unknowns[effect].sigma * estimate.signum()).clamp(low, high);
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
