//! From what was weighed to what is said.

use nalgebra::DMatrix;

use crate::progress::Progress;
use crate::study::{Fit, Forward};

use super::added_variable::added_variable;
use super::baseline::Baseline;
use super::error::DiagnoseError;
use super::far::Far;
use super::hump::Around;
use super::judge::Judgement;
use super::ladder::{Explained, ladder};
use super::misfit;
use super::next::{NextExperiment, Rival, next_experiment};
use super::notes::notes;
use super::novel::reconstruct;
use super::novel_words::draft;
use super::null::are_few;
use super::posterior::{Case, SEPARATE, unfolded};
use super::refit::Explanation;
use super::rows::{
    Gains, LOOK_ALIKES, case_families, effect_rows, hypothesis, is_possible, name, probability, unseen,
};
use super::screening::ENOUGH_POWER;
use super::verdict::{
    Diagnosis, EffectRow, Hypothesis, LookAlike, NoiseFound, Novel, Outlier, Prediction, Verdict,
};
use super::words::sentence;

/// Probability from which on one effect may be named.
const NAMED: f64 = 0.9;
/// Hypotheses less probable than this are not listed.
const LISTED: f64 = 1e-3;
/// Rivals that the next experiment is to tell apart.
const RIVALS: usize = 5;

/// Puts the diagnosis together.
///
/// # Errors
/// If the model fails at held-out cases or candidates, or the user asked to stop.
pub fn report(
    baseline: &Baseline,
    judgement: &Judgement,
    candidates: Option<&dyn Forward>,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    let gains = Gains::new(baseline);
    let hypotheses: Vec<Hypothesis> = unfolded(&judgement.beliefs)
        .iter()
        .filter(|belief| belief.in_set || (belief.is_shown && belief.probability > LISTED))
        .map(|belief| hypothesis(baseline, judgement, &gains, belief))
        .collect();
    let far = Far::new(baseline)?;
    let effects = effect_rows(baseline, judgement, &gains, &far);
    let unseen: Vec<String> = unseen(baseline, &effects);
    let verdict = verdict(baseline, judgement, &effects, &hypotheses);
    let added = judgement
        .beliefs
        .iter()
        .filter_map(|belief| match belief.case {
            Case::One(family) => judgement.best_of(&[family]),
            _ => None,
        })
        .take(LOOK_ALIKES)
        .map(|(index, _)| {
            let k = judgement.trial(index).members[0];
            added_variable(baseline, k, &name(baseline, k))
        });
    let mut diagnosis = Diagnosis {
        sentence: String::new(),
        verdict,
        p_nothing: probability(judgement, &Case::Nothing),
        significance: judgement.significance,
        significance_after: judgement.after_known,
        noise: noise_found(baseline),
        novel: novel(baseline, judgement)?,
        unseen,
        misfit: misfit::of(baseline),
        added_variables: added.collect(),
        ladder: ladder(baseline, &rungs(baseline, judgement)),
        predictions: predictions(baseline, found(judgement))?,
        next_experiment: next(baseline, judgement, candidates, progress)?,
        notes: notes(baseline, judgement, &far.unsolved)?,
        screening: baseline.screening,
        hypotheses,
        effects,
    };
    diagnosis.sentence = sentence(&diagnosis, baseline.settings.significance);
    Ok(diagnosis)
}

fn best_known(judgement: &Judgement) -> Option<&Explanation> {
    let known = judgement
        .beliefs
        .iter()
        .find(|b| matches!(b.case, Case::One(_) | Case::Two(..)))?;
    judgement.best_of(&case_families(&known.case))?.1
}

/// The fit with what was found: the best known explanation, or the cause without a name where that is the verdict.
fn found(judgement: &Judgement) -> Option<&Fit> {
    match judgement.best_hump().filter(|_| judgement.is_novel) {
        Some(hump) => Some(&hump.fit),
        None => best_known(judgement)?.fit.as_ref(),
    }
}

