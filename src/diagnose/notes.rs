//! What a reader must know besides the verdict.

use crate::effects::{Need, named};

use super::baseline::Baseline;
use super::error::DiagnoseError;
use super::judge::Judgement;
use super::ladder::held_out_sigma;
use super::posterior::{Case, SEPARATE};
use super::refit::Explanation;
use super::robust::stability;
use super::rows::name;
use super::screening::effect_of;

/// The notes of a diagnosis.
///
/// # Errors
/// If a scatter is not positive.
pub fn notes(
    baseline: &Baseline,
    judgement: &Judgement,
    unsolved: &[usize],
) -> Result<Vec<String>, DiagnoseError> {
    let mut notes = Vec::new();
    let numbers = baseline.data.rows.len();
    if baseline.on_trust() {
        notes.push(format!(
            "Only {numbers} numbers: the noise level is taken on trust, and trusted little."
        ));
    } else if (baseline.scatter.scale - 1.0).abs() > 0.2 {
        let scale = baseline.scatter.scale;
        notes.push(format!(
            "The data scatter {scale:.2} times as much as stated; that is what was used."
        ));
    }
    let is_null = judgement.significance.p_null > baseline.settings.significance;
    let of_motion = of_motion(baseline);
    if !is_null && !of_motion.is_empty() {
        notes.push(format!(
            "{} rest on the motion of the wing over the stroke; near a resonance errors of a percent turn their signatures, \
             so that they can be missed or taken for another there.",
            of_motion.join(", ")
        ));
    }
    if let Some(foretold) = judgement.foretold.filter(|_| judgement.is_foretold()) {
        let observable = &baseline.forward.observables()[foretold.row];
        let odds = if foretold.odds < 1e6 {
            format!("{:.0} to 1", foretold.odds)
        } else {
            "more than a million to 1".to_owned()
        };
        notes.push(format!(
            "One reading carries this ({}, {}). It lies where an effect says that has nothing to be fitted; odds against a slip that fell \
             there: {odds}.",
            baseline.forward.conditions()[observable.condition].name,
            observable.channel.name(),
        ));
    }
    if let Some([without, with]) =
        held_out_worse(baseline, judgement).filter(|_| !is_null || judgement.is_foretold())
    {
        notes.push(format!(
            "What was held out is met worse with the first of these, by {with:.1} sigma instead of {without:.1}."
        ));
    }
    let unanswered = baseline.unanswered.iter().map(|&k| name(baseline, k));
    let unanswered: Vec<String> = unanswered.collect();
    if !unanswered.is_empty() {
        notes.push(format!(
            "{}: no derivative at none, and no equilibrium at the plausible size; these were not looked at.",
            unanswered.join(", ")
        ));
    }
    let narrow = judgement
        .narrow
        .iter()
        .flat_map(|&index| &judgement.trial(index).members);
    let narrow: Vec<String> = narrow.map(|&k| name(baseline, k)).collect();
    if !narrow.is_empty() {
        notes.push(format!(
            "Standard errors with {} do not hold what a percent of chord, stiffness or air moves with the effect: the model has no \
             derivatives there.",
            narrow.join(", ")
        ));
    }
    let unsettled = unsettled(judgement);
    if !unsettled.is_empty() {
        notes.push(format!(
            "No fit settled with {}: weighed by derivatives alone.",
            unsettled.join(", ")
        ));
    }
    let passed_over = passed_over(baseline, judgement, unsolved);
    if !passed_over.is_empty() {
        notes.push(format!(
            "{}: no equilibrium at a plausible size, and no fit from there; weighed by derivatives alone.",
            passed_over.join(", ")
        ));
    }
    let unnamed: Vec<&str> = judgement.humps.unsettled.iter().map(|kind| kind.name()).collect();
    if !unnamed.is_empty() {
        notes.push(format!(
            "No fit settled with an {}: weighed by linear fields alone.",
            unnamed.join(", an ")
        ));
    }
    let beliefs = judgement.beliefs.iter().filter_map(|belief| match belief.case {
        Case::One(family) => {
            let (index, explanation) = judgement.best_of(&[family])?;
            Some((explanation?, judgement.trial(index).ln_prior))
        }
        _ => None,
    });
    let explanations: Vec<(&Explanation, f64)> = beliefs.collect();
    if !is_null {
        let share = stability(
            baseline.forward,
            &baseline.data,
            baseline.settings,
            &baseline.scatter,
            &baseline.admitted,
            &explanations,
        )?;
        if let Some(share) = share {
            notes.push(format!(
                "Without any one condition, the best single effect keeps its place in {:.0} % of the cases.",
                100.0 * share
            ));
        }
    }
    Ok(notes)
}

/// Error of what was held out without and with the most probable known effect, sigma, if that makes it larger.
fn held_out_worse(baseline: &Baseline, judgement: &Judgement) -> Option<[f64; 2]> {
    let families = match judgement.beliefs.first()?.case {
        Case::One(family) => vec![family],
        Case::Two(first, second) => vec![first, second],
        Case::Nothing | Case::Novel => return None,
    };
    let (_, found) = judgement.best_of(&families)?;
    let fit = found?.fit.as_ref();
    let both =
        [&baseline.fit.predicted, &fit?.predicted].map(|predicted| held_out_sigma(baseline, predicted));
    match both {
        [Some(without), Some(with)] if with > without => Some([without, with]),
        _ => None,
    }
}

/// Names of the explanations whose fit settled nowhere, while no other form of theirs was fitted.
fn unsettled(judgement: &Judgement) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for &index in &judgement.unsettled {
        let families = &judgement.trial(index).families;
        if matches!(judgement.best_of(families), Some((_, Some(_)))) {
            continue;
        }
        let name = |family: &usize| judgement.families[*family].name.as_str();
        let name = families.iter().map(name).collect::<Vec<_>>().join(" with ");
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Effects that a second look could not take a step of in the model, or that have no solution at their plausible size (`unsolved`), and
/// that were not fitted either.
fn passed_over(baseline: &Baseline, judgement: &Judgement, unsolved: &[usize]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let singles = judgement.singles.iter().enumerate();
    let unsolved = singles.filter(|(_, trial)| matches!(trial.members[..], [k] if unsolved.contains(&k)));
    for index in judgement
        .passed_over
        .iter()
        .copied()
        .chain(unsolved.map(|(index, _)| index))
    {
        let trial = judgement.trial(index);
        let is_told = judgement.unsettled.contains(&index)
            || matches!(judgement.best_of(&trial.families), Some((_, Some(_))));
        let own = trial.members.iter().map(|&k| name(baseline, k));
        names.extend(own.filter(|_| !is_told));
    }
    names.sort();
    names.dedup();
    names
}

/// Effects that are tried and need the motion over the stroke, as far as this campaign could see them.
fn of_motion<'a>(baseline: &'a Baseline) -> Vec<&'a str> {
    let (data, directions) = (&baseline.data, &baseline.directions);
    let effects = (0..data.missing.len()).filter_map(|k| {
        let unknown = &baseline.forward.unknowns()[data.missing[k]];
        let (effect, _, scale, _) = effect_of(unknown)?;
        let moves = named(effect).is_some_and(|known| known.card().needs.contains(&Need::Motion));
        let is_seen = scale / unknown.sigma * directions.lengths[k] > SEPARATE;
        (moves && is_seen).then_some(effect)
    });
    effects.collect()
}
