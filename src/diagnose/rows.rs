//! The rows of the report: hypotheses with their strengths, effects with their look-alikes.

use crate::study::left_out::{Local, Others, by_condition, by_wing};
use crate::study::{Unknown, UnknownKind};

use super::baseline::Baseline;
use super::evidence::ln_sum;
use super::judge::Judgement;
use super::ladder::held_out_sigma;
use super::library::Trial;
use super::posterior::{Belief, Case};
use super::refit::Explanation;
use super::screening::{
    ENOUGH_POWER, MATTERS, Sight, effect_of, family_wise, is_one_sided, place_of, power_at_distance,
    whole_strength,
};
use super::verdict::{EffectRow, Hypothesis, LookAlike, PlaceFound, Strength};

/// Strengths beyond this many scales get no name, whatever their probability.
const POSSIBLE: f64 = 3.0;
/// A strength is plausible if its plausible range lies within this many standard errors of it.
const NEAR: f64 = 2.0;
/// Look-alikes listed for each effect.
pub const LOOK_ALIKES: usize = 4;

/// Unknown of the missing effect at position `k`.
pub fn unknown<'a>(baseline: &'a Baseline, k: usize) -> &'a Unknown {
    &baseline.forward.unknowns()[baseline.data.missing[k]]
}

/// Name of the missing effect at position `k`.
pub fn name(baseline: &Baseline, k: usize) -> String {
    let unknown = unknown(baseline, k);
    effect_of(unknown).map_or_else(|| unknown.name.clone(), |(effect, ..)| effect.to_string())
}

/// A belief with its strengths and its gain in prediction.
pub fn hypothesis(baseline: &Baseline, judgement: &Judgement, gains: &Gains, belief: &Belief) -> Hypothesis {
    let families = belief.case.families();
    let found = judgement.best_of(&families);
    let (strengths, plausible) = match found.filter(|_| !families.is_empty()) {
        Some((index, explanation)) => strengths(baseline, &judgement.trials[index], explanation, &families),
        None => (Vec::new(), true),
    };
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
        plausible,
        in_set: belief.in_set,
        refitted: found.is_some_and(|(_, explanation)| explanation.is_some()),
        gain_left_out_conditions: local.and_then(|local| gains.conditions.with(local)),
        gain_left_out_wings: local.and_then(|local| gains.wings.with(local)),
    }
}

