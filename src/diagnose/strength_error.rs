//! Standard errors of strengths by what is admitted of the model where the effect stands.
//!
//! A fit weighs readings by a covariance Σ that holds what a percent of chord, stiffness or air moves in the model without the effect. With a
//! large effect in it the wing answers otherwise: a film under tension, a broken rod. The estimate keeps its weights, W = H⁻¹ Sᵀ with
//! whitened slopes S and H = I + Sᵀ S, and its covariance gets what it lacks, W (A' A'ᵀ − A Aᵀ) Wᵀ, with the whitened responses A without the effect
//! and A' with it (the sandwich formula: Huber 1967, Proc. 5th Berkeley Symp. 1, 221). No error becomes smaller by it.

use nalgebra::{Cholesky, DMatrix};

use crate::progress::Progress;
use crate::study::Unknown;

use super::baseline::Baseline;
use super::error::{DiagnoseError, where_solved};
use super::judge::Judgement;
use super::posterior::Case;
use super::refit::Explanation;
use super::screening::place_of;

/// Hypotheses whose errors are looked at, the most probable first.
const LOOKED_AT: usize = 3;

/// Widens the standard errors of the hypotheses in the set, as far as they were fitted.
///
/// # Errors
/// If the user asked to stop.
pub fn widen(
    judgement: &mut Judgement,
    baseline: &Baseline,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    if baseline.data.admitted.is_empty() {
        return Ok(());
    }
    let in_set = judgement.beliefs.iter().filter(|belief| belief.in_set);
    let families: Vec<Vec<usize>> = in_set
        .filter_map(|belief| match belief.case {
            Case::One(family) => Some(vec![family]),
            Case::Two(first, second) => Some(vec![first, second]),
            Case::Nothing | Case::Novel => None,
        })
        .take(LOOKED_AT)
        .collect();
    for families in families {
        progress.check()?;
        let Some((index, Some(_))) = judgement.best_of(&families) else {
            continue;
        };
        let explanations = judgement.refits.iter_mut();
        for (_, explanation) in explanations.filter(|(own, _)| *own == index) {
            match lacking(baseline, explanation)? {
                Some(lacking) => add(baseline, explanation, &lacking),
                None => judgement.narrow.push(index),
            }
        }
    }
    Ok(())
}

/// Unknowns that were free, and what their variances lack, in squared prior standard deviations; none where the model has no derivatives.
///
/// # Errors
/// If the user asked to stop.
fn lacking(
    baseline: &Baseline,
    explanation: &Explanation,
) -> Result<Option<Vec<(usize, f64)>>, DiagnoseError> {
    let Some(fit) = &explanation.fit else {
        return Ok(None);
    };
    let (data, forward) = (&baseline.data, baseline.forward);
    let unknowns = forward.unknowns();
    let names: Vec<&str> = data.admitted.iter().map(|&i| unknowns[i].name.as_str()).collect();
    let wanted = |unknown: &Unknown| names.contains(&unknown.name.as_str());
    let there = forward.linearize_from(fit.footing.as_ref(), &fit.at, &wanted);
    let Some((linear, _)) = where_solved(there)? else {
        return Ok(None);
    };
    let mut with = linear.jacobian.select_columns(data.admitted.iter());
    for (mut column, &i) in with.column_iter_mut().zip(&data.admitted) {
        column *= unknowns[i].sigma * baseline.settings.slop;
    }
    for row in data.kept_bounds(forward, &linear.value) {
        with.row_mut(row).fill(0.0);
    }
    let noise = &baseline.scatter.noise;
    let whitened = |responses: &DMatrix<f64>| noise.whiten_columns(&responses.select_rows(&data.rows));
    let moves = |place: &usize| !fit.at_end.contains(&fit.free[*place]);
    let columns: Vec<usize> = (0..fit.free.len()).filter(moves).collect();
    let slopes = fit.slopes.select_columns(&columns);
    let size = columns.len();
    let curvature = DMatrix::identity(size, size) + slopes.transpose() * &slopes;
    let Some(curvature) = Cholesky::new(curvature) else {
        return Ok(None);
    };
    let weights = curvature.solve(&slopes.transpose());
    let [with, without] =
        [&with, &baseline.admitted.responses].map(|responses| &weights * whitened(responses));
    let lacking = columns.iter().enumerate().map(|(row, &column)| {
        let lacks = with.row(row).norm_squared() - without.row(row).norm_squared();
        (fit.free[column], lacks.max(0.0))
    });
    Ok(lacking
        .map(|(i, lacks)| lacks.is_finite().then_some((i, lacks)))
        .collect())
}

fn add(baseline: &Baseline, explanation: &mut Explanation, lacking: &[(usize, f64)]) {
    let unknowns = baseline.forward.unknowns();
    let widened = |i: usize, error: f64| {
        let lacks = lacking
            .iter()
            .find(|(own, _)| *own == i)
            .map_or(0.0, |(_, lacks)| *lacks);
        error.hypot(unknowns[i].sigma * lacks.sqrt())
    };
    for (position, &k) in explanation.members.iter().enumerate() {
        let strength = baseline.data.missing[k];
        let error = &mut explanation.standard_error[position];
        *error = widened(strength, *error);
        if let (Some(place), Some([_, error])) =
            (place_of(unknowns, strength), &mut explanation.places[position])
        {
            *error = widened(place, *error);
        }
    }
}
