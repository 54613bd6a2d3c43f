//! A whole study: misfit by case and channel before and after calibration, what was moved, and what known uncertainty explains.

use nalgebra::DVector;

use crate::input::measurement::{Bound, Channel, Row};
use crate::study::case::PreparedCase;
use crate::study::left_out::{Local, Others, by_condition};
use crate::study::{
    Campaign, Condition, Discrepancy, Fit, Forward, Linear, Noise, StudyError, Task, UnknownKind, WarmStart,
    best_fit,
};

use super::study_comparison::{
    CalibratedUnknown, Correlation, GroupMisfit, StudyCase, StudyComparison, StudyRow,
};
use super::study_words::words;

/// Posterior over prior width below which the data are said to know an unknown.
const IDENTIFIED: f64 = 0.8;
/// Correlation above which two unknowns are said to stand for each other.
const CORRELATED: f64 = 0.5;

/// Calibrates the study's inputs, ruler and effects on its fitted rows and compares all rows.
///
/// # Errors
/// If a case has no solution, or the fit does not settle.
pub fn compare_study(campaign: &Campaign, title: &str) -> Result<StudyComparison, StudyError> {
    let start = campaign.start();
    let (before, warm_start) = campaign.linearize_from(None, &start, &|_| true)?;
    let (observables, conditions) = (campaign.observables(), campaign.conditions());
    let fitted = |row: &usize| !conditions[observables[*row].condition].is_held_out;
    let rows: Vec<usize> = (0..observables.len()).filter(fitted).collect();
    let noise = Noise::new(
        observables,
        conditions,
        &rows,
        &Discrepancy::of_predictions(campaign.discrepancy, &before.value),
    )?;
    let free: Vec<usize> = (0..campaign.unknowns().len()).collect();
    let trials = warm_start.as_ref().map(WarmStart::for_trials);
    let task = Task {
        rows: &rows,
        noise: &noise,
        free: &free,
        start: &start,
        warm_start: trials.as_ref(),
        of_use_below: None,
    };
    // what Newton's method does not solve is not waited for, unless nothing is found so
    let fit = || match best_fit(campaign, &task) {
        Err(error) if !matches!(error, StudyError::Cancelled(_)) => {
            let patient = Task {
                warm_start: warm_start.as_ref(),
                ..task.clone()
            };
            best_fit(campaign, &patient)
        }
        found => found,
    };
    let fit = (!free.is_empty() && !rows.is_empty()).then(fit).transpose()?;
    let after = fit.as_ref().map_or(&before.value, |fit| &fit.predicted);
    let whitened = |value: &DVector<f64>| {
        let errors = rows.iter().map(|&row| observables[row].misfit(value[row]));
        noise
            .whiten(&DVector::from_iterator(rows.len(), errors))
            .norm_squared()
            / rows.len().max(1) as f64
    };
    let left_out = predictions_from_others(campaign, &rows, &noise, fit.as_ref(), after);
    let study_rows = rows_of(campaign, &before, after, &left_out);
    let mut comparison = StudyComparison {
        study: campaign.name.clone(),
        title: title.to_string(),
        groups: groups(&study_rows, campaign.discrepancy),
        unknowns: fit.as_ref().map_or_else(Vec::new, |fit| unknowns(campaign, fit)),
        correlations: fit
            .as_ref()
            .map_or_else(Vec::new, |fit| correlations(campaign, fit)),
        chi_square_per_row: [whitened(&before.value), whitened(after)],
        not_compared: campaign.not_compared(),
        cases: cases_of(campaign),
        rows: study_rows,
        words: Vec::new(),
    };
    comparison.words = words(&comparison);
    Ok(comparison)
}

fn cases_of(campaign: &Campaign) -> Vec<StudyCase> {
    let cases = campaign.cases().iter().zip(campaign.conditions());
    let case = |(case, condition): (&PreparedCase, &Condition)| StudyCase {
        name: case.name.clone(),
        wing: condition.wing.clone(),
        family: case.family.clone(),
        numbers: case.numbers.clone(),
        is_held_out: condition.is_held_out,
    };
    cases.map(case).collect()
}

/// Every observable of `rows` as predicted from all cases but its own, if there are several; `after`: as calibrated, or, with nothing
/// to calibrate, as stated.
fn predictions_from_others(
    campaign: &Campaign,
    rows: &[usize],
    noise: &Noise,
    fit: Option<&Fit>,
    after: &DVector<f64>,
) -> Vec<Option<f64>> {
    let observables = campaign.observables();
    let mut predicted = vec![None; observables.len()];
    let groups = by_condition(campaign, rows);
    if groups.len() < 2 {
        return predicted;
    }
    let Some(fit) = fit else {
        rows.iter().for_each(|&row| predicted[row] = Some(after[row]));
        return predicted;
    };
    let left = Others::new(&Local::about(fit, campaign, noise), noise).leave_out(&groups);
    for group in left.iter().flatten() {
        for (&position, error) in group.positions.iter().zip(&group.errors) {
            let (row, observable) = (rows[position], &observables[rows[position]]);
            // a bound that the fit keeps has no part in it, and no prediction by it
            let is_kept = observable.bound != Bound::None && observable.misfit(after[row]) == 0.0;
            predicted[row] = (!is_kept).then_some(observable.value - error);
        }
    }
    predicted
}

