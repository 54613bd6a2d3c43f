//! What may be the case, for the report: nothing, effects with their strengths, or an unknown cause.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::study::UnknownKind;

use super::baseline::Baseline;
use super::evidence::ln_sum;
use super::gains::Gains;
use super::judge::{Judgement, OfEffects};
use super::misfit::{Pull, pulls_of_inputs};
use super::posterior::{Belief, Case};
use super::strengths::{Strength, is_nameable, name, strengths, unknown};

/// What may be the case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hypothesis {
    /// Effects that are missing: none (nothing is), one, two; `novel` for an unknown cause.
    pub effects: Vec<String>,
    /// Their families.
    pub families: Vec<String>,
    /// Of one family, the effects of it that it may be, the most probable first; none where it can be one alone.
    #[serde(default)]
    pub members: Vec<MemberShare>,
    /// Strengths, with the unknowns that they are values of: two of one family mean a place between them.
    pub strengths: Vec<Strength>,
    /// Its probability.
    pub probability: f64,
    /// Strength of the first effect.
    pub strength: Option<f64>,
    /// Its standard error.
    pub standard_error: Option<f64>,
    /// Inputs of the design, and zeros and scales of the instruments, in the same fit; none where it was not fitted.
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

/// One effect of a family, and its part of what the family has.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MemberShare {
    /// The effect.
    pub effect: String,
    /// Probability that it is what is missing, at whatever place.
    pub probability: f64,
}

/// Part of the most probable effect of a family from which on another is named beside it. Assumed; it chooses words.
const NAMED_BESIDE: f64 = 1.0 / 3.0;

impl Hypothesis {
    /// Its effects in words, two joined by `and`; of a family, those that are about as probable.
    pub fn names(&self, and: &str) -> String {
        let beside = self.beside().iter().map(|own| format!(" or {}", own.effect));
        self.effects.join(and) + &beside.collect::<String>()
    }

    /// The effects of its family that are about as probable as the one that is named.
    pub fn beside(&self) -> &[MemberShare] {
        let [first, others @ ..] = self.members.as_slice() else {
            return &[];
        };
        let is_named = |own: &MemberShare| own.probability >= NAMED_BESIDE * first.probability;
        &others[..others.partition_point(is_named)]
    }
}

/// The effects of one family that share a probability; none where it has one alone.
fn members(baseline: &Baseline, judgement: &Judgement, belief: &Belief) -> Vec<MemberShare> {
    let Case::One(family) = belief.case else {
        return Vec::new();
    };
    let all = judgement.by_effects(&[family]);
    let whole = ln_sum(all.iter().map(|own| own.ln_weight));
    let share = |own: &OfEffects| MemberShare {
        effect: name(baseline, own.effects[0]),
        probability: belief.probability * (own.ln_weight - whole).exp(),
    };
    match all.len() {
        0 | 1 => Vec::new(),
        _ => all.iter().map(share).collect(),
    }
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
        members: members(baseline, judgement, belief),
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

#[cfg(test)]
mod tests {
    use super::*;

    fn hypothesis(members: &[(&str, f64)]) -> Hypothesis {
        let share = |&(effect, probability): &(&str, f64)| MemberShare {
            effect: effect.to_string(),
            probability,
        };
        Hypothesis {
            effects: vec!["rod-split".to_string()],
            families: vec!["rod-damage".to_string()],
            members: members.iter().map(share).collect(),
            strengths: Vec::new(),
            probability: 0.62,
            strength: None,
            standard_error: None,
            inputs: Vec::new(),
            plausible: true,
            in_set: true,
            refitted: true,
            gain_left_out_conditions: None,
            gain_left_out_wings: None,
        }
    }

    #[test]
    fn what_of_a_family_is_about_as_probable_is_named_beside_the_first() {
        let named = |members: &[(&str, f64)]| hypothesis(members).names(" + ");
        assert_eq!(named(&[]), "rod-split");
        let close = [("rod-split", 0.32), ("rod-ends-early", 0.3), ("broken", 0.01)];
        assert_eq!(named(&close), "rod-split or rod-ends-early");
        assert_eq!(
            named(&[("rod-split", 0.6), ("rod-ends-early", 0.02)]),
            "rod-split"
        );
    }
}
