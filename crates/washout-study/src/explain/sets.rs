//! Sets as they are shown: in which order, what their changes and readings are, what they predict, how they are run by hand.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use crate::diagnose::screening::{effect_of, place_of};
use crate::input::measurement::SigmaKind;
use crate::progress::Progress;
use crate::study::{Forward, Observable, UnknownKind};

use super::error::ExplainError;
use super::forecast::{Effort, Forecasts};
use super::grow::InChoice;
use super::prepared::Prepared;
use super::price::of_value;
use super::refit::Solver;
use super::refute::refuting;
use super::report::{ChangeMade, ExplainedSet, Forecast, Otherwise, ReadingOfSet, Status};
use super::scatter::reach;
use super::words;

/// Standard deviations by which a number that was held out contradicts a set.
const CONTRADICTS: f64 = 3.0;

/// Difference of cost up to which two sets are not told apart: odds of 20 to 1.
const ALIKE: f64 = 6.0;

/// What is needed to describe sets.
pub struct Sets<'a> {
    /// The choices.
    pub prepared: &'a [Prepared],
    /// Their models, ready to be fitted.
    pub solvers: &'a [Solver<'a>],
}

/// A set with what it is ranked by.
#[derive(Clone, Copy)]
struct Ranked<'a> {
    status: Status,
    cost: f64,
    set: &'a InChoice,
}

