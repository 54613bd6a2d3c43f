//! The next experiment: which of those that a study lists tells the rivals apart best; or, where it lists none, the cheapest that does.
//!
//! Buzzi-Ferraris & Forzatti, Chem. Eng. Sci. 38 (1983) 225: T = Σ πᵢπⱼ (ŷᵢ − ŷⱼ)ᵀ (Vᵢ + Vⱼ)⁻¹ (ŷᵢ − ŷⱼ), V = J C Jᵀ + Σ, here
//! divided by Σ πᵢπⱼ, so that √T is a distance in standard deviations.

use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::progress::Progress;
use crate::study::{Cost, Fit, Forward, Observable, Proposal, Proposals, Unknown, UnknownKind, WarmStart};

use super::error::DiagnoseError;
use super::expected::{Expected, ExpectedReading};
use super::posterior::{SEPARATE, TWINS};

/// What could be measured next.
#[derive(Clone, Copy)]
pub enum Experiments<'a> {
    /// Nothing is known of that.
    Unknown,
    /// The conditions of a model with unknowns of the same names, whose observables state the noise that is to be expected.
    Listed(&'a dyn Forward),
    /// What can be added to any study.
    Proposed(&'a Proposals<'a>),
}

/// What to measure next.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NextExperiment {
    /// Best candidate; none if no candidate tells the rivals apart.
    pub best: Option<String>,
    /// All candidates, best first.
    pub candidates: Vec<Candidate>,
    /// The advice in one sentence.
    pub sentence: String,
}

/// One candidate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Candidate {
    /// Name of its condition; of what a study does not list, what to do in plain words.
    pub name: String,
    /// Head of the column that holds it in a table of readings; none where it is one more station of a column that is there.
    #[serde(default)]
    pub column: Option<String>,
    /// Distance expected between the rivals, in standard deviations.
    pub separation_sigma: f64,
    /// What the two most probable rivals predict for the reading of it that tells them apart best; none where it has no reading.
    #[serde(default)]
    pub expected: Option<ExpectedReading>,
}

/// A rival explanation with its probability.
pub struct Rival<'a> {
    /// Its name.
    pub name: String,
    /// Its probability.
    pub probability: f64,
    /// Its fit.
    pub fit: &'a Fit,
    /// Factor on the fit's covariance for the scale of the noise.
    pub variance: f64,
}

/// Scores the experiments; those that no study lists by rising cost, and no further than where some tell the rivals apart. Besides: which
/// were left out, and why. `is_decided`: whether the verdict stands without them.
///
/// # Errors
/// If a listed experiment has no solution, or the user asked to stop.
pub fn next_experiment(
    forward: &dyn Forward,
    experiments: Experiments,
    rivals: &[Rival],
    is_decided: bool,
    progress: &Progress,
) -> Result<(Option<NextExperiment>, Vec<String>), DiagnoseError> {
    if rivals.len() < 2 {
        return Ok((None, Vec::new()));
    }
    let (mut found, left_out) = match experiments {
        Experiments::Unknown => return Ok((None, Vec::new())),
        Experiments::Listed(listed) => (listed_ones(forward, listed, rivals, progress)?, Vec::new()),
        Experiments::Proposed(proposals) => proposed_ones(forward, proposals, rivals, progress)?,
    };
    found.sort_by(|a, b| {
        b.separation_sigma
            .total_cmp(&a.separation_sigma)
            .then_with(|| a.name.cmp(&b.name))
    });
    let best = found
        .first()
        .filter(|candidate| candidate.separation_sigma >= SEPARATE);
    let is_listed = matches!(experiments, Experiments::Listed(_));
    if !is_listed && best.is_none() && (is_decided || found.is_empty()) {
        return Ok((None, left_out));
    }
    let next = NextExperiment {
        best: best.map(|candidate| candidate.name.clone()),
        sentence: sentence(&found, is_listed, is_decided),
        candidates: found,
    };
    Ok((Some(next), left_out))
}

impl NextExperiment {
    /// Says how a table holds what is asked for, if it is measured on a bench.
    pub fn for_table(&mut self, table: &str) {
        // the best one, or the one that comes nearest
        let first = self.candidates.first();
        if let Some(column) = first.and_then(|own| own.column.as_ref()) {
            self.sentence += &format!(" In {table} it is one more column: {column}.");
        }
    }
}

