//! Effects that by their derivative would lie very far out at their plausible size: they may saturate, so the model is asked.

use nalgebra::{DMatrix, DVector};

use crate::progress::Cancelled;
use crate::study::{Footing, Forward};

use super::baseline::Baseline;
use super::data::Data;
use super::error::where_solved;
use super::screening::effect_of;
use super::whitened::Whitened;

/// An effect whose plausible size lies further out by its derivative than this, sigma, is looked at in the full model.
pub const STRAIGHT: f64 = 100.0;

/// What the model has of such effects.
pub struct Far {
    /// How far the plausible size of each missing effect is in the model, sigma, what calibration takes up left out; none for those that
    /// are near, and those without a solution there.
    pub distance: Vec<Option<f64>>,
    /// Those without a solution there.
    pub unsolved: Vec<usize>,
}

impl Far {
    /// Of the effects that a model as calibrated lacks.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn new(baseline: &Baseline) -> Result<Far, Cancelled> {
        let (forward, data, fit) = (baseline.forward, &baseline.data, &baseline.fit);
        let unknowns = forward.unknowns();
        let from = (
            &fit.at[..],
            &fit.predicted,
            fit.footing.as_ref().map(Footing::for_trials),
        );
        let mut far = Far {
            distance: vec![None; data.missing.len()],
            unsolved: Vec::new(),
        };
        for (k, &i) in data.missing.iter().enumerate() {
            let size = effect_of(&unknowns[i]).map_or(0.0, |(_, _, scale, _)| scale);
            if size / unknowns[i].sigma * baseline.directions.lengths[k] <= STRAIGHT {
                continue;
            }
            far.distance[k] = distance(forward, data, &baseline.whitened, &from, (i, size))?;
            if far.distance[k].is_none() {
                far.unsolved.push(k);
            }
        }
        Ok(far)
    }
}

/// How far the model moves if one unknown gets a value, sigma, what calibration takes up left out; none if it has no solution there.
/// `from`: the other unknowns, what the model says there, and what it left there.
///
/// # Errors
/// If the user asked to stop.
pub fn distance(
    forward: &dyn Forward,
    data: &Data,
    whitened: &Whitened,
    (at, value, footing): &(&[f64], &DVector<f64>, Option<Footing>),
    (unknown, moved_to): (usize, f64),
) -> Result<Option<f64>, Cancelled> {
    let mut there = at.to_vec();
    there[unknown] = moved_to;
    let answer = where_solved(forward.linearize_from(footing.as_ref(), &there, &|_| false))?;
    Ok(answer.map(|(there, _)| {
        let mut moved = DMatrix::from_column_slice(value.len(), 1, (there.value - *value).as_slice());
        for row in data.kept_bounds(forward, value) {
            moved.row_mut(row).fill(0.0);
        }
        whitened.directions(&moved).norm()
    }))
}