/// Strengths of the members of a trial, in the order of the families: first what the data show; and whether all are plausible.
fn strengths(
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
fn place(baseline: &Baseline, k: usize, found: Option<[f64; 2]>) -> Option<PlaceFound> {
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
fn plausible_range(unknown: &Unknown) -> [f64; 2] {
    match unknown.kind {
        UnknownKind::Effect { plausible, .. } => plausible,
        _ => unknown.range,
    }
}

/// Whether the plausible range of an effect lies within a few standard errors of a strength.
fn is_plausible(unknown: &Unknown, value: f64, error: f64) -> bool {
    let [low, high] = plausible_range(unknown);
    value >= low - NEAR * error && value <= high + NEAR * error
}

/// Whether a strength is not absurd: some scales at most.
fn is_nameable(unknown: &Unknown, value: f64) -> bool {
    let scale = effect_of(unknown).map_or(f64::INFINITY, |(_, _, scale, _)| scale);
    value.abs() <= POSSIBLE * scale
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

/// What makes one place of an effect better than another.
fn weight(row: &EffectRow) -> f64 {
    row.ln_evidence + 1e-6 * row.detectability.min(1e6)
}

/// A row for every missing effect; of those that could sit elsewhere, for their best place.
pub fn effect_rows(baseline: &Baseline, judgement: &Judgement, gains: &Gains) -> Vec<EffectRow> {
    let mut rows: Vec<EffectRow> = Vec::new();
    for k in 0..baseline.data.missing.len() {
        let Some(row) = effect_row(baseline, judgement, k) else {
            continue;
        };
        let elsewhere = rows.iter_mut().find(|other| other.effect == row.effect);
        match elsewhere.filter(|_| row.place.is_some()) {
            Some(other) if weight(&row) > weight(other) => *other = row,
            Some(_) => {}
            None => rows.push(row),
        }
    }
    for row in &mut rows {
        row.gain_left_out_conditions = gains.conditions.of(&row.unknown, judgement);
    }
    rows
}

/// The row of the missing effect at position `k`, but for its gain in prediction.
fn effect_row(baseline: &Baseline, judgement: &Judgement, k: usize) -> Option<EffectRow> {
    let directions = &baseline.directions;
    let level = family_wise(baseline.settings.significance, baseline.data.missing.len());
    let nothing = baseline.weighing.ln_nothing - baseline.settings.prior.nothing.ln();
    let own = unknown(baseline, k);
    let (effect, family, scale, _) = effect_of(own)?;
    let single = judgement.trials.iter().position(|trial| trial.members == [k]);
    let trial = single.map(|index| &judgement.trials[index]);
    let refit = judgement.refits.iter().find(|(index, _)| Some(*index) == single);
    let refit = refit.map(|(_, explanation)| explanation);
    // per unit of strength
    let (score, length) = (directions.scores[k], directions.lengths[k] / own.sigma);
    let by_slope = (length > 0.0).then(|| [score / length, 1.0 / length]);
    let found = refit.map(|e| [e.strength[0], e.standard_error[0]]);
    let weighed = trial.map(|trial| [trial.strength[0], trial.error[0]]);
    let [value, error] = found.or(weighed).or(by_slope).unwrap_or([0.0, f64::INFINITY]);
    let ln_evidence = trial.map_or(0.0, |trial| trial.ln_weight - trial.ln_prior - nothing);
    let distance = baseline.distances[k];
    let detectability = distance.unwrap_or(scale * length);
    Some(EffectRow {
        effect: effect.to_string(),
        family: family.to_string(),
        unknown: own.name.clone(),
        unit: own.unit.clone(),
        scale,
        score,
        one_step: by_slope.map(|one| one[0]),
        one_step_error: by_slope.map(|one| one[1]),
        refitted: found.map(|found| found[0]),
        refitted_error: found.map(|found| found[1]),
        plausible: is_plausible(own, value, error),
        plausible_range: plausible_range(own),
        detectability,
        power: power_at_distance(detectability, is_one_sided(own), level),
        sight: match ln_evidence {
            // odds of ten to one
            ln if ln > 10.0_f64.ln() => Sight::Possible,
            ln if ln < 0.0 && distance.is_some_and(|far| !is_unseen(MATTERS * far, own, level)) => {
                Sight::Absent
            }
            _ => Sight::Undecidable,
        },
        ln_evidence,
        probability: probability_of(baseline, judgement, effect),
        gain_left_out_conditions: None,
        held_out_gain: held_out_gain(baseline, refit),
        place: place(baseline, k, refit.and_then(|e| e.places[0])),
        look_alikes: look_alikes(baseline, k),
    })
}

/// Probability that an effect alone is what is missing: its part of that of its family.
fn probability_of(baseline: &Baseline, judgement: &Judgement, effect: &str) -> f64 {
    let of = |is_its: &dyn Fn(&Trial) -> bool| {
        let own = judgement
            .trials
            .iter()
            .filter(|trial| trial.members.len() == 1 && is_its(trial));
        ln_sum(own.map(|trial| trial.ln_weight).collect::<Vec<_>>().into_iter())
    };
    let is_its = |trial: &Trial| name(baseline, trial.members[0]) == effect;
    let Some(family) = judgement
        .trials
        .iter()
        .find(|trial| is_its(trial))
        .map(|trial| trial.families[0])
    else {
        return 0.0;
    };
    let share = of(&is_its) - of(&|trial| trial.families == [family]);
    judgement.probability(&Case::One(family)) * share.exp()
}

fn is_unseen(distance: f64, unknown: &Unknown, level: f64) -> bool {
    power_at_distance(distance, is_one_sided(unknown), level) < ENOUGH_POWER
}

/// How much better the held-out observables are predicted with an effect.
fn held_out_gain(baseline: &Baseline, refit: Option<&Explanation>) -> Option<f64> {
    let with = held_out_sigma(baseline, &refit?.fit.predicted)?;
    let without = held_out_sigma(baseline, &baseline.fit.predicted)?;
    (with > 0.0).then(|| without / with)
}

/// How much better each condition, and each wing, is predicted from the others with something more in the model.
pub struct Gains<'a> {
    conditions: LeftOutGain<'a>,
    wings: LeftOutGain<'a>,
}

impl<'a> Gains<'a> {
    /// Over the model as it is.
    pub fn new(baseline: &'a Baseline) -> Gains<'a> {
        let (forward, rows) = (baseline.forward, &baseline.data.rows);
        Gains {
            conditions: LeftOutGain::new(baseline, by_condition(forward, rows)),
            wings: LeftOutGain::new(baseline, by_wing(forward, rows)),
        }
    }
}

/// How much better each of these groups is predicted from the others.
struct LeftOutGain<'a> {
    baseline: &'a Baseline<'a>,
    groups: Vec<Vec<usize>>,
    others: Others,
    ln_density: Option<f64>,
}

impl<'a> LeftOutGain<'a> {
    fn new(baseline: &'a Baseline, groups: Vec<Vec<usize>>) -> LeftOutGain<'a> {
        let others = Others::new(&baseline.local, &baseline.scatter.noise);
        LeftOutGain {
            ln_density: others.ln_density(&groups),
            baseline,
            groups,
            others,
        }
    }

    /// By the fit that `local` is about.
    fn with(&self, local: &Local) -> Option<f64> {
        self.over(&Others::new(local, &self.baseline.scatter.noise))
    }

    /// With the effect whose strength is the unknown of this name: as refitted, else by the derivative.
    fn of(&self, unknown: &str, judgement: &Judgement) -> Option<f64> {
        let Baseline { data, forward, .. } = self.baseline;
        let k = (data.missing.iter()).position(|&i| forward.unknowns()[i].name == unknown)?;
        let refits = judgement.refits.iter();
        let refit = refits
            .filter(|(index, _)| judgement.trials[*index].members == [k])
            .map(|(_, found)| &found.local)
            .next();
        if let Some(local) = refit {
            return self.with(local);
        }
        // of the wrong sign, the best that it can have is none
        if is_one_sided(&forward.unknowns()[data.missing[k]]) && self.baseline.directions.scores[k] < 0.0 {
            return self.ln_density.map(|_| 0.0);
        }
        let column = self.baseline.slopes.column(k);
        self.over(&self.others.with(&column.select_rows(data.rows.iter())))
    }

    fn over(&self, with: &Others) -> Option<f64> {
        Some(with.ln_density(&self.groups)? - self.ln_density?)
    }
}

/// Members of other families whose direction is nearest, the nearest of each, if they may have the sign that takes.
fn look_alikes(baseline: &Baseline, k: usize) -> Vec<LookAlike> {
    let directions = &baseline.directions;
    // what is all or none has no signature at none
    let is_whole = |k: usize| whole_strength(unknown(baseline, k)).is_some();
    if is_whole(k) {
        return Vec::new();
    }
    let is_one_sided = |k: usize| is_one_sided(unknown(baseline, k));
    let sign = if is_one_sided(k) {
        1.0
    } else {
        directions.scores[k].signum()
    };
    let mut found: Vec<(usize, f64)> = baseline
        .families
        .iter()
        .filter(|family| !family.members.contains(&k))
        .filter_map(|family| {
            let cosine = |j: usize| directions.cosine(k, j);
            let near = family
                .members
                .iter()
                .filter(|&&j| !is_whole(j) && (!is_one_sided(j) || sign * cosine(j) > 0.0))
                .max_by(|&&a, &&b| cosine(a).abs().total_cmp(&cosine(b).abs()))?;
            Some((*near, cosine(*near)))
        })
        .collect();
    found.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    // an effect of which the two signs are two families looks like itself, which says nothing
    let own = name(baseline, k);
    found
        .into_iter()
        .filter(|(j, _)| name(baseline, *j) != own)
        .take(LOOK_ALIKES)
        .map(|(j, cosine)| LookAlike {
            effect: name(baseline, j),
            cosine,
            separation_sigma: directions.scores[k].abs() * (1.0 - cosine * cosine).max(0.0).sqrt(),
        })
        .collect()
}

/// Effects that could not have been seen, wherever they sit.
pub fn unseen(baseline: &Baseline, effects: &[EffectRow]) -> Vec<String> {
    let level = family_wise(baseline.settings.significance, baseline.data.missing.len());
    let elsewhere = |row: &EffectRow| {
        let places = (0..baseline.data.missing.len()).filter(|&k| name(baseline, k) == row.effect);
        let mut seen =
            places.filter_map(|k| Some(!is_unseen(baseline.distances[k]?, unknown(baseline, k), level)));
        seen.any(|is_seen| is_seen)
    };
    let unseen = effects
        .iter()
        .filter(|row| row.power < ENOUGH_POWER && !elsewhere(row));
    unseen.map(|row| row.effect.clone()).collect()
}
