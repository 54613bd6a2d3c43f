//! Two effects at once.
//!
//! Pairs are ranked by the linear model about the wing without any effect, which says little where effects are strong; so they
//! are ranked again where more is known: with the best single effect in the model, then about the best pair, then by steps of a
//! plausible size. Each ranking is made only while what the best explanation leaves is beyond chance.

use nalgebra::DMatrix;

use crate::progress::Progress;
use crate::study::UnknownKind;

use super::baseline::Baseline;
use super::error::DiagnoseError;
use super::evidence::{LinearEvidence, of_one};
use super::judge::Judgement;
use super::library::{Scales, Trial, heaviest};
use super::refit::{Explanation, Refits};
use super::screening::{Directions, is_one_sided, place_of, slopes_of_missing};
use super::second_look::steps;
use super::whitened::{Local, Whitened};

/// Pairs are fitted anew only if the linear model puts one this close to the best explanation.
const PAIR_CHANCE: f64 = 8.0;
/// What the best explanation leaves is beyond chance below this probability.
const CONTENT: f64 = 0.05;
/// Beyond this misfit of the best explanation, sigma, no pair of known effects is near, and none is sought further.
const GROSS: f64 = 15.0;
/// Pairs that are fitted anew after a further ranking.
const REFITS: usize = 3;

/// Pairs with where their fit is to start: members, and strengths in prior standard deviations.
type Starts = Vec<Option<(Vec<usize>, Vec<f64>)>>;

/// Ranks pairs and fits the best of them anew.
///
/// # Errors
/// If a derivative is not finite, or the user asked to stop.
pub fn refit_pairs(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let Some(single) = judgement.best_refit().cloned() else {
        return Ok(());
    };
    beside(judgement, baseline, refits, &single, progress)?;
    if judgement.after_best.is_none() || is_content(judgement, baseline)? {
        return Ok(());
    }
    about_the_best_pair(judgement, baseline, refits, progress)?;
    if !is_content(judgement, baseline)? {
        beside_by_steps(judgement, baseline, refits, &single, progress)?;
    }
    Ok(())
}

/// Whether the search may end: chance may leave what the best explanation leaves, or that is nowhere near the data.
fn is_content(judgement: &Judgement, baseline: &Baseline) -> Result<bool, DiagnoseError> {
    let Some((
        _,
        Explanation {
            local: Some(local),
            q,
            ..
        },
    )) = judgement.best_refit()
    else {
        return Ok(true);
    };
    if q - baseline.likelihood.numbers as f64 > GROSS * GROSS {
        return Ok(true);
    }
    let whitened = Whitened::new(local, &baseline.scatter.noise)?;
    let left = baseline.significance(&whitened, &Directions::none(&whitened));
    Ok(2.0 * left.p_misfit.min(left.p_field) > CONTENT)
}

/// Scores of all others with the best single effect in the model; then the best pairs anew.
fn beside(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    (best, explanation): &(usize, Explanation),
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let (Some(fit), Some(local)) = (&explanation.fit, &explanation.local) else {
        return Ok(());
    };
    progress.say("derivatives with every effect, the best one in the model");
    let (data, settings) = (&baseline.data, baseline.settings);
    let slopes = slopes_of_missing(baseline.forward, data, &fit.at, settings, fit.footing.as_ref())?.missing;
    let whitened = Whitened::new(local, &baseline.scatter.noise)?;
    let mut directions = Directions::new(data, &slopes, &whitened);
    let family = judgement.singles[*best].families[0];
    for &k in &judgement.families[family].members {
        directions.columns.column_mut(k).fill(0.0);
    }
    judgement.after_best = Some(baseline.significance(&whitened, &directions));
    let first = judgement.singles.len();
    let mut starts: Starts = vec![None; judgement.pairs.len()];
    for (pair, start) in starts.iter_mut().enumerate() {
        if let Some(second) = second_of(judgement, pair, explanation, family) {
            let gain = gain_of(baseline, &directions, whitened.q(), second);
            judgement.ln_evidence[first + pair] = explanation.ln_evidence + gain.ln_gain;
            *start = Some(joined(baseline, explanation, second, gain.estimate[0]));
        }
    }
    let count = settings.pair_refits;
    refit_heaviest(
        judgement,
        refits,
        &starts,
        count,
        judgement.weight(*best),
        progress,
    )
}

/// The second effect of a pair, if its first is `explanation`, of `family`.
fn second_of(judgement: &Judgement, pair: usize, explanation: &Explanation, family: usize) -> Option<usize> {
    let trial = &judgement.pairs[pair];
    let own = &judgement.families[family].members;
    let holds = trial.members.iter().any(|k| explanation.members.contains(k));
    let second = trial.members.iter().copied().find(|k| !own.contains(k));
    second.filter(|_| holds && trial.families.contains(&family))
}

fn gain_of(baseline: &Baseline, directions: &Directions, q: f64, k: usize) -> LinearEvidence {
    let dot = directions.scores[k] * directions.lengths[k];
    let one_sided = is_one_sided(&baseline.forward.unknowns()[baseline.data.missing[k]]);
    of_one(baseline.likelihood, q, directions.gram[(k, k)], dot, one_sided)
}

/// Members and estimates of a pair of an explanation and a second effect.
fn joined(
    baseline: &Baseline,
    explanation: &Explanation,
    second: usize,
    estimate: f64,
) -> (Vec<usize>, Vec<f64>) {
    let unknowns = baseline.forward.unknowns();
    let sigma = |k: usize| unknowns[baseline.data.missing[k]].sigma;
    let own = explanation.members.iter().zip(&explanation.strength);
    let estimates = own.map(|(&k, s)| s / sigma(k)).chain([estimate]).collect();
    let members = explanation.members.iter().copied().chain([second]).collect();
    (members, estimates)
}

