//! From evidence to an answer: probabilities, whether a pair stands for itself, whether anything known is adequate.

use super::baseline::Baseline;
use super::error::DiagnoseError;
use super::evidence::ln_sum;
use super::hump::Hump;
use super::judge::Judgement;
use super::library::Trial;
use super::posterior::{Case, TWINS, Weight, beliefs, class_around, fold, level_class, refuted};
use super::prior::StrengthPrior;
use super::rows::{is_nameable, strength_of, unknown};
use super::screening::Directions;
use super::whitened::Whitened;

/// Misfit of the best known explanation less probable than this: it is no explanation.
const INADEQUATE: f64 = 1e-3;
/// Odds from which on an unnamed field is preferred to an adequate known explanation.
const NOVEL_ODDS: f64 = 3.0;
/// ln of the factor by which a second effect must raise the evidence to stand beside the first as a pair of its own.
const SECOND: f64 = 1.1;

/// Distance of the model with an effect of one standard deviation of its prior (1.5 times its plausible size) from that without, in
/// standard deviations, from which on a second one of its kind would show: chi-square moves by 25.
const PLAIN: f64 = 5.0;

/// ln of the odds from which on a pair that was fitted anew stands beside any single effect, whatever that leaves: what a test of the
/// misfit lets pass as chance, because it asks for nothing in particular, may be the signature of a second effect.
const CLEAR: f64 = 3.0;

/// Families this much less probable than the first (ln) are not levelled with it, but for twins.
const NEAR: f64 = 7.0;

/// Gives every hypothesis its probability.
pub fn conclude(judgement: &mut Judgement, baseline: &Baseline) {
    let prior = baseline.settings.prior;
    let weight_of = |families: &[usize]| {
        let trials = judgement.singles.iter().chain(&judgement.pairs).enumerate();
        let own: Vec<f64> = trials
            .filter(|(_, trial)| trial.families == families)
            .map(|(index, trial)| trial.ln_prior + judgement.ln_evidence[index])
            .collect();
        ln_sum(own.iter().copied())
    };
    let ln_likelihood = |families: &[usize]| match judgement.best_of(families) {
        Some((_, Some(explanation))) => baseline.likelihood.ln(explanation.q),
        Some((index, None)) => baseline.likelihood.ln(judgement.trial(index).linear.q),
        None => f64::NEG_INFINITY,
    };
    let count = judgement.families.len();
    let mut weights: Vec<Weight> = (0..count)
        .map(|family| Weight {
            case: Case::One(family),
            ln_weight: weight_of(&[family]),
            ln_likelihood: ln_likelihood(&[family]),
            seconds: Vec::new(),
        })
        .collect();
    let heaviest_family = (0..count).max_by(|&a, &b| weights[a].ln_weight.total_cmp(&weights[b].ln_weight));
    if let Some(first) = heaviest_family {
        let twins: Vec<usize> = (0..count)
            .filter(|&k| k != first && are_twins(judgement, baseline, first, k))
            .collect();
        let near: Vec<usize> = (0..count)
            .filter(|&k| weights[k].ln_weight > weights[first].ln_weight - NEAR || twins.contains(&k))
            .collect();
        let place = near.iter().position(|&k| k == first).unwrap_or(0);
        let class = class_around(place, near.len(), &|a, b| {
            judgement.distance(baseline, near[a], near[b])
        });
        let class: Vec<usize> = class.into_iter().map(|k| near[k]).collect();
        level_class(&mut weights, &class, &twins);
    }
    let mean = |trials: &[Trial], families: &[usize]| {
        let prior = trials
            .iter()
            .filter(|trial| trial.families == families)
            .map(|trial| trial.ln_prior);
        weight_of(families) - ln_sum(prior.collect::<Vec<f64>>().into_iter())
    };
    let alone: Vec<f64> = (0..count)
        .map(|family| mean(&judgement.singles, &[family]))
        .collect();
    let heaviest_pair = judgement
        .refits
        .iter()
        .map(|(index, _)| &judgement.trial(*index).families)
        .filter(|families| families.len() == 2)
        .map(|families| weight_of(families))
        .fold(f64::NEG_INFINITY, f64::max);
    let heaviest_single = heaviest_family.map_or(f64::NEG_INFINITY, |first| weight_of(&[first]));
    let needs_second = judgement.needs_second(baseline) || heaviest_pair > heaviest_single + CLEAR;
    // a second effect that these data could not be trusted to show is no hypothesis of its own
    let would_show = |family: usize| {
        let members = judgement.families[family].members.iter();
        members
            .map(|&k| baseline.directions.lengths[k])
            .any(|seen| seen >= PLAIN)
    };
    for a in 0..count {
        for b in a + 1..count {
            let (shown, other) = if alone[a] >= alone[b] { (a, b) } else { (b, a) };
            let ln_weight = weight_of(&[a, b]);
            if needs_second && mean(&judgement.pairs, &[a, b]) - alone[shown] > SECOND {
                weights.push(Weight {
                    case: Case::Two(a, b),
                    ln_weight,
                    ln_likelihood: f64::NEG_INFINITY,
                    seconds: Vec::new(),
                });
            } else {
                fold(&mut weights, shown, ln_weight);
                if would_show(other) {
                    let told = ln_told(judgement, baseline, [a, b], other);
                    weights[shown].seconds.push((other, told));
                }
            }
        }
    }
    let linear = judgement.ln_nothing + judgement.weighed.ln_gain;
    for (case, prior, ln_evidence) in [
        (Case::Nothing, prior.nothing, judgement.ln_nothing),
        (
            Case::Novel,
            prior.novel,
            with_humps(linear, &judgement.humps.fitted),
        ),
    ] {
        weights.push(Weight {
            case,
            ln_weight: prior.ln() + ln_evidence,
            ln_likelihood: f64::NEG_INFINITY,
            seconds: Vec::new(),
        });
    }
    judgement.beliefs = beliefs(&weights, baseline.settings.tempering);
    let novel = judgement.beliefs.iter().find(|belief| belief.case == Case::Novel);
    judgement.novel_as_weighed = novel.map_or(0.0, |belief| belief.probability);
}

