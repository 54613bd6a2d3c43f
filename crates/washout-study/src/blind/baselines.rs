//! What simpler methods would have named, from the same derivatives and fits.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::diagnose::baseline::Baseline;
use crate::diagnose::judge::Judgement;
use crate::diagnose::screening::effect_of;

/// Families that simpler methods name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Simpler {
    /// The single effect that fits best, whatever its strength: always one.
    pub best_fitting: Vec<String>,
    /// The largest score (Lagrange multiplier), if it passes at the level of the diagnosis for one test.
    pub largest_score: Vec<String>,
    /// Forward selection in the linear model as long as AICc falls.
    pub forward_selection: Vec<String>,
}

/// Their answers.
pub fn answers(baseline: &Baseline, judgement: &Judgement) -> Simpler {
    let unknowns = baseline.forward.unknowns();
    let family = |k: usize| {
        effect_of(&unknowns[baseline.data.missing[k]])
            .map_or(String::new(), |(_, family, _, _)| family.to_string())
    };
    let best = judgement
        .refits
        .iter()
        .filter(|(_, found)| found.members.len() == 1)
        .min_by(|a, b| a.1.q.total_cmp(&b.1.q));
    let scores = &baseline.directions.scores;
    let largest = (0..scores.len()).max_by(|&a, &b| scores[a].abs().total_cmp(&scores[b].abs()));
    Simpler {
        best_fitting: best
            .map(|(_, found)| family(found.members[0]))
            .into_iter()
            .collect(),
        // 2.58: two-sided one percent of one normal number
        largest_score: largest
            .filter(|&k| scores[k].abs() > 2.58)
            .map(family)
            .into_iter()
            .collect(),
        forward_selection: forward_selection(baseline).into_iter().map(family).collect(),
    }
}

/// Positions of the effects that forward selection takes, at most three.
fn forward_selection(baseline: &Baseline) -> Vec<usize> {
    let columns = &baseline.directions.columns;
    let mut residual = baseline.whitened.residual.clone();
    let mut basis: Vec<nalgebra::DVector<f64>> = Vec::new();
    let mut taken = Vec::new();
    let numbers = baseline.data.rows.len() as f64;
    let fitted = baseline.data.model.len() as f64;
    // of a fit with a known scale of the noise
    let aicc = |q: f64, count: f64| {
        let k = fitted + count;
        q + 2.0 * k + 2.0 * k * (k + 1.0) / (numbers - k - 1.0).max(1.0)
    };
    while taken.len() < 3 {
        let here = aicc(residual.norm_squared(), taken.len() as f64);
        let best = (0..columns.ncols())
            .filter(|k| !taken.contains(k))
            .filter_map(|k| {
                let mut column = columns.column(k).into_owned();
                for known in &basis {
                    column -= known * known.dot(&column);
                }
                let length = column.norm();
                (length > 1e-6).then(|| (column.dot(&residual) / length, k, column / length))
            })
            .max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let Some((score, k, unit)) = best else { break };
        let next = aicc(residual.norm_squared() - score * score, taken.len() as f64 + 1.0);
        if next >= here {
            break;
        }
        residual -= &unit * score;
        basis.push(unit);
        taken.push(k);
    }
    taken
}
