//! From what was weighed to what is said.

use nalgebra::{DMatrix, DVector};

use crate::progress::Progress;
use crate::study::Fit;

use super::added_variable::added_variable;
use super::baseline::Baseline;
use super::bump::Around;
use super::effect_row::{LOOK_ALIKES, LookAlike, effect_rows, unseen};
use super::error::DiagnoseError;
use super::gains::Gains;
use super::hypothesis::{Hypothesis, hypothesis};
use super::judge::Judgement;
use super::ladder::{Explained, ladder};
use super::misfit;
use super::naming::verdict;
use super::next::{Experiments, NextExperiment, Rival, next_experiment};
use super::notes::notes;
use super::novel::reconstruct;
use super::novel_words::draft;
use super::posterior::{Belief, Case};
use super::refit::Explanation;
use super::strengths::name;
use super::verdict::{Diagnosis, NoiseFound, Novel, Outlier, Prediction, Verdict};
use super::words::sentence;

/// Sigmas by which a case must miss to be asked for, and those of every other over its. A choice: it changes no probability.
const FAR_OFF: f64 = 10.0;
const ALONE: f64 = 0.3;
/// Hypotheses less probable than this are not listed.
const LISTED: f64 = 1e-3;
/// Probability of a named effect, with a second or none, from which on nothing is proposed to measure next.
const SURE: f64 = 0.95;
/// The same of nothing. Assumed, as that is.
const SURELY_NOTHING: f64 = 0.85;
/// Rivals that the next experiment is to tell apart.
const RIVALS: usize = 5;

/// Puts the diagnosis together.
///
/// # Errors
/// If the model fails at held-out cases or listed experiments, or the user asked to stop.
pub fn report(
    baseline: &Baseline,
    judgement: &Judgement,
    experiments: Experiments,
    progress: &Progress,
) -> Result<Diagnosis, DiagnoseError> {
    let gains = Gains::new(baseline);
    let hypotheses: Vec<Hypothesis> = judgement
        .beliefs
        .iter()
        .filter(|belief| belief.in_set || belief.probability > LISTED)
        .map(|belief| hypothesis(baseline, judgement, &gains, belief))
        .collect();
    let effects = effect_rows(baseline, judgement, &gains);
    let mut unseen: Vec<String> = unseen(baseline, &effects);
    // beside another effect it may be seen after all
    unseen.retain(|name| {
        !hypotheses
            .iter()
            .any(|own| own.in_set && own.effects.contains(name))
    });
    let (verdict, why_not_named) = verdict(baseline, judgement, &effects, &hypotheses);
    let added = judgement
        .beliefs
        .iter()
        .filter_map(|belief| match belief.case {
            Case::One(family) => judgement.best_of(&[family]),
            _ => None,
        })
        .take(LOOK_ALIKES)
        .map(|(index, _)| {
            let k = judgement.trials[index].members[0];
            added_variable(baseline, k, &name(baseline, k))
        });
    let (next_experiment, left_out) = next(baseline, judgement, (experiments, verdict), progress)?;
    let mut diagnosis = Diagnosis {
        sentence: String::new(),
        check_first: None,
        verdict,
        p_nothing: judgement.probability(&Case::Nothing),
        tried: effects.len(),
        noise: noise_found(baseline),
        novel: novel(baseline, judgement)?,
        unseen,
        misfit: misfit::of(baseline),
        added_variables: added.collect(),
        ladder: ladder(baseline, &steps(baseline, judgement)),
        predictions: predictions(baseline, found(judgement))?,
        next_experiment,
        notes: [
            why_not_named.into_iter().collect(),
            notes(baseline, judgement),
            left_out,
        ]
        .concat(),
        screening: baseline.screening,
        hypotheses,
        effects,
    };
    // a load that is not what the study says is sooner to be thought of than a cause that nobody knows, which can take it up as calibration can
    let modelled = match (verdict, found(judgement)) {
        (Verdict::Novel, _) => &baseline.raw,
        (_, found) => &found.unwrap_or(&baseline.fit).predicted,
    };
    let alone = alone_in_missing(baseline, modelled);
    diagnosis.sentence = sentence(&diagnosis);
    if let Some((case, words)) = alone {
        diagnosis.sentence = format!("{words} {}", diagnosis.sentence);
        diagnosis.check_first = Some(case);
    }
    Ok(diagnosis)
}