/// The advice of candidates, best first.
fn sentence(candidates: &[Candidate], is_listed: bool, is_decided: bool) -> String {
    let Some(Candidate {
        name,
        separation_sigma,
        expected,
        ..
    }) = candidates.first()
    else {
        return "No candidate experiment was listed.".into();
    };
    let expected = expected
        .as_ref()
        .map_or(String::new(), |own| format!(" {}.", own.words()));
    let second = candidates.get(1).filter(|own| own.separation_sigma >= TWINS);
    let second = second.map_or(String::new(), |own| {
        format!(" ({:.1} for {}, the next best)", own.separation_sigma, own.name)
    });
    match (*separation_sigma >= SEPARATE, is_listed, is_decided) {
        (true, ..) => format!(
            "Measure {name} next: the rivals are expected {separation_sigma:.1} standard deviations apart there{second}.{expected}"
        ),
        (false, true, false) => format!(
            "No listed experiment can tell these apart; the best, {name}, puts them {separation_sigma:.1} standard deviations apart."
        ),
        (false, true, true) => format!(
            "No experiment is asked for. Of those listed, {name} would set what else is possible farthest apart, by \
             {separation_sigma:.1} standard deviations."
        ),
        (false, false, _) => format!(
            "None of the readings that could be added decides between these; the nearest to it, {name}, puts them \
             {separation_sigma:.1} standard deviations apart, where {SEPARATE} are needed."
        ),
    }
}

/// Every condition of a model.
fn listed_ones(
    forward: &dyn Forward,
    listed: &dyn Forward,
    rivals: &[Rival],
    progress: &Progress,
) -> Result<Vec<Candidate>, DiagnoseError> {
    let mut answers: Vec<Answer> = Vec::new();
    for rival in rivals {
        progress.check()?;
        progress.say("what the rivals predict for candidate experiments");
        answers.push(answer(forward, listed, rival, None)?.0);
    }
    let observables = listed.observables();
    let of = |(index, name): (usize, &String)| {
        let counts = |own: &Observable| own.condition == index;
        Candidate {
            name: name.clone(),
            column: None,
            separation_sigma: separation(&answers, rivals, observables, &counts),
            expected: expected(&answers, rivals, observables, &counts),
        }
    };
    let names = listed.conditions().iter().map(|condition| &condition.name);
    Ok(names.enumerate().map(of).collect())
}

/// What could be added to a study, up to the cost at which something tells the rivals apart; and what has no solution.
fn proposed_ones(
    forward: &dyn Forward,
    proposals: &Proposals,
    rivals: &[Rival],
    progress: &Progress,
) -> Result<(Vec<Candidate>, Vec<String>), DiagnoseError> {
    let (mut found, mut left_out): (Vec<Candidate>, Vec<String>) = (Vec::new(), Vec::new());
    for cost in Cost::ALL {
        progress.check()?;
        progress.say("which further reading would tell the rivals apart");
        let of_cost: Vec<&Proposal> = proposals.all.iter().filter(|own| own.cost == cost).collect();
        let scored: Vec<Result<Option<Candidate>, DiagnoseError>> = of_cost
            .into_par_iter()
            .map(|proposal| proposed(forward, proposals, proposal, rivals, progress))
            .collect();
        for scored in scored {
            match scored {
                Ok(candidate) => found.extend(candidate),
                Err(DiagnoseError::Cancelled(cancelled)) => return Err(DiagnoseError::Cancelled(cancelled)),
                Err(error) => left_out.push(format!("Not looked at as a next measurement: {error}")),
            }
        }
        if found.iter().any(|own| own.separation_sigma >= SEPARATE) {
            break;
        }
    }
    Ok((found, left_out))
}

