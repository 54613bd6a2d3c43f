//! Each effect that the model lacks, for the report: its score, its strength, what looks like it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::study::Unknown;

use super::baseline::Baseline;
use super::evidence::ln_sum;
use super::gains::Gains;
use super::judge::Judgement;
use super::ladder::held_out_sigma;
use super::library::Trial;
use super::posterior::Case;
use super::refit::Explanation;
use super::screening::{
    ENOUGH_POWER, MATTERS, Sight, effect_of, family_wise, is_one_sided, power_at_distance, whole_strength,
};
use super::strengths::{PlaceFound, is_plausible, name, place, plausible_range, unknown};

/// Look-alikes listed for each effect.
pub const LOOK_ALIKES: usize = 4;

/// One effect that the model lacks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EffectRow {
    /// The effect.
    pub effect: String,
    /// Its family.
    pub family: String,
    /// The unknown that is its strength.
    pub unknown: String,
    /// Unit of the strength.
    pub unit: String,
    /// Size of strength that is plausible.
    pub scale: f64,
    /// Score: distance from none in standard deviations, what the model can absorb left out.
    pub score: f64,
    /// Strength by one linear step; none where the readings do not feel it.
    pub one_step: Option<f64>,
    /// Its standard error.
    pub one_step_error: Option<f64>,
    /// Strength by a nonlinear fit.
    pub refitted: Option<f64>,
    /// Its standard error.
    pub refitted_error: Option<f64>,
    /// Where it sits, if that was not known: the row is that of its best place.
    pub place: Option<PlaceFound>,
    /// Whether its plausible range lies within two standard errors of that strength (by one step, if not refitted).
    pub plausible: bool,
    /// Strengths that are plausible in nature, in its unit.
    pub plausible_range: [f64; 2],
    /// Distance from none, in standard deviations, that its plausible size has.
    pub detectability: f64,
    /// Probability to see it at its plausible size.
    pub power: f64,
    /// What one glance tells.
    pub sight: Sight,
    /// Logarithm of its evidence against nothing missing.
    pub ln_evidence: f64,
    /// Probability that it alone is what is missing.
    pub probability: f64,
    /// Logarithm of the density that all other cases give to each, with it fitted over without, summed; by the linear model where it
    /// was not refitted; none where only one case is fitted.
    pub gain_left_out_conditions: Option<f64>,
    /// Root mean square error of what is held out (in stated standard deviations), calibrated without it over refitted with it: above
    /// one if it predicts better; none where nothing is held out, all of it is met, or it was not refitted.
    pub held_out_gain: Option<f64>,
    /// Other families that look like it, nearest first.
    pub look_alikes: Vec<LookAlike>,
}

/// An effect that looks like another.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LookAlike {
    /// The other effect.
    pub effect: String,
    /// Cosine of the angle between their signatures, what the model can absorb left out.
    pub cosine: f64,
    /// Distance in standard deviations at the strength found.
    pub separation_sigma: f64,
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
