//! Strengths of the missing effects: as fitted or weighed, where they sit, and whether they are plausible.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::study::{Unknown, UnknownKind};

use super::baseline::Baseline;
use super::library::Trial;
use super::refit::Explanation;
use super::screening::{effect_of, place_of, whole_strength};

/// Strengths beyond this many scales get no name, whatever their probability.
const POSSIBLE: f64 = 3.0;
/// A strength is plausible if its plausible range lies within this many standard errors of it.
const NEAR: f64 = 2.0;

/// Strength of one effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Strength {
    /// The effect.
    pub effect: String,
    /// Its family.
    pub family: String,
    /// The unknown.
    pub unknown: String,
    /// Its value.
    pub value: f64,
    /// Whether that is an end of what is accepted, and the data ask for no less; never of what is all or none.
    pub at_end: bool,
    /// Its standard error; 0 of what is all or none, or was tried in steps alone.
    pub standard_error: f64,
    /// Its unit.
    pub unit: String,
    /// Where it sits, if that was not known.
    pub place: Option<PlaceFound>,
    /// What it is on the first wing that has the effect, as something that a bench measures: the number, and its unit with what it is.
    #[serde(default)]
    pub stands_for: Option<(f64, String)>,
}

/// Where an effect sits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PlaceFound {
    /// The parameter of the effect that it is a value of.
    pub parameter: String,
    /// Its value.
    pub value: f64,
    /// The same from the wing base, mm, where it is a fraction of the length of a rod.
    #[serde(default)]
    pub at_mm: Option<f64>,
    /// Its standard error; none if it was not fitted.
    pub standard_error: Option<f64>,
    /// Unit of both; `1` if they have none.
    pub unit: String,
    /// Other numbers that the effect needs, such as which spar.
    pub numbers: BTreeMap<String, f64>,
    /// The wing on which it sits, by the name of its design; none if on all.
    pub wing: Option<String>,
}

/// Unknown of the missing effect at position `k`.
pub fn unknown<'a>(baseline: &'a Baseline, k: usize) -> &'a Unknown {
    &baseline.forward.unknowns()[baseline.data.missing[k]]
}

/// Name of the missing effect at position `k`.
pub fn name(baseline: &Baseline, k: usize) -> String {
    let unknown = unknown(baseline, k);
    effect_of(unknown).map_or_else(|| unknown.name.clone(), |(effect, ..)| effect.to_string())
}

/// Strengths of the members of a trial, in the order of the families: first what the data show; and whether all are plausible.
pub(super) fn strengths(
    baseline: &Baseline,
    trial: &Trial,
    explanation: Option<&Explanation>,
    families: &[usize],
) -> (Vec<Strength>, bool) {
    let family_of = |k: usize| {
        let has = |&family: &usize| baseline.families[family].members.contains(&k);
        families.iter().position(has)
    };
    let family_name = |k: usize| {
        let own = family_of(k).map(|position| &baseline.families[families[position]]);
        own.map_or_else(String::new, |family| family.name.clone())
    };
    let mut ordered: Vec<(usize, usize)> = trial.members.iter().copied().enumerate().collect();
    ordered.sort_by_key(|&(_, k)| family_of(k));
    let mut strengths: Vec<Strength> = Vec::new();
    let mut plausible = true;
    for (position, k) in ordered {
        let own = unknown(baseline, k);
        let [value, error] = strength_of(trial, explanation, position);
        plausible &= is_plausible(own, value, error);
        let [low, high] = own.range;
        // what is all or none has no more to it than all
        let may_end = whole_strength(own).is_none();
        strengths.push(Strength {
            effect: name(baseline, k),
            family: family_name(k),
            unknown: own.name.clone(),
            value: value.clamp(low, high),
            at_end: may_end && ((low != 0.0 && value <= low) || (high != 0.0 && value >= high)),
            standard_error: error,
            unit: own.unit.clone(),
            place: place(baseline, k, explanation.and_then(|e| e.places[position])),
            stands_for: None,
        });
    }
    (strengths, plausible)
}

/// Strength of a member of an explanation and its standard error: as fitted, else as weighed.
fn strength_of(trial: &Trial, explanation: Option<&Explanation>, position: usize) -> [f64; 2] {
    match explanation {
        Some(fitted) => [fitted.strength[position], fitted.standard_error[position]],
        None => [trial.strength[position], trial.error[position]],
    }
}

/// Where the missing effect at position `k` sits, if that is not known; `found`: as fitted.
pub(super) fn place(baseline: &Baseline, k: usize, found: Option<[f64; 2]>) -> Option<PlaceFound> {
    let unknowns = baseline.forward.unknowns();
    let own = &unknowns[place_of(unknowns, baseline.data.missing[k])?];
    let UnknownKind::Place {
        parameter,
        numbers,
        wing,
        rod_mm,
        ..
    } = &own.kind
    else {
        return None;
    };
    let value = found.map_or(own.mean, |[value, _]| value);
    Some(PlaceFound {
        parameter: parameter.clone(),
        value,
        at_mm: rod_mm.map(|rod_mm| value * rod_mm),
        standard_error: found.map(|[_, error]| error),
        unit: own.unit.clone(),
        numbers: numbers.clone(),
        wing: wing.clone(),
    })
}

/// Strengths of an effect that are plausible in nature.
pub(super) fn plausible_range(unknown: &Unknown) -> [f64; 2] {
    match unknown.kind {
        UnknownKind::Effect { plausible, .. } => plausible,
        _ => unknown.range,
    }
}

/// Whether the plausible range of an effect lies within a few standard errors of a strength.
pub(super) fn is_plausible(unknown: &Unknown, value: f64, error: f64) -> bool {
    let [low, high] = plausible_range(unknown);
    value >= low - NEAR * error && value <= high + NEAR * error
}

/// Whether a strength is not absurd: some scales at most.
pub(super) fn is_nameable(unknown: &Unknown, value: f64) -> bool {
    let scale = effect_of(unknown).map_or(f64::INFINITY, |(_, _, scale, _)| scale);
    value.abs() <= POSSIBLE * scale
}
