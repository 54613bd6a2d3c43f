//! Sets of changes in the full model: fitted, and read.

use nalgebra::DVector;

use crate::diagnose::error::where_solved;
use crate::diagnose::screening::{place_of, whole_strength};
use crate::input::measurement::Bound;
use crate::study::{Discrepancy, Forward, Noise, Task, WarmStart, calibrate};

use super::changes::Change;
use super::error::ExplainError;
use super::model::Model;
use super::price::of_value;
use super::scatter::Scatter;
use super::search::{Found, Target};

/// Digits of the values of a set: so that it can be run again by hand.
const DIGITS: i32 = 4;

/// A model in one choice, ready to be fitted.
#[derive(Debug)]
pub struct Solver<'a> {
    /// The model.
    pub model: &'a Model,
    /// Observables that are fitted.
    pub rows: Vec<usize>,
    /// Its single changes.
    pub changes: Vec<Change>,
    /// Scatter of the fitted readings.
    pub scatter: Scatter,
    /// What the words and alternatives cost that are otherwise.
    pub flips: f64,
    /// What the model reads as it stands, all observables.
    pub base: DVector<f64>,
    noise: Noise,
    warm_start: Option<WarmStart>,
}

/// A set of changes in the full model.
#[derive(Debug, Clone)]
pub struct Solved {
    /// Positions of its changes, in ascending order.
    pub changes: Vec<usize>,
    /// Values of all unknowns.
    pub at: Vec<f64>,
    /// What the model reads, all observables.
    pub read: DVector<f64>,
    /// Cost of the fit.
    pub fit: f64,
    /// Sum of the squares of the misfits, in standard deviations as they are stated.
    pub chi_square: f64,
    /// What the values cost.
    pub values: f64,
    /// What it takes to say which changes these are, words and alternatives among them.
    pub price: f64,
    /// Whether its fit settled; else its values are those at which it was found.
    pub is_fitted: bool,
}

impl Solved {
    /// What it costs.
    pub fn cost(&self) -> f64 {
        self.fit + self.values + self.price
    }

    /// The same with standard deviations as they are stated: by this it is found.
    pub fn as_stated(&self) -> f64 {
        self.chi_square + self.values + self.price
    }
}

impl<'a> Solver<'a> {
    /// Of a model, whose readings `base` are known where it starts.
    ///
    /// # Errors
    /// If the model has no solution as it stands.
    pub fn new(model: &'a Model, changes: Vec<Change>, flips: f64) -> Result<Solver<'a>, ExplainError> {
        let rows = fitted(model);
        let observables = model.observables();
        let readings: Vec<_> = rows.iter().map(|&row| &observables[row]).collect();
        let kinds: Vec<_> = rows.iter().map(|&row| model.kinds()[row]).collect();
        let (linear, left) = model.linearize_from(None, &model.start(), &|_| false)?;
        let none = Discrepancy::of_predictions(0.0, &linear.value);
        Ok(Solver {
            scatter: Scatter::new(&readings, &kinds),
            noise: Noise::new(observables, model.conditions(), &rows, &none)?,
            warm_start: left.as_ref().map(WarmStart::for_trials),
            base: linear.value,
            model,
            rows,
            changes,
            flips,
        })
    }

    /// What the search is to meet.
    pub fn target(&self) -> Target {
        let observables = self.model.observables();
        let residual = self.rows.iter().map(|&row| {
            let own = &observables[row];
            (own.value - self.base[row]) / own.sigma
        });
        let bound = |&row: &usize| match observables[row].bound {
            Bound::None => 0,
            Bound::Upper => -1,
            Bound::Lower => 1,
        };
        Target {
            residual: DVector::from_iterator(self.rows.len(), residual),
            bounds: self.rows.iter().map(bound).collect(),
        }
    }

    /// The model as it stands in this choice.
    pub fn empty(&self) -> Solved {
        self.weighed(Vec::new(), self.model.start(), self.base.clone())
    }

    /// Values of all unknowns with a set as it was found.
    fn values(&self, found: &Found) -> Vec<f64> {
        let mut at = self.model.start();
        for &(change, size) in &found.members {
            let own = &self.changes[change];
            at[own.unknown] = own.sizes[size].value;
        }
        at
    }

    /// What a set costs in the full model as it was found, not fitted, with standard deviations as they are stated; nothing where there is no solution.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn tried(&self, found: &Found) -> Result<Option<f64>, ExplainError> {
        let at = self.values(found);
        let read = where_solved(
            self.model
                .linearize_from(self.warm_start.as_ref(), &at, &|_| false),
        )?;
        let read = read.filter(|(read, _)| read.value.iter().all(|own| own.is_finite()));
        let changes = found.members.iter().map(|own| own.0).collect();
        Ok(read.map(|(read, _)| self.weighed(changes, at, read.value).as_stated()))
    }

