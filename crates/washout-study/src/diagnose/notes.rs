//! What a reader must know besides the verdict.

use crate::effects::{Need, named};

use super::baseline::Baseline;
use super::digits::short;
use super::judge::Judgement;
use super::ladder::held_out_sigma;
use super::posterior::{Case, SEPARATE};
use super::screening::effect_of;
use super::strengths::name;

/// The notes of a diagnosis, what changes an answer most first.
pub fn notes(baseline: &Baseline, judgement: &Judgement) -> Vec<String> {
    let mut notes = Vec::new();
    let is_nothing = judgement
        .beliefs
        .first()
        .is_some_and(|first| first.case == Case::Nothing);
    if let Some([without, with]) = held_out_worse(baseline, judgement).filter(|_| !is_nothing) {
        let [with, without] = [with, without].map(|sigma| format!("{sigma:.1}"));
        if with != without {
            notes.push(format!(
                "What was held out is met worse with the first of these, by {with} sigma instead of {without}."
            ));
        }
    }
    notes.extend(at_end(baseline, judgement));
    let of_motion = of_motion(baseline);
    if !is_nothing && !of_motion.is_empty() {
        notes.push(format!(
            "Made from the motion of the wing over the stroke: {}. Near a resonance errors of a percent turn such signatures, so that they \
             can be missed or taken for another there.",
            of_motion.join(", ")
        ));
    }
    notes.extend(without_solution(baseline, judgement));
    let scale = baseline.size.scale;
    if baseline.on_trust() {
        notes.push(format!(
            "Only {} fitted numbers, too few to check the stated sigma: it is taken as stated, with much doubt.",
            baseline.data.rows.len()
        ));
    } else if (scale - 1.0).abs() > 0.2 {
        notes.push(format!(
            "The data scatter {scale:.2} times as much as stated; that is what was used."
        ));
    }
    notes
}

/// Inputs that the fit of what is most probable has moved to an end of their range.
fn at_end(baseline: &Baseline, judgement: &Judgement) -> Option<String> {
    let first = judgement.beliefs.first().map(|first| first.case.families());
    let found = first.and_then(|families| judgement.best_of(&families)?.1);
    let fit = found.map_or(&baseline.fit, |found| &found.fit);
    let unknowns = baseline.forward.unknowns();
    let of_model = fit.at_end.iter().filter(|i| baseline.data.model.contains(i));
    let parts: Vec<String> = of_model
        .map(|&i| {
            let own = &unknowns[i];
            let unit = if own.unit == "1" { "" } else { own.unit.as_str() };
            format!("{} = {} {unit}", own.name, short(fit.at[i]))
                .trim_end()
                .to_string()
        })
        .collect();
    (!parts.is_empty()).then(|| {
        format!(
            "The fit ends at the end of the range of {}: measure it, or state in the study how well it is known.",
            parts.join(", ")
        )
    })
}

/// What no fit or no equilibrium was found for, and how it was weighed.
fn without_solution(baseline: &Baseline, judgement: &Judgement) -> Vec<String> {
    let mut notes = Vec::new();
    let unsettled = unsettled(baseline, judgement);
    if !unsettled.is_empty() {
        notes.push(format!(
            "No fit settled with {}: weighed by finite steps alone.",
            unsettled.join(", ")
        ));
    }
    let unsolved = unsolved(baseline);
    if !unsolved.is_empty() {
        notes.push(format!(
            "{}: at their larger sizes the wing of the model has no equilibrium, so that they were tried at smaller sizes alone.",
            unsolved.join(", ")
        ));
    }
    let added: Vec<String> = baseline
        .weighing
        .unsolved
        .iter()
        .map(|pair| both(baseline, pair))
        .collect();
    if !added.is_empty() {
        notes.push(format!(
            "{}: no equilibrium with both was found; weighed by the sum of what each makes.",
            added.join(", ")
        ));
    }
    let unnamed: Vec<&str> = judgement.bumps.unsettled.iter().map(|kind| kind.name()).collect();
    if !unnamed.is_empty() {
        notes.push(format!(
            "No fit settled with an {}: weighed by smooth fields alone.",
            unnamed.join(", an ")
        ));
    }
    notes
}

/// Error of what was held out without and with the most probable known effect, sigma, if that makes it larger.
fn held_out_worse(baseline: &Baseline, judgement: &Judgement) -> Option<[f64; 2]> {
    let (_, found) = judgement.best_of(&judgement.beliefs.first()?.case.families())?;
    let both =
        [&baseline.fit.predicted, &found?.fit.predicted].map(|predicted| held_out_sigma(baseline, predicted));
    match both {
        [Some(without), Some(with)] if with > without => Some([without, with]),
        _ => None,
    }
}

/// Names of the explanations whose fit settled nowhere.
fn unsettled(baseline: &Baseline, judgement: &Judgement) -> Vec<String> {
    let names = |&index: &usize| both(baseline, &judgement.trials[index].members);
    let mut names: Vec<String> = judgement.unsettled.iter().map(names).collect();
    names.dedup();
    names
}

/// Effects that act together, by position among the missing, in words.
fn both(baseline: &Baseline, members: &[usize]) -> String {
    let names: Vec<String> = members.iter().map(|&k| name(baseline, k)).collect();
    names.join(" with ")
}

/// Effects at a step of which the model has no solution.
fn unsolved(baseline: &Baseline) -> Vec<String> {
    let each = baseline.responses.each.iter().enumerate();
    let mut names: Vec<String> = each
        .filter(|(_, response)| !response.unsolved.is_empty())
        .map(|(k, _)| name(baseline, k))
        .collect();
    names.sort();
    names.dedup();
    names
}

/// Effects that are tried and need the motion over the stroke, as far as this campaign could see them.
fn of_motion<'a>(baseline: &'a Baseline) -> Vec<&'a str> {
    let data = &baseline.data;
    let effects = (0..data.missing.len()).filter_map(|k| {
        let unknown = &baseline.forward.unknowns()[data.missing[k]];
        let (effect, ..) = effect_of(unknown)?;
        let moves = named(effect).is_some_and(|known| known.card().needs.contains(&Need::Motion));
        let is_seen = baseline.distances[k].is_some_and(|distance| distance > SEPARATE);
        (moves && is_seen).then_some(effect)
    });
    effects.collect()
}