/// The best single effect of the best known explanation, then that explanation; of a cause without a name, its fit.
fn rungs<'a>(baseline: &Baseline, judgement: &'a Judgement) -> Vec<Explained<'a>> {
    if let Some(hump) = judgement.best_hump().filter(|_| judgement.is_novel) {
        return vec![Explained {
            name: hump.kind.name().to_string(),
            fit: &hump.fit,
            local: Some(&hump.local),
        }];
    }
    let known = judgement
        .beliefs
        .iter()
        .find(|b| matches!(b.case, Case::One(_) | Case::Two(..)));
    let Some(known) = known else { return Vec::new() };
    let families = case_families(&known.case);
    let mut rungs: Vec<(String, &Explanation)> = Vec::new();
    let singles = families.iter().filter_map(|&family| {
        let (index, explanation) = judgement.best_of(&[family])?;
        Some((index, explanation?))
    });
    if let Some((index, first)) = singles.min_by(|a, b| a.1.q.total_cmp(&b.1.q)) {
        let own = name(baseline, judgement.trial(index).members[0]);
        rungs.push((own, first));
        if let (2, Some((pair, Some(both)))) = (families.len(), judgement.best_of(&families)) {
            let first_family = judgement.trial(index).families[0];
            let members = &judgement.trial(pair).members;
            let second = members
                .iter()
                .find(|k| !judgement.families[first_family].members.contains(k));
            rungs.extend(second.map(|&k| (name(baseline, k), both)));
        }
    } else if let Some((index, Some(both))) = judgement.best_of(&families) {
        let members = judgement.trial(index).members.iter();
        let names: Vec<String> = members.map(|&k| name(baseline, k)).collect();
        rungs.push((names.join(" + "), both));
    }
    rungs
        .into_iter()
        .filter_map(|(name, explanation)| {
            Some(Explained {
                name,
                fit: explanation.fit.as_ref()?,
                local: explanation.local.as_ref(),
            })
        })
        .collect()
}

fn verdict(
    baseline: &Baseline,
    judgement: &Judgement,
    effects: &[EffectRow],
    hypotheses: &[Hypothesis],
) -> Verdict {
    if judgement.significance.p_null > baseline.settings.significance && !judgement.is_foretold() {
        let could_see = effects.iter().any(|row| row.power >= ENOUGH_POWER);
        let (found, level) = (&judgement.significance, baseline.settings.significance);
        let misses_with_few = are_few(baseline.data.rows.len(), level) && found.p_misfit < level;
        let is_believed = judgement.believes_nothing(baseline);
        return if could_see && is_believed && !misses_with_few && !found.stands_on_few(level) {
            Verdict::Nothing
        } else {
            Verdict::Undecidable
        };
    }
    if judgement.is_novel {
        return Verdict::Novel;
    }
    if judgement.pair_is_accepted
        && hypotheses
            .first()
            .is_some_and(|pair| pair.refitted && is_possible(baseline, pair))
    {
        return Verdict::Pair;
    }
    let Some(belief) = judgement.beliefs.first() else {
        return Verdict::Undecidable;
    };
    if let Case::One(family) = belief.case
        && let Some(first) = hypotheses
            .iter()
            .find(|own| own.families == [judgement.families[family].name.clone()])
    {
        let nearest = (0..judgement.families.len())
            .filter(|&other| other != family)
            .map(|other| judgement.distance(baseline, family, other))
            .fold(f64::INFINITY, f64::min);
        let predicts = first.gain_left_out_conditions.is_none_or(|gain| gain > 0.0);
        if belief.probability >= NAMED && nearest >= SEPARATE && predicts && is_possible(baseline, first) {
            return Verdict::Effect;
        }
    }
    Verdict::Set
}

fn noise_found(baseline: &Baseline) -> NoiseFound {
    let observables = baseline.forward.observables();
    let outliers = baseline
        .data
        .rows
        .iter()
        .zip(&baseline.scatter.widening)
        .filter(|(_, wider)| **wider > 1.0);
    NoiseFound {
        numbers: baseline.data.rows.len(),
        scale: baseline.scatter.scale,
        on_trust: baseline.on_trust(),
        outliers: outliers
            .map(|(&row, &widening)| Outlier {
                condition: baseline.forward.conditions()[observables[row].condition]
                    .name
                    .clone(),
                line: observables[row].line,
                widening,
            })
            .collect(),
    }
}