/// Whether a family explains the data as the `first` does, by strengths that may have a name, if both were fitted.
fn are_twins(judgement: &Judgement, baseline: &Baseline, first: usize, other: usize) -> bool {
    let [Some((_, Some(_))), Some((_, Some(found)))] = [first, other].map(|k| judgement.best_of(&[k])) else {
        return false;
    };
    let mut strengths = found.members.iter().zip(&found.strength);
    strengths.all(|(&k, &strength)| is_nameable(unknown(baseline, k), strength))
        && judgement.distance(baseline, first, other) < TWINS
}

/// ln of the weight of a pair with strengths of its `second` that these data tell from none: what they cannot tell is the first alone.
fn ln_told(judgement: &Judgement, baseline: &Baseline, pair: [usize; 2], second: usize) -> f64 {
    let first = judgement.singles.len();
    let own = judgement.pairs.iter().enumerate();
    let own = own
        .filter(|(_, trial)| trial.families == pair)
        .map(|(place, trial)| {
            let explanation = judgement.refits.iter().find(|(index, _)| *index == first + place);
            let explanation = explanation.map(|(_, explanation)| explanation);
            let members = explanation.map_or(&trial.members, |explanation| &explanation.members);
            let seconds = &judgement.families[second].members;
            let told = (members.iter().enumerate())
                .filter(|(_, k)| seconds.contains(k))
                .map(|(position, &k)| {
                    let unknown = unknown(baseline, k);
                    let [value, error] = strength_of(baseline, trial, explanation, position);
                    match StrengthPrior::of(unknown).filter(|_| error > 0.0) {
                        Some(prior) => prior.share_told(value / unknown.sigma, error / unknown.sigma),
                        // what is all or none is all
                        None => 1.0,
                    }
                })
                .fold(0.0, f64::max);
            judgement.weight(first + place) + told.ln()
        });
    ln_sum(own.collect::<Vec<f64>>().into_iter())
}

/// Evidence of none that is known: half for fields that may be anything, half for one hump, each kind as much as its fields.
fn with_humps(linear: f64, humps: &[Hump]) -> f64 {
    let all: f64 = humps.iter().map(Hump::share).sum();
    let fitted = humps
        .iter()
        .map(|hump| hump.ln_evidence + (hump.share() / all).ln());
    match humps.is_empty() {
        true => linear,
        false => ln_sum([linear, ln_sum(fitted)].into_iter()) - std::f64::consts::LN_2,
    }
}

/// Is the best known explanation one at all? May the best pair be named?
///
/// # Errors
/// If the slopes of a fit are not finite.
pub fn gate(judgement: &mut Judgement, baseline: &Baseline) -> Result<(), DiagnoseError> {
    let of = |case: &Case| {
        judgement
            .beliefs
            .iter()
            .find(|belief| belief.case == *case)
            .map_or(0.0, |b| b.probability)
    };
    let known = judgement
        .beliefs
        .iter()
        .find(|b| matches!(b.case, Case::One(_) | Case::Two(..)));
    let Some(known) = known.cloned() else {
        return Ok(());
    };
    let members = match known.case {
        Case::Two(a, b) => vec![a, b],
        Case::One(a) => vec![a],
        Case::Nothing | Case::Novel => Vec::new(),
    };
    let local = judgement
        .best_of(&members)
        .and_then(|(_, explanation)| explanation?.local.clone());
    let mut refuted_at = None;
    if let Some(local) = local {
        let whitened = Whitened::new(&local, &baseline.scatter.noise)?;
        let none = Directions::none(&whitened);
        let left = baseline.significance(&whitened, &none);
        let p = 2.0 * left.p_misfit.min(left.p_field);
        refuted_at = (p < INADEQUATE).then_some(p);
        judgement.after_known = Some(left);
    }
    let odds = of(&Case::Novel) / known.probability.max(f64::MIN_POSITIVE);
    let first_is_novel = judgement.beliefs.first().is_some_and(|b| b.case == Case::Novel);
    judgement.is_novel = refuted_at.is_some() || (odds >= NOVEL_ODDS && first_is_novel);
    let first_is_pair = (judgement.beliefs.first()).is_some_and(|b| matches!(b.case, Case::Two(..)));
    judgement.pair_is_accepted = first_is_pair && !judgement.is_novel;
    if let Some(p) = refuted_at {
        refuted(&mut judgement.beliefs, baseline.settings.prior.novel, p);
    }
    Ok(())
}