/// The one case that misses by far more than all others, and still does with what was found, and what to say of it: so it does where its load
/// or unit is not what the study says.
fn alone_in_missing(baseline: &Baseline, modelled: &DVector<f64>) -> Option<(String, String)> {
    let even_so = farthest(baseline, modelled)?;
    let is_alone = |[(worst, _), (next, _)]: &[(f64, usize); 2]| *next < ALONE * worst;
    // a fit may spread the misfit over all
    let both = [even_so, farthest(baseline, &baseline.fit.predicted)?];
    let [(worst, condition), (next, _)] = both.into_iter().find(is_alone)?;
    let name = &baseline.forward.conditions()[condition].name;
    (even_so[0].0 > FAR_OFF).then(|| {
        let words = format!(
            "Check the case {name} first: it misses by {worst:.0} sigma, every other by at most {next:.1}; are its load, its unit and its sign \
             those of the measurement? If not, what follows means nothing."
        );
        (name.clone(), words)
    })
}

/// The two cases that miss most: by how many stated sigmas, root mean square, and which they are.
fn farthest(baseline: &Baseline, modelled: &DVector<f64>) -> Option<[(f64, usize); 2]> {
    let observables = baseline.forward.observables();
    let rms = |positions: &[usize]| {
        let squares = positions.iter().map(|&position| {
            let row = baseline.data.rows[position];
            (observables[row].misfit(modelled[row]) / observables[row].sigma).powi(2)
        });
        (squares.sum::<f64>() / positions.len() as f64).sqrt()
    };
    let groups = baseline.data.conditions(baseline.forward).into_iter();
    let mut each: Vec<(f64, usize)> = groups.map(|(condition, own)| (rms(&own), condition)).collect();
    each.sort_by(|a, b| b.0.total_cmp(&a.0));
    match each[..] {
        [worst, next, ..] => Some([worst, next]),
        _ => None,
    }
}

fn best_known(judgement: &Judgement) -> Option<&Explanation> {
    judgement.best_of(&judgement.best_known()?.case.families())?.1
}

/// The fit with what was found: the best known explanation, or the cause without a name where that is the verdict.
fn found(judgement: &Judgement) -> Option<&Fit> {
    match judgement.best_bump().filter(|_| judgement.is_unknown()) {
        Some(bump) => Some(&bump.fit),
        None => best_known(judgement).map(|known| &known.fit),
    }
}

