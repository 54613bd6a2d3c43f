//! The next experiment: which of the candidates tells the rivals apart best.
//!
//! Buzzi-Ferraris & Forzatti, Chem. Eng. Sci. 38 (1983) 225: T = Σ πᵢπⱼ (ŷᵢ − ŷⱼ)ᵀ (Vᵢ + Vⱼ)⁻¹ (ŷᵢ − ŷⱼ), V = J C Jᵀ + Σ, here
//! divided by Σ πᵢπⱼ, so that √T is a distance in standard deviations.

use nalgebra::{Cholesky, DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::progress::Progress;
use crate::study::{Fit, Forward, Unknown, UnknownKind};

use super::error::DiagnoseError;

/// Distance from which on an experiment tells rivals apart.
const SEPARATE: f64 = 3.0;

/// What to measure next.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NextExperiment {
    /// Best candidate; none if no candidate tells the rivals apart.
    pub best: Option<String>,
    /// All candidates, best first.
    pub candidates: Vec<Candidate>,
    /// The advice in one sentence.
    pub sentence: String,
}

/// One candidate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Candidate {
    /// Name of its condition.
    pub name: String,
    /// Distance expected between the rivals, in standard deviations.
    pub separation_sigma: f64,
}

/// A rival explanation with its probability.
pub struct Rival<'a> {
    /// Its probability.
    pub probability: f64,
    /// Its fit.
    pub fit: &'a Fit,
    /// Factor on the fit's covariance for the scale of the noise.
    pub variance: f64,
}

/// Scores every condition of `candidates`: a model with unknowns of the same names, whose observables state the noise
/// that is to be expected.
///
/// # Errors
/// If a candidate has no solution, or the user asked to stop.
pub fn next_experiment(
    forward: &dyn Forward,
    candidates: &dyn Forward,
    rivals: &[Rival],
    progress: &Progress,
) -> Result<NextExperiment, DiagnoseError> {
    let mut answers: Vec<(DVector<f64>, DMatrix<f64>)> = Vec::new();
    for rival in rivals {
        progress.check()?;
        progress.say("what the rivals predict for candidate experiments");
        answers.push(answer(forward, candidates, rival)?);
    }
    let observables = candidates.observables();
    let score = |condition: usize| {
        let rows: Vec<usize> = (0..observables.len())
            .filter(|&row| observables[row].condition == condition)
            .collect();
        let noise = DMatrix::from_diagonal(&DVector::from_iterator(
            rows.len(),
            rows.iter().map(|&row| 2.0 * observables[row].sigma.powi(2)),
        ));
        let (mut sum, mut weights) = (0.0, 0.0);
        for i in 0..rivals.len() {
            for j in 0..i {
                let weight = rivals[i].probability * rivals[j].probability;
                let apart = (&answers[i].0 - &answers[j].0).select_rows(rows.iter());
                let spread = |k: usize| answers[k].1.select_rows(rows.iter()).select_columns(rows.iter());
                let Some(factor) = Cholesky::new(spread(i) + spread(j) + &noise) else {
                    continue;
                };
                sum += weight * apart.dot(&factor.solve(&apart));
                weights += weight;
            }
        }
        if weights > 0.0 {
            (sum / weights).sqrt()
        } else {
            0.0
        }
    };
    let mut found: Vec<Candidate> = candidates
        .conditions()
        .iter()
        .enumerate()
        .map(|(index, condition)| Candidate {
            name: condition.name.clone(),
            separation_sigma: score(index),
        })
        .collect();
    found.sort_by(|a, b| {
        b.separation_sigma
            .total_cmp(&a.separation_sigma)
            .then_with(|| a.name.cmp(&b.name))
    });
    let best = found
        .first()
        .filter(|candidate| candidate.separation_sigma >= SEPARATE);
    let sentence = match (best, found.first()) {
        (Some(best), _) => format!(
            "Measure {} next: the rivals are expected {:.1} standard deviations apart there.",
            best.name, best.separation_sigma
        ),
        (None, Some(first)) => format!(
            "No listed experiment can tell these apart; the best, {}, puts them {:.1} standard deviations apart.",
            first.name, first.separation_sigma
        ),
        (None, None) => "No candidate experiment was listed.".into(),
    };
    Ok(NextExperiment {
        best: best.map(|candidate| candidate.name.clone()),
        candidates: found,
        sentence,
    })
}

/// Prediction of a rival for the candidates, and its covariance by what the fit leaves open.
fn answer(
    forward: &dyn Forward,
    candidates: &dyn Forward,
    rival: &Rival,
) -> Result<(DVector<f64>, DMatrix<f64>), DiagnoseError> {
    let known = forward.unknowns();
    // among experiments on one wing alone nothing is told by its wing
    let wings = candidates
        .conditions()
        .iter()
        .map(|condition| condition.wing.as_str());
    let mut wings: Vec<&str> = wings.collect();
    wings.dedup();
    let only = match wings.as_slice() {
        [wing] => format!(" on {wing}"),
        _ => String::new(),
    };
    let is_same = |own: &Unknown, name: &str| {
        own.name == name || (!only.is_empty() && own.name.strip_suffix(&only) == Some(name))
    };
    let is_free = |name: &str| rival.fit.free.iter().any(|&i| is_same(&known[i], name));
    let of_known = |name: &str| {
        let free = rival.fit.free.iter().copied().find(|&i| is_same(&known[i], name));
        free.or_else(|| known.iter().position(|own| own.name == name))
    };
    let at: Vec<f64> = candidates
        .unknowns()
        .iter()
        .map(|unknown| of_known(&unknown.name).map_or(unknown.mean, |i| rival.fit.at[i]))
        .collect();
    // a nuisance that only the candidate has is as open as its prior leaves it
    let is_new = |unknown: &Unknown| {
        unknown.kind == UnknownKind::Ruler && !known.iter().any(|k| k.name == unknown.name)
    };
    let linear = candidates.linearize(&at, &|unknown| is_free(&unknown.name) || is_new(unknown))?;
    let place = |i: usize| {
        candidates
            .unknowns()
            .iter()
            .position(|unknown| is_same(&known[i], &unknown.name))
    };
    let slopes = DMatrix::from_fn(linear.value.len(), rival.fit.free.len(), |row, k| {
        place(rival.fit.free[k]).map_or(0.0, |column| linear.jacobian[(row, column)])
    });
    let mut covariance = &slopes * &rival.fit.covariance * slopes.transpose() * rival.variance;
    for (column, unknown) in candidates
        .unknowns()
        .iter()
        .enumerate()
        .filter(|(_, u)| is_new(u))
    {
        let slope = linear.jacobian.column(column) * unknown.sigma;
        covariance += &slope * slope.transpose();
    }
    Ok((linear.value, covariance))
}
