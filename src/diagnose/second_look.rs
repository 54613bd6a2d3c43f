//! A second look at effects whose derivative at zero says little of them: seen from a step of a plausible size.
//!
//! Screening ranks effects by their derivatives; one that saturates, or grows faster than its strength, may rank too low to
//! be fitted, or its fit ends in a wrong valley. Where no effect that was fitted explains the data, all are tried with a step.

use nalgebra::DMatrix;

use crate::progress::Progress;
use crate::study::{Fit, Footing, Linear};

use super::baseline::Baseline;
use super::error::{DiagnoseError, where_solved};
use super::evidence::of_one;
use super::judge::Judgement;
use super::prior::StrengthPrior;
use super::refit::Refits;
use super::screening::{Directions, effect_of, whole_strength};

/// Steps, as shares of the plausible size.
pub const HALF: [f64; 2] = [0.5, -0.5];
/// The same with whole ones: an effect may be there or not, and nothing between.
pub const HALF_AND_WHOLE: [f64; 4] = [0.5, -0.5, 1.0, -1.0];
/// An effect that was fitted explains the data if its misfit is within this many standard deviations of the expected one.
const CONTENT: f64 = 4.0;
/// Effects that are fitted after it.
const REFITS: usize = 4;

/// Fits those that deserve it by `steps` (shares of a plausible size), if none that was fitted explains the data.
///
/// # Errors
/// If the user asked to stop.
pub fn second_look(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    steps: &[f64],
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let numbers = baseline.likelihood.numbers as f64;
    let best = judgement
        .refits
        .iter()
        .map(|(_, found)| found.q)
        .fold(f64::INFINITY, f64::min);
    // by the stated scatter: an effect that is missed raises the scatter that the data seem to have
    if best * baseline.scatter.scale.max(1.0).powi(2) < numbers + CONTENT * (2.0 * numbers).sqrt() {
        return Ok(());
    }
    let (forward, data) = (baseline.forward, &baseline.data);
    let unknowns = forward.unknowns();
    let tried: Vec<usize> = (0..judgement.singles.len())
        .filter(|&index| match judgement.singles[index].members[..] {
            // what is all or none was fitted whole
            [only] => whole_strength(&unknowns[data.missing[only]]).is_none(),
            _ => false,
        })
        .collect();
    let members: Vec<usize> = tried
        .iter()
        .map(|&index| judgement.singles[index].members[0])
        .collect();
    let mut ranked: Vec<(f64, usize, f64)> = Vec::new();
    for &step in steps {
        // an effect may answer otherwise to a step than its derivative says, in either direction
        let (slopes, unsolved) = stepped(baseline, &baseline.fit, &members, step, progress)?;
        let passed = tried.iter().zip(&members).filter(|(_, k)| unsolved.contains(k));
        judgement.passed_over.extend(passed.map(|(&index, _)| index));
        let directions = Directions::new(data, &slopes, &baseline.whitened);
        for &index in &tried {
            let trial = &judgement.singles[index];
            let k = trial.members[0];
            let dot = directions.scores[k] * directions.lengths[k];
            let q0 = baseline.whitened.q();
            let prior = StrengthPrior::of(&unknowns[data.missing[k]]).map(|prior| prior.toward(step));
            let found = of_one(baseline.likelihood, q0, directions.gram[(k, k)], dot, prior);
            ranked.push((
                trial.ln_prior + found.ln_gain,
                index,
                step.signum() * found.estimate[0],
            ));
        }
    }
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(b.2.total_cmp(&a.2)));
    for &(ln_weight, index, estimate) in ranked.iter().take(REFITS) {
        progress.check()?;
        if ln_weight <= judgement.singles[index].ln_prior {
            break;
        }
        let members = judgement.singles[index].members.clone();
        let name = &unknowns[data.missing[members[0]]].name;
        progress.say(format_args!("refit after a second look: {name}"));
        let found = match refits.refit_from(&members, &[refits.stepped(members[0], estimate)])? {
            None if !judgement.is_refitted(index) => refits.refit(&members, &[estimate])?,
            found => found,
        };
        judgement.take(index, found);
    }
    Ok(())
}

/// How all observables answer to steps of the effects `members` about a fit, by a `share` of their plausible size, per prior standard
/// deviation of the step's length (observables × missing effects; zero for all others, for steps down of what has one sign, and where the
/// model has no solution), and those among them for which it has none.
fn stepped(
    baseline: &Baseline,
    fit: &Fit,
    members: &[usize],
    share: f64,
    progress: &Progress,
) -> Result<(DMatrix<f64>, Vec<usize>), DiagnoseError> {
    let (forward, data) = (baseline.forward, &baseline.data);
    let unknowns = forward.unknowns();
    let mut slopes = DMatrix::zeros(fit.predicted.len(), data.missing.len());
    let mut unsolved = Vec::new();
    let footing = fit.footing.as_ref().map(Footing::for_trials);
    for &member in members {
        let unknown = data.missing[member];
        let Some((name, _, scale, one_sided)) = effect_of(&unknowns[unknown]) else {
            continue;
        };
        if one_sided && share < 0.0 {
            continue;
        }
        progress.check()?;
        progress.say(format_args!("a second look at {name}"));
        let [low, high] = unknowns[unknown].range;
        let step = (fit.at[unknown] + share * scale).clamp(low, high) - fit.at[unknown];
        if step == 0.0 {
            continue;
        }
        let mut at = fit.at.clone();
        at[unknown] += step;
        let there = where_solved(forward.linearize_from(footing.as_ref(), &at, &|_| false))?;
        let Some((Linear { value: moved, .. }, _)) = there else {
            unsolved.push(member);
            continue;
        };
        let per_sigma = unknowns[unknown].sigma / step.abs();
        slopes.set_column(member, &((moved - &fit.predicted) * per_sigma));
    }
    for row in data.kept_bounds(forward, &fit.predicted) {
        slopes.row_mut(row).fill(0.0);
    }
    Ok((slopes, unsolved))
}
