//! The rows of the report: hypotheses with their strengths, effects with their look-alikes.

use crate::study::left_out::{Local, Others, by_condition, by_wing};
use crate::study::{Unknown, UnknownKind};

use super::baseline::Baseline;
use super::far::Far;
use super::judge::{Judgement, distance_of_fits};
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

/// Probability of a case.
pub fn probability(judgement: &Judgement, case: &Case) -> f64 {
    judgement
        .beliefs
        .iter()
        .find(|belief| belief.case == *case)
        .map_or(0.0, |belief| belief.probability)
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

/// Families of a case.
pub fn case_families(case: &Case) -> Vec<usize> {
    match case {
        Case::One(a) => vec![*a],
        Case::Two(a, b) => vec![*a, *b],
        Case::Nothing | Case::Novel => Vec::new(),
    }
}

/// A belief with its strengths and its gain in prediction.
pub fn hypothesis(baseline: &Baseline, judgement: &Judgement, gains: &Gains, belief: &Belief) -> Hypothesis {
    let families = case_families(&belief.case);
    let found = judgement.best_of(&families);
    let mut strengths: Vec<Strength> = Vec::new();
    let mut plausible = true;
    if let Some((index, explanation)) = found.filter(|_| !families.is_empty()) {
        let trial = judgement.trial(index);
        let members = explanation.map_or(&trial.members, |explanation| &explanation.members);
        // in the order of the families: first what the data show
        let family_of = |k: usize| {
            let has = |&family: &usize| judgement.families[family].members.contains(&k);
            families.iter().position(has)
        };
        let mut ordered: Vec<(usize, usize)> = members.iter().copied().enumerate().collect();
        ordered.sort_by_key(|&(_, k)| family_of(k));
        let family_name = |k: usize| {
            let own = family_of(k).map(|position| &judgement.families[families[position]]);
            own.map_or_else(String::new, |family| family.name.clone())
        };
        for (position, k) in ordered {
            let own = unknown(baseline, k);
            let [value, error] = strength_of(baseline, trial, explanation, position);
            plausible &= is_plausible(own, value, error);
            let [low, high] = own.range;
            // what is all or none has no more to it than all
            let may_end = whole_strength(own).is_none();
            strengths.push(Strength {
                effect: name(baseline, k),
                family: family_name(k),
                unknown: own.name.clone(),
                // a derivative knows no end
                value: value.clamp(low, high),
                at_end: may_end && ((low != 0.0 && value <= low) || (high != 0.0 && value >= high)),
                standard_error: error,
                unit: own.unit.clone(),
                place: place(baseline, k, explanation.and_then(|e| e.places[position])),
            });
        }
    }
    let local = found.and_then(|(_, explanation)| explanation?.local.as_ref());
    let family_names = families
        .iter()
        .map(|&family| judgement.families[family].name.clone());
    let effects: Vec<String> = match belief.case {
        Case::Novel => vec!["novel".into()],
        _ => families
            .iter()
            .filter_map(|&family| {
                let own = strengths.iter().filter(|s| {
                    judgement.families[family]
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
        is_shown: belief.is_shown,
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

/// Strength of a member of an explanation and its standard error: as fitted, else by the linear model.
pub fn strength_of(
    baseline: &Baseline,
    trial: &Trial,
    explanation: Option<&Explanation>,
    position: usize,
) -> [f64; 2] {
    match explanation {
        Some(fitted) => [fitted.strength[position], fitted.standard_error[position]],
        None => {
            let sigma = unknown(baseline, trial.members[position]).sigma;
            [trial.linear.estimate[position], trial.linear.error[position]].map(|value| value * sigma)
        }
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
        ..
    } = &own.kind
    else {
        return None;
    };
    Some(PlaceFound {
        parameter: parameter.clone(),
        value: found.map_or(own.mean, |[value, _]| value),
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
pub fn is_nameable(unknown: &Unknown, value: f64) -> bool {
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

/// A row for every missing effect; of those that could sit elsewhere, for their best place; `far`: what the model has of those that are
/// far out by their derivative.
pub fn effect_rows(baseline: &Baseline, judgement: &Judgement, gains: &Gains, far: &Far) -> Vec<EffectRow> {
    let directions = &baseline.directions;
    let significance = family_wise(baseline.settings.significance, baseline.data.missing.len());
    let base = baseline.likelihood.ln(baseline.whitened.q()) - 0.5 * baseline.whitened.ln_determinant;
    let mut rows: Vec<EffectRow> = Vec::new();
    for (k, &i) in baseline.data.missing.iter().enumerate() {
        let own = &baseline.forward.unknowns()[i];
        let Some((effect, family, scale, _)) = effect_of(own) else {
            continue;
        };
        let single = judgement.singles.iter().position(|trial| trial.members == [k]);
        let refit = judgement
            .refits
            .iter()
            .find(|(index, _)| Some(*index) == single)
            .map(|(_, e)| e);
        let whole = refit.and_then(|refit| whole_step(baseline, own, refit));
        // per unit of strength
        let (score, length) = match whole {
            Some([score, distance]) => (score, distance / scale),
            None => (directions.scores[k], directions.lengths[k] / own.sigma),
        };
        let one_step = if length > 0.0 { score / length } else { 0.0 };
        let family_index = judgement.families.iter().position(|f| f.name == family);
        let one_step_error = if length > 0.0 { 1.0 / length } else { f64::MAX };
        let refitted = refit.map(|e| e.strength[0]);
        let refitted_error = refit.map(|e| e.standard_error[0]);
        let ln_evidence = single.map_or(0.0, |index| judgement.ln_evidence[index] - base);
        let row = EffectRow {
            effect: effect.to_string(),
            family: family.to_string(),
            unknown: own.name.clone(),
            unit: own.unit.clone(),
            scale,
            score,
            one_step,
            one_step_error,
            refitted,
            refitted_error,
            plausible: is_plausible(
                own,
                refitted.unwrap_or(one_step),
                refitted_error.unwrap_or(one_step_error),
            ),
            plausible_range: plausible_range(own),
            detectability: far.distance[k].unwrap_or(scale * length),
            power: match whole.map(|[_, distance]| distance).or(far.distance[k]) {
                Some(distance) => power_at_distance(distance, is_one_sided(own), significance),
                None => directions.power(k, own, significance),
            },
            // what a fit finds is there, whatever the derivative at zero says of it
            sight: match refit {
                Some(fit) if ln_evidence > 0.0 && fit.strength[0].abs() > NEAR * fit.standard_error[0] => {
                    Sight::Possible
                }
                Some(_) if whole.is_some_and(|[_, distance]| !is_unseen(distance, own, significance)) => {
                    Sight::Absent
                }
                _ if whole.is_some() => Sight::Undecidable,
                _ => match directions.sight(k, own, significance) {
                    // what a third of the derivative's size would show, a third of the model's may not
                    Sight::Absent if far.unsolved.contains(&k) => Sight::Undecidable,
                    Sight::Absent
                        if far.distance[k]
                            .is_some_and(|distance| is_unseen(MATTERS * distance, own, significance)) =>
                    {
                        Sight::Undecidable
                    }
                    sight => sight,
                },
            },
            ln_evidence,
            probability: family_index.map_or(0.0, |f| probability(judgement, &Case::One(f))),
            gain_left_out_conditions: None,
            held_out_gain: held_out_gain(baseline, refit),
            place: place(baseline, k, refit.and_then(|e| e.places[0])),
            look_alikes: look_alikes(baseline, judgement, k),
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

/// Score of an effect that is all or none, and how far the data lie with it from without, in standard deviations: by the whole of it, as
/// its derivative at none says nothing.
fn whole_step(baseline: &Baseline, unknown: &Unknown, refit: &Explanation) -> Option<[f64; 2]> {
    whole_strength(unknown)?;
    let distance = distance_of_fits(baseline, &baseline.fit, refit.fit.as_ref()?);
    let score = (baseline.fit.q - refit.q + distance * distance) / (2.0 * distance.max(f64::MIN_POSITIVE));
    Some([score, distance])
}

fn is_unseen(distance: f64, unknown: &Unknown, level: f64) -> bool {
    power_at_distance(distance, is_one_sided(unknown), level) < ENOUGH_POWER
}

/// How much better the held-out observables are predicted with an effect.
fn held_out_gain(baseline: &Baseline, refit: Option<&Explanation>) -> Option<f64> {
    let with = held_out_sigma(baseline, &refit?.fit.as_ref()?.predicted)?;
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
            .filter(|(index, _)| judgement.trial(*index).members == [k])
            .find_map(|(_, found)| found.local.as_ref());
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
fn look_alikes(baseline: &Baseline, judgement: &Judgement, k: usize) -> Vec<LookAlike> {
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
    let mut found: Vec<(usize, f64)> = judgement
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
    found
        .into_iter()
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
        let mut power = places.map(|k| baseline.directions.power(k, unknown(baseline, k), level));
        row.place.is_some() && power.any(|power| power >= ENOUGH_POWER)
    };
    let unseen = effects
        .iter()
        .filter(|row| row.power < ENOUGH_POWER && !elsewhere(row));
    unseen.map(|row| row.effect.clone()).collect()
}
