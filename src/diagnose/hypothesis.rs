//! What may be the case, for the report: nothing, effects with their strengths, or an unknown cause.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::study::UnknownKind;

use super::baseline::Baseline;
use super::gains::Gains;
use super::judge::Judgement;
use super::misfit::{Pull, pulls_of_inputs};
use super::posterior::{Belief, Case};
use super::strengths::{Strength, is_nameable, strengths, unknown};

/// What may be the case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hypothesis {
    /// Effects that are missing: none (nothing is), one, two; `novel` for an unknown cause.
    pub effects: Vec<String>,
    /// Their families.
    pub families: Vec<String>,
    /// Strengths, with the unknowns that they are values of: two of one family mean a place between them.
    pub strengths: Vec<Strength>,
    /// Its probability.
    pub probability: f64,
    /// Strength of the first effect.
    pub strength: Option<f64>,
    /// Its standard error.
    pub standard_error: Option<f64>,
    /// Inputs of the design in the same fit; none where it was not fitted.
    #[serde(default)]
    pub inputs: Vec<Pull>,
    /// Whether the plausible range of every strength lies within two standard errors of it.
    pub plausible: bool,
    /// Whether it belongs to the smallest set that holds the truth with 95 %.
    pub in_set: bool,
    /// Whether the strengths are those of a fit in the whole model.
    pub refitted: bool,
    /// Gain in predicting left-out conditions, in ln of the density; a necessary sign, not a ranking.
    pub gain_left_out_conditions: Option<f64>,
    /// The same for left-out wings.
    pub gain_left_out_wings: Option<f64>,
}

/// A belief with its strengths and its gain in prediction.
pub fn hypothesis(baseline: &Baseline, judgement: &Judgement, gains: &Gains, belief: &Belief) -> Hypothesis {
    let families = belief.case.families();
    let found = judgement.best_of(&families);
    let (strengths, plausible) = match found.filter(|_| !families.is_empty()) {
        Some((index, explanation)) => strengths(baseline, &judgement.trials[index], explanation, &families),
        None => (Vec::new(), true),
    };
    let fit = found.and_then(|(_, explanation)| Some(&explanation?.fit));
    let local = found.and_then(|(_, explanation)| Some(&explanation?.local));
    let family_names = families
        .iter()
        .map(|&family| baseline.families[family].name.clone());
    let effects: Vec<String> = match belief.case {
        Case::Unknown => vec!["novel".into()],
        _ => families
            .iter()
            .filter_map(|&family| {
                let own = strengths.iter().filter(|s| {
                    baseline.families[family]
                        .members
                        .iter()
                        .any(|&k| unknown(baseline, k).name == s.unknown)
                });
                own.max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))
                    .map(|s| s.effect.clone())
            })
            .collect(),
    };
    Hypothesis {
        effects,
        families: family_names.collect(),
        probability: belief.probability,
        strength: strengths.first().map(|s| s.value),
        standard_error: strengths.first().map(|s| s.standard_error),
        strengths,
        inputs: fit.map_or(Vec::new(), |fit| pulls_of_inputs(baseline.forward, fit)),
        plausible,
        in_set: belief.in_set,
        refitted: found.is_some_and(|(_, explanation)| explanation.is_some()),
        gain_left_out_conditions: local.and_then(|local| gains.conditions.with(local)),
        gain_left_out_wings: local.and_then(|local| gains.wings.with(local)),
    }
}

/// Whether no strength of a hypothesis is absurd: some scales at most, and not at an end of what is accepted, but for no strength
/// at all, and for an end that is plausible (a tip loss of 1 is all of it).
pub fn is_possible(baseline: &Baseline, hypothesis: &Hypothesis) -> bool {
    let unknowns = baseline.forward.unknowns();
    hypothesis.strengths.iter().all(|strength| {
        let own = unknowns.iter().find(|own| own.name == strength.unknown);
        own.is_none_or(|own| {
            let is_plausible = matches!(own.kind, UnknownKind::Effect { plausible: [low, high], .. }
                if (low..=high).contains(&strength.value));
            is_nameable(own, strength.value) && (!strength.at_end || is_plausible)
        })
    })
}
