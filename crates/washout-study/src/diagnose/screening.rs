//! Every effect at one glance: its direction, its score, its strength by one step, and whether it could have been seen.

use nalgebra::{DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statrs::distribution::{ContinuousCDF, Normal};

use crate::study::{Forward, Unknown, UnknownKind, WarmStart};

use super::data::Data;
use super::error::DiagnoseError;
use super::settings::Settings;
use super::whitened::Whitened;

/// Power from which on an effect of its plausible size counts as detectable.
pub const ENOUGH_POWER: f64 = 0.8;
/// Share of its plausible size from which on an effect must have been seen to be called absent.
pub const MATTERS: f64 = 1.0 / 3.0;

/// Level of one score when any of `count` effects may raise the alarm, with a margin of three.
pub fn family_wise(level: f64, count: usize) -> f64 {
    level / (3 * count.max(1)) as f64
}

/// What one glance tells of an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sight {
    /// Its score is beyond chance, though many were tried: it is there, or one that looks like it.
    Possible,
    /// It would have been seen at a third of its plausible size, and was not.
    Absent,
    /// This campaign cannot tell.
    Undecidable,
}

/// Probability that a score of this size is seen with false alarms at `level`.
pub fn power_at_distance(distance: f64, one_sided: bool, level: f64) -> f64 {
    let normal = Normal::standard();
    1.0 - normal.cdf(threshold(one_sided, level) - distance)
}

fn threshold(one_sided: bool, level: f64) -> f64 {
    let tail = if one_sided { level } else { 0.5 * level };
    Normal::standard().inverse_cdf(1.0 - tail)
}

/// Directions of the effects that the model lacks.
#[derive(Debug, Clone)]
pub struct Directions {
    /// The unknowns, in order of the columns.
    pub unknowns: Vec<usize>,
    /// Columns of unit covariance, per prior standard deviation.
    pub columns: DMatrix<f64>,
    /// Scores: products of the unit directions with the residual.
    pub scores: Vec<f64>,
    /// Lengths of the columns.
    pub lengths: Vec<f64>,
    /// Scalar products of the columns.
    pub gram: DMatrix<f64>,
}

/// Effect, family, scale and one-sidedness of an unknown that is an effect.
pub fn effect_of(unknown: &Unknown) -> Option<(&str, &str, f64, bool)> {
    match &unknown.kind {
        UnknownKind::Effect {
            effect,
            family,
            scale,
            one_sided,
            ..
        } => Some((effect, family, *scale, *one_sided)),
        _ => None,
    }
}

/// The strength of an effect that is there with its plausible size or not at all.
pub fn whole_strength(unknown: &Unknown) -> Option<f64> {
    match unknown.kind {
        UnknownKind::Effect {
            all_or_none: true,
            scale,
            ..
        } => Some(scale),
        _ => None,
    }
}

/// The unknown that says where an effect sits, if that is not known: its index, for the index of its strength.
pub fn place_of(unknowns: &[Unknown], strength: usize) -> Option<usize> {
    let name = &unknowns[strength].name;
    unknowns
        .iter()
        .position(|unknown| matches!(&unknown.kind, UnknownKind::Place { of, .. } if of == name))
}

/// Whether only strengths of one sign make sense.
pub fn is_one_sided(unknown: &Unknown) -> bool {
    effect_of(unknown).is_some_and(|(_, _, _, one_sided)| one_sided)
}

/// How all observables answer about one point.
#[derive(Debug, Clone)]
pub struct Slopes {
    /// To the missing effects, one column each, per prior standard deviation.
    pub missing: DMatrix<f64>,
    /// What the model left there.
    pub warm_start: Option<WarmStart>,
}