    /// A set fitted in the full model, or as it was found where no fit settles; nothing where it has no solution, or where a strength is
    /// fitted away.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn solve(&self, found: &Found) -> Result<Option<Solved>, ExplainError> {
        let unknowns = self.model.unknowns();
        let members: Vec<usize> = found
            .members
            .iter()
            .map(|own| self.changes[own.0].unknown)
            .collect();
        let start = self.values(found);
        let moving = members
            .iter()
            .filter(|&&i| whole_strength(&unknowns[i]).is_none());
        let mut free: Vec<usize> = moving.copied().collect();
        free.extend(members.iter().filter_map(|&i| place_of(unknowns, i)));
        let task = Task {
            rows: &self.rows,
            noise: &self.noise,
            free: &free,
            start: &start,
            warm_start: self.warm_start.as_ref(),
            of_use_below: None,
        };
        let fitted = match free.is_empty() {
            true => None,
            false => where_solved(calibrate(self.model, &task))?,
        };
        let is_fitted = free.is_empty() || fitted.is_some();
        let mut at = fitted.map_or(start, |fit| fit.at);
        for &i in &free {
            let [low, high] = unknowns[i].range;
            let [low, high] = [rounded_up(low), -rounded_up(-high)];
            at[i] = if low < high {
                rounded(at[i]).clamp(low, high)
            } else {
                at[i]
            };
        }
        // a strength that was fitted away is no change
        if members.iter().any(|&i| at[i] == self.model.start()[i]) {
            return Ok(None);
        }
        let read = where_solved(self.model.predict(&at))?;
        let read = read.filter(|read| read.iter().all(|own| own.is_finite()));
        let changes = found.members.iter().map(|own| own.0).collect();
        Ok(read.map(|read| Solved {
            is_fitted,
            ..self.weighed(changes, at, read)
        }))
    }

    fn weighed(&self, changes: Vec<usize>, at: Vec<f64>, read: DVector<f64>) -> Solved {
        let unknowns = self.model.unknowns();
        let value = |&change: &usize| {
            let i = self.changes[change].unknown;
            let place = place_of(unknowns, i).map_or(0.0, |place| of_value(&unknowns[place], at[place]));
            place + of_value(&unknowns[i], at[i])
        };
        Solved {
            fit: self.fit(&read, 1.0),
            chi_square: self.misfits(&read).iter().map(|misfit| misfit * misfit).sum(),
            // a sum of nothing is −0
            values: 0.0 + changes.iter().map(value).sum::<f64>(),
            price: 0.0 + self.flips + changes.iter().map(|&own| self.changes[own].price).sum::<f64>(),
            changes,
            at,
            read,
            is_fitted: true,
        }
    }

    /// What the fit of these readings costs with all standard deviations times `factor`.
    pub fn fit(&self, read: &DVector<f64>, factor: f64) -> f64 {
        self.scatter.cost(&self.misfits(read), factor)
    }

    /// Misfits of the fitted readings, in standard deviations.
    pub fn misfits(&self, read: &DVector<f64>) -> Vec<f64> {
        let observables = self.model.observables();
        let misfit = |&row: &usize| observables[row].misfit(read[row]) / observables[row].sigma;
        self.rows.iter().map(misfit).collect()
    }

    /// A set that was solved as the search has it: the nearest sizes, and by what the full model differs from their sum.
    pub fn as_found(&self, solved: &Solved) -> (Vec<(usize, usize)>, DVector<f64>) {
        let observables = self.model.observables();
        let change = self
            .rows
            .iter()
            .map(|&row| (solved.read[row] - self.base[row]) / observables[row].sigma);
        let mut offset = DVector::from_iterator(self.rows.len(), change);
        let member = |&change: &usize| {
            let own = &self.changes[change];
            let value = solved.at[own.unknown];
            let far = |size: &usize| (own.sizes[*size].value - value).abs();
            let nearest = (0..own.sizes.len()).min_by(|a, b| far(a).total_cmp(&far(b)));
            (change, nearest.unwrap_or(0))
        };
        let members: Vec<(usize, usize)> = solved.changes.iter().map(member).collect();
        for &(change, size) in &members {
            offset -= &self.changes[change].sizes[size].change;
        }
        (members, offset)
    }
}

/// Observables that are fitted.
pub fn fitted(model: &Model) -> Vec<usize> {
    let (observables, conditions) = (model.observables(), model.conditions());
    let is_fitted = |&row: &usize| !conditions[observables[row].condition].is_held_out;
    (0..observables.len()).filter(is_fitted).collect()
}

fn unit(value: f64) -> f64 {
    match value == 0.0 {
        true => 1.0,
        false => 10f64.powi(DIGITS - 1 - value.abs().log10().floor() as i32),
    }
}

/// To a few digits.
fn rounded(value: f64) -> f64 {
    (value * unit(value)).round() / unit(value)
}

/// The same, never down.
fn rounded_up(value: f64) -> f64 {
    (value * unit(value) - 1e-9).ceil() / unit(value)
}

#[cfg(test)]
mod tests {
    use super::{rounded, rounded_up};

    #[test]
    fn values_have_four_digits_and_ends_are_not_passed() {
        assert_eq!(
            [rounded(34.56789), rounded(-0.0123456), rounded(0.0)],
            [34.57, -0.01235, 0.0]
        );
        assert_eq!(
            [rounded_up(0.95), rounded_up(0.123_41), -rounded_up(-0.123_49)],
            [0.95, 0.1235, 0.1234]
        );
    }
}