fn novel(baseline: &Baseline, judgement: &Judgement) -> Result<Novel, DiagnoseError> {
    let is_null = judgement.significance.p_null > baseline.settings.significance;
    let around = judgement
        .best_hump()
        .map(|hump| Around::new(baseline, hump))
        .transpose()?;
    let reconstruction = (!is_null)
        .then(|| reconstruct(baseline, around.as_ref()))
        .flatten();
    let residual = baseline.whitened.q().sqrt().max(f64::MIN_POSITIVE);
    let mut nearest: Vec<LookAlike> = (0..baseline.data.missing.len())
        .map(|k| {
            let cosine = baseline.directions.scores[k] / residual;
            LookAlike {
                effect: name(baseline, k),
                cosine,
                separation_sigma: residual * (1.0 - cosine * cosine).max(0.0).sqrt(),
            }
        })
        .collect();
    nearest.sort_by(|a, b| b.cosine.abs().total_cmp(&a.cosine.abs()));
    let mut names: Vec<String> = Vec::new();
    nearest.retain(|near| {
        let is_new = !names.contains(&near.effect);
        names.push(near.effect.clone());
        is_new
    });
    nearest.truncate(LOOK_ALIKES);
    Ok(Novel {
        probability: probability(judgement, &Case::Novel),
        as_weighed: judgement.novel_as_weighed,
        draft: reconstruction
            .as_ref()
            .and_then(|found| draft(found, baseline.forward.conditions())),
        reconstruction,
        nearest,
    })
}

fn predictions(baseline: &Baseline, found: Option<&Fit>) -> Result<Vec<Prediction>, DiagnoseError> {
    let (forward, data) = (baseline.forward, &baseline.data);
    let fit = found.unwrap_or(&baseline.fit);
    if data.held_out.is_empty() {
        return Ok(Vec::new());
    }
    let free: Vec<&str> = fit
        .free
        .iter()
        .map(|&i| forward.unknowns()[i].name.as_str())
        .collect();
    let linear = forward.linearize(&fit.at, &|unknown| free.contains(&unknown.name.as_str()))?;
    let slopes: DMatrix<f64> = linear.jacobian.select_columns(fit.free.iter());
    let variance = baseline.likelihood.variance(fit.q);
    Ok(data
        .held_out
        .iter()
        .map(|&row| {
            let observable = &forward.observables()[row];
            let slope = slopes.row(row);
            let spread = (slope * &fit.covariance * slope.transpose())[0] * variance;
            let admitted = baseline.settings.slop * fit.predicted[row];
            Prediction {
                condition: forward.conditions()[observable.condition].name.clone(),
                line: observable.line,
                channel: observable.channel,
                unit: observable.channel.unit().to_string(),
                r_mm: observable.r_mm,
                r_to_mm: observable.r_to_mm,
                measured: observable.value,
                calibrated: baseline.fit.predicted[row],
                explained: fit.predicted[row],
                standard_deviation: (spread.max(0.0) + admitted * admitted).sqrt(),
            }
        })
        .collect())
}

fn next(
    baseline: &Baseline,
    judgement: &Judgement,
    candidates: Option<&dyn Forward>,
    progress: &Progress,
) -> Result<Option<NextExperiment>, DiagnoseError> {
    let Some(candidates) = candidates else {
        return Ok(None);
    };
    let mut rivals: Vec<Rival> = Vec::new();
    for belief in judgement.beliefs.iter().filter(|belief| belief.in_set) {
        let fit = match belief.case {
            Case::Nothing => Some(&baseline.fit),
            Case::Novel => judgement.best_hump().map(|hump| &hump.fit),
            _ => judgement
                .best_of(&case_families(&belief.case))
                .and_then(|(_, e)| e?.fit.as_ref()),
        };
        rivals.extend(fit.map(|fit| Rival {
            probability: belief.probability,
            fit,
            variance: baseline.likelihood.variance(fit.q),
        }));
    }
    rivals.truncate(RIVALS);
    if rivals.len() < 2 {
        return Ok(None);
    }
    next_experiment(baseline.forward, candidates, &rivals, progress).map(Some)
}