/// A proposal by what tells the rivals apart best of it; none if nothing of it can be read.
fn proposed(
    forward: &dyn Forward,
    proposals: &Proposals,
    proposal: &Proposal,
    rivals: &[Rival],
    progress: &Progress,
) -> Result<Option<Candidate>, DiagnoseError> {
    let campaign = proposals.campaign(proposal, progress)?;
    let (mut answers, mut warm_start): (Vec<Answer>, Option<WarmStart>) = (Vec::new(), None);
    for rival in rivals {
        progress.check()?;
        let from = warm_start.as_ref().map(WarmStart::roughly);
        // what has no solution from there may have one from the case as it stands
        let (told, left) = match answer(forward, &campaign, rival, from.as_ref()) {
            Err(DiagnoseError::Study(_)) if from.is_some() => answer(forward, &campaign, rival, None)?,
            told => told?,
        };
        answers.push(told);
        warm_start = left.or(warm_start);
    }
    let observables = campaign.observables();
    let apart = |rows: &[&Observable]| {
        let counts = |own: &Observable| rows.iter().any(|row| std::ptr::eq(*row, own));
        Candidate {
            name: proposal.words(rows),
            column: proposal.column(),
            separation_sigma: separation(&answers, rivals, observables, &counts),
            expected: expected(&answers, rivals, observables, &counts),
        }
    };
    let all: Vec<&Observable> = observables.iter().collect();
    let sets = all.chunks(match proposal.is_of_one_reading() {
        true => 1,
        false => all.len().max(1),
    });
    let farthest = |a: &Candidate, b: &Candidate| a.separation_sigma.total_cmp(&b.separation_sigma);
    Ok(sets.map(apart).max_by(farthest))
}

/// What a rival predicts for every observable, and its covariance by what the fit leaves open.
type Answer = (DVector<f64>, DMatrix<f64>);

/// How far apart rivals are in the observables that count, in standard deviations.
fn separation(
    answers: &[Answer],
    rivals: &[Rival],
    observables: &[Observable],
    counts: &dyn Fn(&Observable) -> bool,
) -> f64 {
    let rows: Vec<usize> = (0..observables.len())
        .filter(|&row| counts(&observables[row]))
        .collect();
    let noise = DMatrix::from_diagonal(&DVector::from_iterator(
        rows.len(),
        rows.iter().map(|&row| 2.0 * observables[row].sigma.powi(2)),
    ));
    let (mut sum, mut weights) = (0.0, 0.0);
    for i in 0..rivals.len() {
        for j in 0..i {
            let weight = rivals[i].probability * rivals[j].probability;
            let apart = (&answers[i].0 - &answers[j].0).select_rows(rows.iter());
            let spread = |k: usize| answers[k].1.select_rows(rows.iter()).select_columns(rows.iter());
            let Some(factor) = Cholesky::new(spread(i) + spread(j) + &noise) else {
                continue;
            };
            sum += weight * apart.dot(&factor.solve(&apart));
            weights += weight;
        }
    }
    if weights > 0.0 {
        (sum / weights).sqrt()
    } else {
        0.0
    }
}

/// What the first two rivals predict for the reading that tells them apart best.
fn expected(
    answers: &[Answer],
    rivals: &[Rival],
    observables: &[Observable],
    counts: &dyn Fn(&Observable) -> bool,
) -> Option<ExpectedReading> {
    let ([first, second], [a, b, ..]) = (answers.first_chunk()?, rivals) else {
        return None;
    };
    let variance = |answer: &Answer, row: usize| answer.1[(row, row)].max(0.0);
    let apart = |&row: &usize| {
        let spread = variance(first, row) + variance(second, row) + 2.0 * observables[row].sigma.powi(2);
        (first.0[row] - second.0[row]).abs() / spread.sqrt()
    };
    let rows = (0..observables.len()).filter(|&row| counts(&observables[row]));
    let row = rows.max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
    let by = [(a, first), (b, second)].map(|(rival, answer)| Expected {
        rival: rival.name.clone(),
        value: answer.0[row],
        standard_error: variance(answer, row).sqrt(),
    });
    Some(ExpectedReading {
        channel: observables[row].channel,
        r_mm: observables[row].r_mm,
        by: by.into(),
    })
}

