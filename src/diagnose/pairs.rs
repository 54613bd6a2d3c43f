//! Two effects at once: ranked with the best single effect in the model, where their derivatives say more than about the wing without
//! any; those without it by the linear model about that wing.

use crate::progress::Progress;
use crate::study::Footing;

use super::baseline::Baseline;
use super::error::DiagnoseError;
use super::evidence::{LinearEvidence, of_one};
use super::judge::Judgement;
use super::library::{Trial, heaviest};
use super::prior::{NOTHING, StrengthPrior};
use super::refit::{Explanation, Refits};
use super::screening::{Directions, slopes_of_missing};
use super::whitened::Whitened;

/// Pairs are fitted anew only if the linear model puts one this close to the best explanation.
const PAIR_CHANCE: f64 = 8.0;

/// Pairs with where their fit is to start: members, and strengths in prior standard deviations.
type Starts = Vec<Option<(Vec<usize>, Vec<f64>)>>;

/// Scores of all others with the best single effect in the model; then fits the best pairs anew.
///
/// # Errors
/// If a derivative is not finite, or the user asked to stop.
pub fn refit_pairs(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let Some((best, explanation)) = judgement.best_refit().cloned() else {
        return Ok(());
    };
    let (Some(fit), Some(local)) = (&explanation.fit, &explanation.local) else {
        return Ok(());
    };
    progress.say("derivatives with every effect, the best one in the model");
    let (data, settings) = (&baseline.data, baseline.settings);
    let slopes = slopes_of_missing(baseline.forward, data, &fit.at, settings, fit.footing.as_ref())?.missing;
    let whitened = Whitened::new(local, &baseline.scatter.noise)?;
    let mut directions = Directions::new(data, &slopes, &whitened);
    let family = judgement.singles[best].families[0];
    for &k in &judgement.families[family].members {
        directions.columns.column_mut(k).fill(0.0);
    }
    judgement.after_best = Some(baseline.significance(&whitened, &directions));
    let first = judgement.singles.len();
    let mut starts: Starts = vec![None; judgement.pairs.len()];
    for (pair, start) in starts.iter_mut().enumerate() {
        if let Some(second) = second_of(judgement, pair, &explanation, family) {
            let gain = gain_of(baseline, &directions, whitened.q(), second);
            judgement.ln_evidence[first + pair] = explanation.ln_evidence + gain.ln_gain;
            *start = Some(joined(baseline, &explanation, second, gain.estimate[0]));
            let trial = &mut judgement.pairs[pair];
            let place = usize::from(trial.members[1] == second);
            (trial.linear.estimate[place], trial.linear.error[place]) = (gain.estimate[0], gain.error[0]);
        }
    }
    let count = settings.pair_refits;
    refit_heaviest(
        judgement,
        refits,
        &starts,
        count,
        judgement.weight(best),
        progress,
    )?;
    alone(judgement, refits, progress)
}

/// Fits each effect of a pair whose other one came out as good as nothing again, alone, from where the pair ended and from the shapes of
/// the wing there: its own fit may have ended in a wrong valley.
fn alone(judgement: &mut Judgement, refits: &Refits, progress: &Progress) -> Result<(), DiagnoseError> {
    let first = judgement.singles.len();
    let mut starts: Vec<(usize, usize, Vec<f64>, Option<Footing>)> = Vec::new();
    for (index, pair) in judgement.refits.iter().filter(|(index, _)| *index >= first) {
        let (Some(fit), &[a, b]) = (&pair.fit, pair.members.as_slice()) else {
            continue;
        };
        for (small, (kept, dropped)) in [(1, (a, b)), (0, (b, a))] {
            if pair.strength[small].abs() > NOTHING * pair.standard_error[small] {
                continue;
            }
            let Some(single) = judgement.singles.iter().position(|trial| trial.members == [kept]) else {
                continue;
            };
            let mut at = fit.at.clone();
            at[refits.data.missing[dropped]] = 0.0;
            starts.push((single, *index, at, fit.footing.as_ref().map(Footing::for_trials)));
        }
    }
    for (single, pair, start, footing) in starts {
        progress.check()?;
        // nothing that the pair could not tell better is worth a fit
        if judgement.is_refitted(single) && judgement.ln_evidence[single] > judgement.ln_evidence[pair] {
            continue;
        }
        let members = judgement.singles[single].members.clone();
        let there = Refits {
            footing: footing.as_ref(),
            ..*refits
        };
        let found = there.refit_from(&members, &[start])?;
        judgement.take(single, found);
    }
    Ok(())
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
    let prior = StrengthPrior::of(&baseline.forward.unknowns()[baseline.data.missing[k]]);
    of_one(baseline.likelihood, q, directions.gram[(k, k)], dot, prior)
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
        let trial = &judgement.pairs[pair];
        let name = |family: &usize| judgement.families[*family].name.as_str();
        let names: Vec<&str> = trial.families.iter().map(name).collect();
        progress.say(format_args!("refit of {}", names.join(" with ")));
        let (members, estimates) = starts[pair]
            .clone()
            .unwrap_or_else(|| (trial.members.clone(), trial.linear.estimate.to_vec()));
        let found = refits.refit(&members, &estimates)?;
        judgement.take(first + pair, found);
    }
    Ok(())
}
