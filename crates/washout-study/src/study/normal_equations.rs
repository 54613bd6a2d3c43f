//! One Gauss-Newton step of a fit: the linear least-squares problem about a point, and its damped solution in a box.

use nalgebra::{DMatrix, DVector};

use crate::input::measurement::Bound;
use crate::structure::larger;

use super::boxed::least_in_box;
use super::forward::{Forward, Linear};
use super::task::Task;

/// The least-squares problem about one point, in prior standard deviations and whitened.
pub(super) struct NormalEquations {
    /// Measured minus modelled.
    pub residual: DVector<f64>,
    /// Derivatives of what is modelled (fitted observables × free unknowns).
    pub slopes: DMatrix<f64>,
    /// Where the free unknowns stand, from the means of their priors.
    pub prior: DVector<f64>,
}

/// A step of all unknowns.
pub(super) struct Step {
    /// Where it ends, in the units of the unknowns.
    pub at: Vec<f64>,
    /// Its largest part, in standard deviations of the posterior.
    pub size: f64,
}

impl Step {
    /// A share of the way.
    pub fn shortened(self, from: &[f64], length: f64) -> Step {
        let part = |(start, end): (&f64, f64)| {
            if length == 1.0 {
                end
            } else {
                start + length * (end - start)
            }
        };
        Step {
            at: from.iter().zip(self.at).map(part).collect(),
            size: length * self.size,
        }
    }
}

impl NormalEquations {
    /// Of the fitted observables, where the model is `linear`.
    pub fn new(forward: &dyn Forward, task: &Task, at: &[f64], linear: &Linear) -> NormalEquations {
        let (observables, unknowns) = (forward.observables(), forward.unknowns());
        let errors = task
            .rows
            .iter()
            .map(|&row| observables[row].misfit(linear.value[row]));
        let errors = DVector::from_iterator(task.rows.len(), errors);
        let slopes = DMatrix::from_fn(task.rows.len(), task.free.len(), |i, j| {
            let kept = observables[task.rows[i]].bound != Bound::None && errors[i] == 0.0;
            let slope = linear.jacobian[(task.rows[i], task.free[j])];
            if kept {
                0.0
            } else {
                slope * unknowns[task.free[j]].sigma
            }
        });
        let prior = task
            .free
            .iter()
            .map(|&i| (at[i] - unknowns[i].mean) / unknowns[i].sigma);
        NormalEquations {
            residual: task.noise.whiten(&errors),
            slopes: task.noise.whiten_columns(&slopes),
            prior: DVector::from_iterator(task.free.len(), prior),
        }
    }

    /// Q: misfit plus price of the priors.
    pub fn q(&self) -> f64 {
        self.residual.norm_squared() + self.prior.norm_squared()
    }

    /// Half of the curvature of Q.
    pub fn curvature(&self) -> DMatrix<f64> {
        let size = self.prior.len();
        self.slopes.transpose() * &self.slopes + DMatrix::identity(size, size)
    }

    /// The damped step that Q falls most by in the linear model, within the ranges of the unknowns.
    pub fn step(&self, forward: &dyn Forward, free: &[usize], at: &[f64], damping: f64) -> Step {
        let unknowns = forward.unknowns();
        let push = self.slopes.transpose() * &self.residual - &self.prior;
        let mut curvature = self.curvature();
        let diagonal = curvature.diagonal();
        curvature.set_diagonal(&(&diagonal * (1.0 + damping)));
        let room = |end: usize| {
            let room = free
                .iter()
                .map(|&i| (unknowns[i].range[end] - at[i]) / unknowns[i].sigma);
            DVector::from_iterator(free.len(), room)
        };
        let step = least_in_box(&curvature, &push, &room(0), &room(1));
        let mut moved = at.to_vec();
        let mut size: f64 = 0.0;
        for (k, &i) in free.iter().enumerate() {
            let [low, high] = unknowns[i].range;
            moved[i] = (at[i] + step[k] * unknowns[i].sigma).clamp(low, high);
            let width = unknowns[i].sigma / diagonal[k].sqrt();
            size = larger(size, (moved[i] - at[i]).abs() / width);
        }
        Step { at: moved, size }
    }
}