/// Prediction of a rival for the candidates, and its covariance; from a warm start, if there is one, and what it leaves.
fn answer(
    forward: &dyn Forward,
    candidates: &dyn Forward,
    rival: &Rival,
    warm_start: Option<&WarmStart>,
) -> Result<(Answer, Option<WarmStart>), DiagnoseError> {
    let (known, own) = (forward.unknowns(), candidates.unknowns());
    let only = on_the_only_wing(candidates);
    let is_same = |known: &Unknown, name: &str| {
        known.name == name || (!only.is_empty() && known.name.strip_suffix(&only) == Some(name))
    };
    // inputs of several wings can have one key: they are told by their priors
    let has_prior = |known: &Unknown, own: &Unknown| (known.mean, known.sigma) == (own.mean, own.sigma);
    let same_as = |own: &Unknown| {
        let free = || {
            rival
                .fit
                .free
                .iter()
                .copied()
                .filter(|&i| is_same(&known[i], &own.name))
        };
        let all = || (0..known.len()).filter(|&i| known[i].name == own.name);
        let of_prior = |&i: &usize| has_prior(&known[i], own);
        let free_one = free().find(of_prior).or_else(|| free().next());
        free_one.or_else(|| all().find(of_prior)).or_else(|| all().next())
    };
    let same: Vec<Option<usize>> = own.iter().map(same_as).collect();
    let at: Vec<f64> = own
        .iter()
        .zip(&same)
        .map(|(own, same)| same.map_or(own.mean, |i| rival.fit.at[i]))
        .collect();
    let is_free = |name: &str| rival.fit.free.iter().any(|&i| is_same(&known[i], name));
    // a nuisance that only the candidate has is as open as its prior leaves it
    let is_new = |unknown: &Unknown| {
        unknown.kind == UnknownKind::Ruler && !known.iter().any(|k| k.name == unknown.name)
    };
    let wanted = |unknown: &Unknown| is_free(&unknown.name) || is_new(unknown);
    let (linear, left) = candidates.linearize_from(warm_start, &at, &wanted)?;
    let place = |i: usize| same.iter().position(|same| *same == Some(i));
    let slopes = DMatrix::from_fn(linear.value.len(), rival.fit.free.len(), |row, k| {
        place(rival.fit.free[k]).map_or(0.0, |column| linear.jacobian[(row, column)])
    });
    let mut covariance = &slopes * &rival.fit.covariance * slopes.transpose() * rival.variance;
    for (column, unknown) in own.iter().enumerate().filter(|(_, u)| is_new(u)) {
        let slope = linear.jacobian.column(column) * unknown.sigma;
        covariance += &slope * slope.transpose();
    }
    Ok(((linear.value, covariance), left))
}

/// How names of unknowns end that act on the wing of all these experiments, if it is one: among those nothing is told by its wing.
fn on_the_only_wing(candidates: &dyn Forward) -> String {
    let wings = candidates
        .conditions()
        .iter()
        .map(|condition| condition.wing.as_str());
    let mut wings: Vec<&str> = wings.collect();
    wings.dedup();
    match wings.as_slice() {
        [wing] => format!(" on {wing}"),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Channel;

    #[test]
    fn the_advice_says_what_to_measure_or_that_nothing_decides() {
        let far = |separation_sigma: f64| {
            vec![Candidate {
                name: "the still wing w under a torque of 0.2 mN·m near its tip (67 mm)".into(),
                column: None,
                separation_sigma,
                expected: Some(ExpectedReading {
                    channel: Channel::Twist,
                    r_mm: Some(67.0),
                    by: [("root-flexure", 9.91, 0.312), ("nothing missing", 7.5, 0.1)]
                        .map(|(rival, value, standard_error)| Expected {
                            rival: rival.into(),
                            value,
                            standard_error,
                        })
                        .into(),
                }),
            }]
        };
        let said = sentence(&far(4.25), false, false);
        assert_eq!(
            said,
            "Measure the still wing w under a torque of 0.2 mN·m near its tip (67 mm) next: the rivals are expected 4.2 standard \
             deviations apart there. root-flexure leads to 9.91 ± 0.312 deg of twist at 67.0 mm, \
             nothing missing to 7.50 ± 0.100."
        );
        assert!(sentence(&far(1.0), true, false).starts_with("No listed experiment can tell these apart"));
        assert!(
            sentence(&far(1.0), false, false).starts_with("None of the readings that could be added decides")
        );
        // where nothing is missing nothing has to be told apart
        for is_listed in [true, false] {
            assert!(!sentence(&far(1.0), is_listed, true).contains("No listed experiment"));
        }
    }
}