/// Derivatives of all observables with the missing effects at `at`, one column each, per prior standard deviation.
///
/// An effect with a kink at zero is seen from a step. `warm_start`: what the model left nearby.
///
/// # Errors
/// If the model has no solution there, or a derivative is not finite.
pub fn slopes_of_missing(
    forward: &dyn Forward,
    data: &Data,
    at: &[f64],
    settings: &Settings,
    warm_start: Option<&WarmStart>,
) -> Result<Slopes, DiagnoseError> {
    let unknowns = forward.unknowns();
    let names: Vec<&str> = data.missing.iter().map(|&i| unknowns[i].name.as_str()).collect();
    let wanted = |unknown: &Unknown| names.contains(&unknown.name.as_str());
    let (linear, left) = forward.linearize_from(warm_start, at, &wanted)?;
    let mut slopes = linear.jacobian.select_columns(data.missing.iter());
    for (k, &i) in data.missing.iter().enumerate() {
        let switch = matches!(unknowns[i].kind, UnknownKind::Effect { has_switch: true, .. });
        if let (true, Some(share), Some((_, _, scale, _))) =
            (switch, settings.switch_step, effect_of(&unknowns[i]))
        {
            let mut stepped = at.to_vec();
            stepped[i] += share * scale;
            let moved = forward.predict(&stepped)?;
            slopes.set_column(k, &((moved - &linear.value) / (share * scale)));
        }
        let mut column = slopes.column_mut(k);
        column *= unknowns[i].sigma;
        if column.iter().any(|slope| !slope.is_finite()) {
            return Err(DiagnoseError::NotFinite {
                what: unknowns[i].name.clone(),
            });
        }
    }
    for row in data.kept_bounds(forward, &linear.value) {
        slopes.row_mut(row).fill(0.0);
    }
    Ok(Slopes {
        missing: slopes,
        warm_start: left,
    })
}

impl Directions {
    /// From `slopes` of [`slopes_of_missing`], about what was fitted.
    pub fn new(data: &Data, slopes: &DMatrix<f64>, whitened: &Whitened) -> Directions {
        let columns = whitened.directions(slopes);
        let gram = columns.transpose() * &columns;
        let lengths: Vec<f64> = gram
            .diagonal()
            .iter()
            .map(|square| square.max(0.0).sqrt())
            .collect();
        let dots = columns.transpose() * &whitened.residual;
        let scores = dots
            .iter()
            .zip(&lengths)
            .map(|(dot, length)| if *length > 1e-9 { dot / length } else { 0.0 })
            .collect();
        Directions {
            unknowns: data.missing.clone(),
            columns,
            scores,
            lengths,
            gram,
        }
    }

    /// Cosine between two directions.
    pub fn cosine(&self, a: usize, b: usize) -> f64 {
        let lengths = self.lengths[a] * self.lengths[b];
        if lengths > 1e-18 {
            (self.gram[(a, b)] / lengths).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    }

    /// Length of what is `seen` with the nearest of some directions left out, each with whether only one sign of it makes sense.
    pub fn beyond(&self, seen: &DVector<f64>, others: impl Iterator<Item = (usize, bool)>) -> f64 {
        let along = others.map(|(k, one_sided)| {
            let along = seen.dot(&self.columns.column(k)) / self.lengths[k];
            if one_sided { along.max(0.0) } else { along }
        });
        let nearest = along.map(|along| along * along).fold(0.0, f64::max);
        (seen.norm_squared() - nearest).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_seen_beyond_the_nearest_effect_is_the_rest_of_the_right_angle() {
        let columns = DMatrix::from_columns(&[
            DVector::from_vec(vec![2.0, 0.0, 0.0]),
            DVector::from_vec(vec![0.0, 0.5, 0.0]),
            DVector::from_vec(vec![0.0, 0.0, 1.0]),
        ]);
        let directions = Directions {
            unknowns: vec![0, 1, 2],
            scores: vec![0.0; 3],
            lengths: vec![2.0, 0.5, 1.0],
            gram: columns.transpose() * &columns,
            columns,
        };
        let seen = DVector::from_vec(vec![-4.0, 3.0, 12.0]);
        let beyond = |others: &[(usize, bool)]| directions.beyond(&seen, others.iter().copied());
        assert!((beyond(&[]) - 13.0).abs() < 1e-12);
        assert!((beyond(&[(0, false)]) - 153_f64.sqrt()).abs() < 1e-12);
        assert!(
            (beyond(&[(0, true)]) - 13.0).abs() < 1e-12,
            "the other way: not it"
        );
        assert!((beyond(&[(0, false), (1, true)]) - 153_f64.sqrt()).abs() < 1e-12);
        assert!((beyond(&[(0, false), (1, true), (2, true)]) - 5.0).abs() < 1e-12);
    }
}