fn rows_of(
    campaign: &Campaign,
    before: &Linear,
    after: &DVector<f64>,
    left_out: &[Option<f64>],
) -> Vec<StudyRow> {
    let unknowns = campaign.unknowns();
    let measured: Vec<&Row> = campaign.cases().iter().flat_map(|case| &case.rows).collect();
    let row = |(index, observable): (usize, &crate::study::Observable)| {
        let condition = &campaign.conditions()[observable.condition];
        let spread = unknowns
            .iter()
            .enumerate()
            .filter(|(_, u)| !matches!(u.kind, UnknownKind::Effect { .. }));
        let variance: f64 = spread
            .map(|(k, u)| (before.jacobian[(index, k)] * u.sigma).powi(2))
            .sum();
        StudyRow {
            case: condition.name.clone(),
            wing: condition.wing.clone(),
            line: observable.line,
            channel: observable.channel,
            run: observable.run.clone(),
            r_mm: observable.r_mm,
            r_to_mm: observable.r_to_mm,
            chord_fraction: measured.get(index).and_then(|row| row.chord_fraction),
            measured: observable.value,
            sigma: observable.sigma,
            bound: observable.bound,
            before: before.value[index],
            sigma_of_inputs: variance.sqrt(),
            after: after[index],
            left_out: left_out[index],
            is_held_out: condition.is_held_out,
        }
    };
    campaign.observables().iter().enumerate().map(row).collect()
}

impl StudyRow {
    /// Measured minus modelled before and after calibration; nothing where a bound is kept.
    pub fn errors(&self) -> [f64; 2] {
        [self.before, self.after].map(|modelled| self.error(modelled))
    }

    /// Measured minus modelled by the model as calibrated to all other cases.
    pub fn left_out_error(&self) -> Option<f64> {
        self.left_out.map(|modelled| self.error(modelled))
    }

    fn error(&self, modelled: f64) -> f64 {
        match (self.bound, self.measured - modelled) {
            (Bound::None, error) => error,
            (Bound::Upper, error) => error.min(0.0),
            (Bound::Lower, error) => error.max(0.0),
        }
    }
}

/// Root mean square of some errors; none of none.
pub fn root_mean_square(errors: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = errors.fold((0.0, 0usize), |(sum, count), error| {
        (sum + error * error, count + 1)
    });
    (count > 0).then(|| (sum / count as f64).sqrt())
}

fn groups(rows: &[StudyRow], discrepancy: f64) -> Vec<GroupMisfit> {
    let mut keys: Vec<(&str, Channel, bool)> = Vec::new();
    for row in rows {
        let key = (row.wing.as_str(), row.channel, row.is_held_out);
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    let group = |(wing, channel, is_held_out): (&str, Channel, bool)| {
        let belongs = |row: &&StudyRow| {
            (row.wing.as_str(), row.channel, row.is_held_out) == (wing, channel, is_held_out)
        };
        let members: Vec<&StudyRow> = rows.iter().filter(belongs).collect();
        let mean = |of: &dyn Fn(&StudyRow) -> f64| {
            members.iter().map(|row| of(row)).sum::<f64>() / members.len() as f64
        };
        let square = |k: usize| mean(&|row| row.errors()[k].powi(2));
        let variance = |row: &StudyRow| row.sigma.powi(2) + (discrepancy * row.before).powi(2);
        let chi_square = |k: usize| mean(&|row| row.errors()[k].powi(2) / variance(row));
        let measurement = mean(&|row| row.sigma.powi(2));
        let inputs = mean(&|row| row.sigma_of_inputs.powi(2));
        GroupMisfit {
            wing: wing.to_string(),
            channel,
            unit: channel.unit().to_string(),
            is_held_out,
            count: members.len(),
            rmse: [square(0).sqrt(), square(1).sqrt()],
            left_out: root_mean_square(members.iter().filter_map(|row| row.left_out_error())),
            chi_square_per_row: [chi_square(0), chi_square(1)],
            bias: [mean(&|row| row.errors()[0]), mean(&|row| row.errors()[1])],
            sigma_of_measurement: measurement.sqrt(),
            sigma_of_inputs: inputs.sqrt(),
            explained: Some((measurement + inputs) / square(0)).filter(|share| share.is_finite()),
        }
    };
    keys.into_iter().map(group).collect()
}

fn unknowns(campaign: &Campaign, fit: &Fit) -> Vec<CalibratedUnknown> {
    let one = |(place, &index): (usize, &usize)| {
        let unknown = campaign.unknowns()[index].clone();
        let standard_error = fit.covariance[(place, place)].max(0.0).sqrt();
        CalibratedUnknown {
            value: fit.at[index],
            standard_error,
            pull: (fit.at[index] - unknown.mean) / unknown.sigma,
            is_identified: standard_error < IDENTIFIED * unknown.sigma,
            at_end: fit.at_end.contains(&index),
            unknown,
        }
    };
    fit.free.iter().enumerate().map(one).collect()
}

fn correlations(campaign: &Campaign, fit: &Fit) -> Vec<Correlation> {
    let size = fit.free.len();
    let name = |place: usize| campaign.unknowns()[fit.free[place]].name.clone();
    let mut found = Vec::new();
    for i in 0..size {
        for j in 0..i {
            let scale = (fit.covariance[(i, i)] * fit.covariance[(j, j)]).sqrt();
            let value = fit.covariance[(i, j)] / scale;
            if value.abs() > CORRELATED {
                found.push(Correlation {
                    a: name(j),
                    b: name(i),
                    value,
                });
            }
        }
    }
    found.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
    found
}
