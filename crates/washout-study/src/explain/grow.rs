//! The search over all choices: sets of none, one, two, three and four changes, the most promising of each size solved in full.

use std::collections::BTreeMap;

use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::progress::Progress;

use super::error::ExplainError;
use super::refit::{Solved, Solver};
use super::search::{Found, least};
use super::settings::Settings;

/// Sets of the same families in the same choice that are solved in full, at most.
const ALIKE: usize = 3;

/// A set that was solved, and in which choice.
#[derive(Debug, Clone)]
pub struct InChoice {
    /// Position of the choice.
    pub choice: usize,
    /// The set.
    pub solved: Solved,
}

/// What a search gives.
#[derive(Debug)]
pub struct Searched {
    /// All sets that were solved in full.
    pub sets: Vec<InChoice>,
    /// Sets that were weighed by adding up.
    pub weighed: usize,
    /// Sets of which the full model has no solution.
    pub unsolved: usize,
}

/// All sets of up to so many changes; `flipped`: by choice, words and alternatives that are otherwise in it.
///
/// # Errors
/// If the user asked to stop.
pub fn searched(
    solvers: &[Solver],
    flipped: &[usize],
    settings: &Settings,
    progress: &Progress,
) -> Result<Searched, ExplainError> {
    let mut searched = Searched {
        sets: solvers
            .iter()
            .enumerate()
            .map(|(choice, solver)| InChoice {
                choice,
                solved: solver.empty(),
            })
            .collect(),
        weighed: solvers.len(),
        unsolved: 0,
    };
    for size in 1..=settings.most_changes {
        progress.check()?;
        progress.say(format_args!("sets of {size}: adding up"));
        let of_choice = |choice: usize| -> Vec<Found> {
            match flipped[choice] + size <= settings.most_changes {
                true => candidates(&solvers[choice], choice, &searched.sets, size, settings),
                false => Vec::new(),
            }
        };
        let found: Vec<Vec<Found>> = (0..solvers.len()).into_par_iter().map(of_choice).collect();
        searched.weighed += found
            .iter()
            .zip(solvers)
            .map(|(own, solver)| weighed(size, own.len(), solver))
            .sum::<usize>();
        let chosen = chosen(solvers, found, settings.solved);
        progress.say(format_args!("sets of {size}: {} solved", chosen.len()));
        let (chosen, unsolved) = tried(solvers, chosen, settings.fitted, progress)?;
        searched.unsolved += unsolved;
        let solve = |(choice, found): &(usize, Found)| -> Result<Option<InChoice>, ExplainError> {
            progress.check()?;
            let solved = solvers[*choice].solve(found)?;
            Ok(solved.map(|solved| InChoice {
                choice: *choice,
                solved,
            }))
        };
        progress.say(format_args!("sets of {size}: {} fitted", chosen.len()));
        let solved: Result<Vec<Option<InChoice>>, ExplainError> = chosen.par_iter().map(solve).collect();
        searched.sets.extend(solved?.into_iter().flatten());
    }
    Ok(searched)
}

/// The `most` that cost least in the full model as they were found, and how many have no solution in it.
fn tried(
    solvers: &[Solver],
    chosen: Vec<(usize, Found)>,
    most: usize,
    progress: &Progress,
) -> Result<(Vec<(usize, Found)>, usize), ExplainError> {
    let try_one = |(choice, found): &(usize, Found)| -> Result<Option<f64>, ExplainError> {
        progress.check()?;
        solvers[*choice].tried(found)
    };
    let costs: Result<Vec<Option<f64>>, ExplainError> = chosen.par_iter().map(try_one).collect();
    let count = chosen.len();
    let mut solved: Vec<(f64, (usize, Found))> = Vec::new();
    for (cost, own) in costs?.into_iter().zip(chosen) {
        solved.extend(cost.map(|cost| (cost, own)));
    }
    // in the order in which they were chosen where they cost the same
    solved.sort_by(|a, b| a.0.total_cmp(&b.0));
    let unsolved = count - solved.len();
    Ok((solved.into_iter().take(most).map(|own| own.1).collect(), unsolved))
}

/// How many sets were weighed for a size.
fn weighed(size: usize, kept: usize, solver: &Solver) -> usize {
    let count = solver.changes.len();
    match size {
        _ if kept == 0 => 0,
        1 => count,
        2 => count * count.saturating_sub(1) / 2,
        _ => count * kept.min(count),
    }
}

/// The most promising sets of a size in one choice.
fn candidates(
    solver: &Solver,
    choice: usize,
    known: &[InChoice],
    size: usize,
    settings: &Settings,
) -> Vec<Found> {
    let target = solver.target();
    let most = 10 * settings.solved;
    let mut found = match size {
        1 => target.single(&solver.changes),
        2 => target.pairs(&solver.changes, most),
        _ => Vec::new(),
    };
    if size > 1 {
        let mut from: Vec<&Solved> = known
            .iter()
            .filter(|own| own.choice == choice && own.solved.changes.len() + 1 == size)
            .map(|own| &own.solved)
            .collect();
        from.sort_by(|a, b| {
            a.as_stated()
                .total_cmp(&b.as_stated())
                .then_with(|| a.changes.cmp(&b.changes))
        });
        from.truncate(settings.grown);
        let grow = |own: &&Solved| {
            let (members, offset) = solver.as_found(own);
            least(target.grown(&solver.changes, &members, Some(&offset)), most)
        };
        let grown: Vec<Vec<Found>> = from.par_iter().map(grow).collect();
        found.extend(grown.into_iter().flatten());
    }
    least(found, most)
}

/// The least costly of all choices, of each families only a few.
fn chosen(solvers: &[Solver], found: Vec<Vec<Found>>, most: usize) -> Vec<(usize, Found)> {
    let mut all: Vec<(f64, usize, Found)> = Vec::new();
    for (choice, sets) in found.into_iter().enumerate() {
        let flips = solvers[choice].flips;
        all.extend(sets.into_iter().map(|own| (own.cost + flips, choice, own)));
    }
    all.sort_by(|a, b| {
        a.0.total_cmp(&b.0)
            .then_with(|| a.1.cmp(&b.1))
            .then_with(|| a.2.members.cmp(&b.2.members))
    });
    let mut counts: BTreeMap<(usize, Vec<&str>), usize> = BTreeMap::new();
    let mut chosen = Vec::new();
    for (_, choice, own) in all {
        let mut keys: Vec<&str> = own
            .members
            .iter()
            .map(|member| solvers[choice].changes[member.0].key.as_str())
            .collect();
        keys.sort_unstable();
        let count = counts.entry((choice, keys)).or_default();
        *count += 1;
        if *count <= ALIKE {
            chosen.push((choice, own));
        }
        if chosen.len() == most {
            break;
        }
    }
    chosen
}