/// The best single effect of the best known explanation, then that explanation; of a cause without a name, its fit.
fn steps<'a>(baseline: &Baseline, judgement: &'a Judgement) -> Vec<Explained<'a>> {
    if let Some(bump) = judgement.best_bump().filter(|_| judgement.is_unknown()) {
        return vec![Explained {
            name: bump.kind.name().to_string(),
            fit: &bump.fit,
            local: Some(&bump.local),
        }];
    }
    let Some(known) = judgement.best_known() else {
        return Vec::new();
    };
    let families = known.case.families();
    let fitted = |families: &[usize]| match judgement.best_of(families) {
        Some((index, Some(explanation))) => Some((&judgement.trials[index], explanation)),
        _ => None,
    };
    let explained = |name: String, explanation: &'a Explanation| Explained {
        name,
        fit: &explanation.fit,
        local: Some(&explanation.local),
    };
    let names = |members: &[usize]| {
        let names: Vec<String> = members.iter().map(|&k| name(baseline, k)).collect();
        names.join(" + ")
    };
    let Some((trial, whole)) = fitted(&families) else {
        return Vec::new();
    };
    let halves = families.iter().filter_map(|&family| fitted(&[family]));
    let half = halves
        .max_by(|a, b| a.0.ln_weight.total_cmp(&b.0.ln_weight))
        .filter(|_| families.len() == 2);
    match half {
        Some((first, half)) => {
            let is_other = |k: &&usize| !baseline.families[first.families[0]].members.contains(k);
            let second: Vec<usize> = trial.members.iter().filter(is_other).copied().collect();
            vec![
                explained(names(&first.members), half),
                explained(names(&second), whole),
            ]
        }
        None => vec![explained(names(&trial.members), whole)],
    }
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
        scale: baseline.size.scale,
        formulation: baseline.size.share,
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
    let around = judgement
        .best_bump()
        .map(|bump| Around::new(baseline, bump))
        .transpose()?;
    let is_wanted = judgement.is_unknown();
    let reconstruction = is_wanted
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
        probability: judgement.probability(&Case::Unknown),
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
            let formulation = baseline.size.share * fit.predicted[row];
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
                standard_deviation: (spread.max(0.0) + formulation * formulation).sqrt(),
            }
        })
        .collect())
}

/// What a hypothesis is called where it competes with others.
fn rival_name(baseline: &Baseline, judgement: &Judgement, belief: &Belief) -> String {
    match belief.case {
        Case::Nothing => "nothing missing".to_string(),
        Case::Unknown => "an unknown cause".to_string(),
        _ => {
            let trial = judgement.best_of(&belief.case.families());
            let members = trial.map_or(&[][..], |(index, _)| &judgement.trials[index].members);
            let names: Vec<String> = members.iter().map(|&k| name(baseline, k)).collect();
            names.join(" + ")
        }
    }
}

fn next(
    baseline: &Baseline,
    judgement: &Judgement,
    (experiments, verdict): (Experiments, Verdict),
    progress: &Progress,
) -> Result<(Option<NextExperiment>, Vec<String>), DiagnoseError> {
    let families = judgement.beliefs.first().map(|first| first.case.families());
    let has_first = |belief: &&Belief| {
        let mut families = families.iter().flatten();
        families.all(|own| belief.case.families().contains(own))
    };
    let fit_of = |belief: &Belief| match belief.case {
        Case::Nothing => Some(&baseline.fit),
        Case::Unknown => judgement.best_bump().map(|bump| &bump.fit),
        _ => judgement
            .best_of(&belief.case.families())
            .and_then(|(_, explanation)| Some(&explanation?.fit)),
    };
    // a second effect beside the first is no rival of it while something else may stand in its place
    let in_set = || judgement.beliefs.iter().filter(|belief| belief.in_set);
    let has_other = in_set().any(|belief| !has_first(&belief) && fit_of(belief).is_some());
    let mut rivals: Vec<Rival> = Vec::new();
    for (rank, belief) in in_set().enumerate() {
        if rank > 0 && has_other && has_first(&belief) {
            continue;
        }
        rivals.extend(fit_of(belief).map(|fit| Rival {
            name: rival_name(baseline, judgement, belief),
            probability: belief.probability,
            fit,
            variance: baseline.likelihood.variance(fit.q),
        }));
    }
    rivals.truncate(RIVALS);
    let with_first = judgement.beliefs.iter().filter(has_first);
    let is_sure = match verdict {
        Verdict::Effect => with_first.map(|own| own.probability).sum::<f64>() > SURE,
        Verdict::Nothing => judgement.probability(&Case::Nothing) > SURELY_NOTHING,
        _ => false,
    };
    let is_decided = matches!(verdict, Verdict::Nothing | Verdict::Effect);
    let experiments = match experiments {
        Experiments::Proposed(_) if is_sure => Experiments::Unknown,
        experiments => experiments,
    };
    next_experiment(baseline.forward, experiments, &rivals, is_decided, progress)
}