/// Fits the `count` heaviest pairs that were not fitted yet, as long as they come near to `weight`.
fn refit_heaviest(
    judgement: &mut Judgement,
    refits: &Refits,
    starts: &Starts,
    count: usize,
    weight: f64,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let first = judgement.singles.len();
    let scored: Vec<Trial> = judgement
        .pairs
        .iter()
        .enumerate()
        .map(|(pair, trial)| {
            let mut scored = trial.clone();
            scored.linear.ln_gain = match judgement.is_refitted(first + pair) {
                true => f64::NEG_INFINITY,
                false => judgement.ln_evidence[first + pair],
            };
            scored
        })
        .collect();
    for pair in heaviest(&scored, count, 1) {
        progress.check()?;
        if scored[pair].ln_weight() < weight - PAIR_CHANCE {
            break;
        }
        progress.say("refit of a pair");
        let trial = &judgement.pairs[pair];
        let (members, estimates) = starts[pair]
            .clone()
            .unwrap_or_else(|| (trial.members.clone(), trial.linear.estimate.to_vec()));
        if let Some(explanation) = refits.refit(&members, &estimates)? {
            judgement.ln_evidence[first + pair] = explanation.ln_evidence;
            judgement.refits.push((first + pair, explanation));
        }
    }
    Ok(())
}

/// Ranks all pairs by the linear model about the best of those that were fitted, and fits the best of the others.
fn about_the_best_pair(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let first = judgement.singles.len();
    let pairs = judgement.refits.iter().filter(|(index, _)| *index >= first);
    let best = pairs.max_by(|a, b| judgement.weight(a.0).total_cmp(&judgement.weight(b.0)));
    let Some((best, explanation)) = best.cloned() else {
        return Ok(());
    };
    let (Some(fit), Some(local)) = (&explanation.fit, &explanation.local) else {
        return Ok(());
    };
    progress.say("derivatives with every effect, the best two in the model");
    let (forward, data, settings) = (baseline.forward, &baseline.data, baseline.settings);
    let slopes = slopes_of_missing(forward, data, &fit.at, settings, fit.footing.as_ref())?.missing;
    // what is left where all effects are taken out again, by their derivatives here
    let without = Local {
        at_means: local.at_means.clone(),
        slopes: local.slopes.columns(0, data.model.len()).into_owned(),
        rows: local.rows.clone(),
    };
    let whitened = Whitened::new(&without, &baseline.scatter.noise)?;
    let directions = Directions::new(data, &slopes, &whitened);
    let scales = Scales {
        forward,
        data,
        directions: &directions,
        likelihood: baseline.likelihood,
        q0: whitened.q(),
    };
    let again = scales.pairs(&judgement.families, settings.prior.two);
    let level = explanation.ln_evidence - again[best - first].linear.ln_gain;
    let mut starts: Starts = vec![None; again.len()];
    for (pair, trial) in again.iter().enumerate() {
        if !judgement.is_refitted(first + pair) {
            judgement.ln_evidence[first + pair] = level + trial.linear.ln_gain;
            starts[pair] = Some((trial.members.clone(), trial.linear.estimate.to_vec()));
        }
    }
    refit_heaviest(
        judgement,
        refits,
        &starts,
        REFITS,
        judgement.weight(best),
        progress,
    )
}

/// Whether an effect sits at a place on one wing alone.
fn is_of_one_wing(baseline: &Baseline, k: usize) -> bool {
    let unknowns = baseline.forward.unknowns();
    place_of(unknowns, baseline.data.missing[k])
        .is_some_and(|place| matches!(&unknowns[place].kind, UnknownKind::Place { wing: Some(_), .. }))
}

/// Tries every other effect with a step beside the best single one, and fits the best pairs that this shows.
fn beside_by_steps(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    (best, explanation): &(usize, Explanation),
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let (Some(fit), Some(local)) = (&explanation.fit, &explanation.local) else {
        return Ok(());
    };
    let first = judgement.singles.len();
    let family = judgement.singles[*best].families[0];
    let wanted: Vec<(usize, usize)> = (0..judgement.pairs.len())
        .filter(|&pair| !judgement.is_refitted(first + pair))
        .filter_map(|pair| Some((pair, second_of(judgement, pair, explanation, family)?)))
        .filter(|&(_, second)| !is_of_one_wing(baseline, second))
        .collect();
    let members: Vec<usize> = wanted.iter().map(|&(_, second)| second).collect();
    let slopes: DMatrix<f64> = steps(baseline, fit, &members, progress)?;
    let whitened = Whitened::new(local, &baseline.scatter.noise)?;
    let directions = Directions::new(&baseline.data, &slopes, &whitened);
    let mut starts: Starts = vec![None; judgement.pairs.len()];
    for (pair, second) in wanted {
        let gain = gain_of(baseline, &directions, whitened.q(), second);
        if directions.lengths[second] > 0.0 {
            judgement.ln_evidence[first + pair] = explanation.ln_evidence + gain.ln_gain;
            starts[pair] = Some(joined(baseline, explanation, second, gain.estimate[0]));
        }
    }
    let weight = judgement
        .best_refit()
        .map_or(f64::NEG_INFINITY, |best| judgement.weight(best.0));
    refit_heaviest(judgement, refits, &starts, REFITS, weight, progress)
}
