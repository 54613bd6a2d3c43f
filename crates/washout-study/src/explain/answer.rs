//! From a search to an answer: which sets are shown.

use crate::progress::Progress;

use super::changes::changes;
use super::error::ExplainError;
use super::grow::{InChoice, searched};
use super::prepared::Prepared;
use super::price::{Prices, of_alternative};
use super::refit::{Solver, fitted};
use super::report::{Explanation, Status, Tried};
use super::scatter::reach;
use super::sets::Sets;
use super::settings::Settings;
use super::words;

/// Sets that are shown of those that are refuted, and of those that fall short, where others reach.
const SHOWN_OF_OTHERS: usize = 3;

/// The least implausible sets of changes; `names`: the effects that may act.
///
/// # Errors
/// If the model has no solution as it stands, or the user asked to stop.
pub fn explain(
    prepared: &[Prepared],
    names: &[&str],
    settings: &Settings,
    progress: &Progress,
) -> Result<Explanation, ExplainError> {
    let (solvers, prices) = solvers(prepared)?;
    let flipped: Vec<usize> = prepared.iter().map(|own| own.choice.flipped.len()).collect();
    let found = searched(&solvers, &flipped, settings, progress)?;
    let described = Sets {
        prepared,
        solvers: &solvers,
    };
    let now = described.ordered(&found.sets, 1.0);
    let doubled = described.ordered(&found.sets, 2.0);
    let is_assumed = described.is_assumed();
    let weights = found.sets.iter().map(|own| (-0.5 * own.solved.cost()).exp());
    let all: f64 = weights.sum();
    let shown = shown(&described, &now, settings);
    let mut sets = Vec::new();
    for own in &shown {
        let mut set = described.set(own);
        let is_it = |other: &InChoice| described.key(other) == described.key(own);
        set.rank_at_twice_sigma = doubled.iter().position(is_it).map(|rank| rank + 1);
        set.probability = (!is_assumed).then(|| (-0.5 * set.cost).exp() / all);
        sets.push(set);
    }
    progress.say("what the sets predict");
    let left_out = match settings.predicts {
        true => described.predict(&shown, &mut sets, names, progress)?,
        false => Vec::new(),
    };
    let numbers = solvers.first().map_or(0, |solver| solver.rows.len());
    let empty = InChoice {
        choice: 0,
        solved: solvers[0].empty(),
    };
    let first = doubled
        .first()
        .map_or(String::new(), |own| described.set(own).name);
    let best = shown.first().map_or(0.0, |own| described.mean_square(own));
    let mut notes = words::notes(numbers, is_assumed);
    notes.extend(words::unfitted(
        shown.iter().filter(|own| !own.solved.is_fitted).count(),
    ));
    notes.extend(left_out);
    let not_compared = prepared[0].model.not_compared().into_iter();
    notes.extend(not_compared.map(|own| format!("Not compared: {own}")));
    Ok(Explanation {
        sentence: words::sentence(&sets, numbers, settings.most_changes),
        numbers,
        reach_sigma: reach(numbers),
        tried: Tried {
            families: prices.families(),
            strengths: solvers[0].changes.len() - prices.numbers(),
            inputs: prices.numbers(),
            alternatives: alternatives(prepared),
            weighed: found.weighed,
            solved: found.sets.len(),
            unsolved: found.unsolved,
        },
        chi_square_per_number: [described.mean_square(&empty), best],
        at_twice_sigma: words::at_twice_sigma(&sets, &first),
        sets,
        notes,
    })
}

/// The sets that are shown.
fn shown(described: &Sets, ordered: &[InChoice], settings: &Settings) -> Vec<InChoice> {
    let of = |status: Status| {
        ordered
            .iter()
            .filter(move |own| described.status(own, 1.0) == status)
    };
    let reach: Vec<InChoice> = of(Status::Reaches).take(settings.shown).cloned().collect();
    let others = if reach.is_empty() {
        settings.shown
    } else {
        SHOWN_OF_OTHERS
    };
    let refuted: Vec<InChoice> = of(Status::Refuted).take(others).cloned().collect();
    let others = if reach.is_empty() && refuted.is_empty() {
        settings.shown
    } else {
        SHOWN_OF_OTHERS
    };
    let short = of(Status::FallsShort).take(others).cloned();
    reach.into_iter().chain(refuted).chain(short).collect()
}

/// The model of each choice, ready to be fitted; prices of the study as it stands.
fn solvers(prepared: &[Prepared]) -> Result<(Vec<Solver<'_>>, Prices), ExplainError> {
    let mut solvers: Vec<Solver> = Vec::new();
    let mut first: Option<Prices> = None;
    for own in prepared {
        let (changes, prices) = changes(&own.model, &own.answers, &fitted(&own.model));
        let flips = own.choice.flipped.iter().map(of_alternative).sum();
        solvers.push(Solver::new(&own.model, changes, flips)?);
        first.get_or_insert(prices);
    }
    first.map(|prices| (solvers, prices)).ok_or(ExplainError::NoData)
}

/// Names of words and alternatives, each once.
fn alternatives(prepared: &[Prepared]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in prepared
        .iter()
        .flat_map(|own| &own.choice.flipped)
        .map(|own| &own.name)
    {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    names
}