impl Sets<'_> {
    /// Whether some standard deviation is assumed.
    pub fn is_assumed(&self) -> bool {
        let solver = &self.solvers[0];
        solver
            .rows
            .iter()
            .any(|&row| solver.model.kinds()[row] == SigmaKind::Assumed)
    }

    /// By what a set is known: words and alternatives, keys of its changes.
    pub fn key(&self, set: &InChoice) -> Vec<String> {
        let flipped = self.prepared[set.choice]
            .choice
            .flipped
            .iter()
            .map(|own| own.name.clone());
        let changes = set.solved.changes.iter();
        let mut keys: Vec<String> = flipped
            .chain(changes.map(|&own| self.solvers[set.choice].changes[own].key.clone()))
            .collect();
        keys.sort();
        keys
    }

    fn cost(&self, set: &InChoice, factor: f64) -> f64 {
        let fit = self.solvers[set.choice].fit(&set.solved.read, factor);
        fit + set.solved.values + set.solved.price
    }

    pub fn status(&self, set: &InChoice, factor: f64) -> Status {
        let solver = &self.solvers[set.choice];
        let far = reach(solver.rows.len()) * factor;
        let misfits = solver.misfits(&set.solved.read);
        if misfits.iter().any(|misfit| misfit.abs() > far) {
            return Status::FallsShort;
        }
        let observables = solver.model.observables();
        let is_against = |row: usize| {
            let own = &observables[row];
            let misfit = own.misfit(set.solved.read[row]) / own.sigma;
            !solver.rows.contains(&row) && misfit.abs() > CONTRADICTS * factor
        };
        match (0..observables.len()).any(is_against) {
            true => Status::Refuted,
            false => Status::Reaches,
        }
    }

    /// One set of each families, of which none is better with one change less. Those that reach come first: of those that are [`ALIKE`]
    /// the one of fewest changes, then by cost.
    pub fn ordered(&self, sets: &[InChoice], factor: f64) -> Vec<InChoice> {
        let mut best: BTreeMap<Vec<String>, Ranked> = BTreeMap::new();
        for set in sets {
            let status = self.status(set, factor);
            let solved = &set.solved;
            let own = Ranked {
                status,
                cost: match status {
                    // how near it comes: with standard deviations that forgive, nothing would seem far
                    Status::FallsShort => solved.as_stated() + solved.chi_square * (factor.powi(-2) - 1.0),
                    _ => self.cost(set, factor),
                },
                set,
            };
            let known = best.entry(self.key(set)).or_insert(own);
            if (own.status, own.cost) < (known.status, known.cost) {
                *known = own;
            }
        }
        let is_minimal = |(key, own): &(&Vec<String>, &Ranked)| {
            !best.iter().any(|(smaller, other)| {
                let is_part = smaller.len() < key.len() && smaller.iter().all(|part| key.contains(part));
                is_part && other.status <= own.status && other.cost <= own.cost
            })
        };
        let mut minimal: Vec<Ranked> = best.iter().filter(is_minimal).map(|own| *own.1).collect();
        let reaching = minimal.iter().filter(|own| own.status == Status::Reaches);
        let least = reaching.map(|own| own.cost).fold(f64::INFINITY, f64::min);
        let place = |own: &Ranked| match own.status == Status::Reaches && own.cost <= least + ALIKE {
            true => (own.status, self.key(own.set).len()),
            false => (own.status, usize::MAX),
        };
        minimal.sort_by(|a, b| place(a).cmp(&place(b)).then(a.cost.total_cmp(&b.cost)));
        minimal.into_iter().map(|own| own.set.clone()).collect()
    }

    /// Mean square of all misfits, fitted or held out, in standard deviations.
    pub fn mean_square(&self, set: &InChoice) -> f64 {
        let observables = self.solvers[set.choice].model.observables();
        let square =
            |(row, own): (usize, &Observable)| (own.misfit(set.solved.read[row]) / own.sigma).powi(2);
        observables.iter().enumerate().map(square).sum::<f64>() / observables.len().max(1) as f64
    }

    /// A set with all that is said of it but what it predicts.
    pub fn set(&self, set: &InChoice) -> ExplainedSet {
        let solver = &self.solvers[set.choice];
        let otherwise: Vec<Otherwise> = self.prepared[set.choice]
            .choice
            .flipped
            .iter()
            .map(|own| Otherwise {
                name: own.name.clone(),
                probability: own.probability,
                why: own.why.clone(),
            })
            .collect();
        let changes: Vec<ChangeMade> = set
            .solved
            .changes
            .iter()
            .map(|&own| self.change(set, own))
            .collect();
        let misfits = solver.misfits(&set.solved.read);
        ExplainedSet {
            name: words::name(&otherwise, &changes),
            status: self.status(set, 1.0),
            cost: set.solved.cost(),
            fit: set.solved.fit,
            values: set.solved.values,
            price: set.solved.price,
            chi_square: set.solved.chi_square,
            within_one_sigma: misfits.iter().filter(|misfit| misfit.abs() <= 1.0).count(),
            worst_sigma: misfits.iter().fold(0.0, |worst, misfit| misfit.abs().max(worst)),
            probability: None,
            rank_at_twice_sigma: None,
            otherwise,
            changes,
            readings: self.readings(set),
            forecasts: Vec::new(),
            refute: Vec::new(),
            by_hand: self.by_hand(set),
        }
    }

    fn change(&self, set: &InChoice, position: usize) -> ChangeMade {
        let solver = &self.solvers[set.choice];
        let unknowns = solver.model.unknowns();
        let own = &solver.changes[position];
        let unknown = &unknowns[own.unknown];
        let (value, stated) = (set.solved.at[own.unknown], solver.model.start()[own.unknown]);
        let place = place_of(unknowns, own.unknown);
        let mut numbers: BTreeMap<String, f64> = BTreeMap::new();
        let mut wings: Vec<String> = Vec::new();
        let mut place_cost = 0.0;
        if let Some(place) = place
            && let UnknownKind::Place {
                parameter,
                numbers: others,
                wing,
                ..
            } = &unknowns[place].kind
        {
            numbers.insert(parameter.clone(), set.solved.at[place]);
            numbers.extend(others.iter().map(|(name, value)| (name.clone(), *value)));
            wings.extend(wing.clone());
            place_cost = of_value(&unknowns[place], set.solved.at[place]);
        }
        let effect = effect_of(unknown).map(|own| own.0.to_string());
        if effect.is_none() {
            wings = self.wings_of(set.choice, own.unknown);
        }
        let end = if value < stated {
            unknown.range[0]
        } else {
            unknown.range[1]
        };
        ChangeMade {
            name: effect.clone().unwrap_or_else(|| unknown.name.clone()),
            unknown: unknown.name.clone(),
            is_effect: effect.is_some(),
            wings,
            numbers,
            value,
            stated,
            unit: unknown.unit.clone(),
            range: unknown.range,
            into_range: if end == stated {
                1.0
            } else {
                (value - stated) / (end - stated)
            },
            cost: of_value(unknown, value) + place_cost,
            price: own.price,
        }
    }

    /// The wings whose design a number changes, if not all.
    fn wings_of(&self, choice: usize, unknown: usize) -> Vec<String> {
        let model = self.solvers[choice].model;
        let mut at = model.start();
        let [low, high] = model.unknowns()[unknown].range;
        at[unknown] = if at[unknown] == low { high } else { low };
        let campaign = model.campaign();
        let (mut touched, mut all): (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
        for (case, condition) in campaign.conditions().iter().enumerate() {
            if !all.contains(&condition.wing) {
                all.push(condition.wing.clone());
            }
            if !campaign.changes_at(case, &at).is_empty() && !touched.contains(&condition.wing) {
                touched.push(condition.wing.clone());
            }
        }
        if touched.len() == all.len() {
            Vec::new()
        } else {
            touched
        }
    }

    fn readings(&self, set: &InChoice) -> Vec<ReadingOfSet> {
        let solver = &self.solvers[set.choice];
        let conditions = solver.model.conditions();
        let reading = |(row, own): (usize, &Observable)| ReadingOfSet {
            case: conditions[own.condition].name.clone(),
            channel: own.channel,
            r_mm: own.r_mm,
            r_to_mm: own.r_to_mm,
            measured: own.value,
            sigma: own.sigma,
            bound: own.bound,
            is_held_out: conditions[own.condition].is_held_out,
            stated: solver.base[row],
            with_set: set.solved.read[row],
            misfit_sigma: own.misfit(set.solved.read[row]) / own.sigma,
        };
        solver
            .model
            .observables()
            .iter()
            .enumerate()
            .map(reading)
            .collect()
    }

    /// For each case that was fitted, the command that runs the set again.
    fn by_hand(&self, set: &InChoice) -> Vec<String> {
        let study = &self.prepared[set.choice].choice.study;
        let campaign = self.solvers[set.choice].model.campaign();
        let mut commands: Vec<String> = Vec::new();
        for (index, case) in study
            .cases
            .iter()
            .enumerate()
            .filter(|(_, case)| !case.is_held_out)
        {
            let mut command = format!("washout compare {}", case.loaded.path.display());
            let changes = campaign.changes_at(index, &set.solved.at);
            let sets = case.sets.iter().cloned();
            for set in sets.chain(changes.into_iter().map(|(key, value)| format!("{key}={value}"))) {
                command.push_str(&match set.contains(['"', ' ', '[']) {
                    true => format!(" --set '{set}'"),
                    false => format!(" --set {set}"),
                });
            }
            command.push_str(&format!(" --with {} --case {}", case.measurement, case.name));
            if !commands.contains(&command) {
                commands.push(command);
            }
        }
        commands
    }

    /// What the shown sets predict, and what would refute each; gives what no model has an answer to.
    pub fn predict(
        &self,
        shown: &[InChoice],
        sets: &mut [ExplainedSet],
        names: &[&str],
        progress: &Progress,
    ) -> Result<Vec<String>, ExplainError> {
        let mut of_choice: BTreeMap<usize, Forecasts> = BTreeMap::new();
        let mut left_out: Vec<String> = Vec::new();
        for own in shown {
            let Entry::Vacant(vacant) = of_choice.entry(own.choice) else {
                continue;
            };
            progress.check()?;
            let study = &self.prepared[own.choice].choice.study;
            let forecasts = vacant.insert(Forecasts::new(study, names, progress)?);
            for reason in &forecasts.left_out {
                let words = format!("Not predicted: {reason}");
                if !left_out.contains(&words) {
                    left_out.push(words);
                }
            }
        }
        let Some(first) = shown.first().map(|own| &of_choice[&own.choice]) else {
            return Ok(left_out);
        };
        let effort: Vec<Effort> = first.possible.iter().map(|own| own.effort).collect();
        let mut predicted: Vec<Vec<Forecast>> = Vec::new();
        for own in shown {
            progress.check()?;
            let forecasts = of_choice[&own.choice].at(self.solvers[own.choice].model, &own.solved.at);
            let alike = first.possible.iter().map(|possible| {
                let is_it = |forecast: &&Forecast| {
                    (&forecast.condition, forecast.channel, forecast.r_mm)
                        == (&possible.condition, possible.row.channel, possible.row.r_mm)
                };
                forecasts.iter().find(is_it).cloned().unwrap_or_else(|| Forecast {
                    condition: possible.condition.clone(),
                    channel: possible.row.channel,
                    r_mm: possible.row.r_mm,
                    sigma: possible.row.sigma,
                    stated: None,
                    with_set: None,
                })
            });
            predicted.push(alike.collect());
        }
        for (place, set) in sets.iter_mut().enumerate() {
            set.refute = refuting(place, &predicted, &effort);
            set.forecasts.clone_from(&predicted[place]);
        }
        Ok(left_out)
    }
}
