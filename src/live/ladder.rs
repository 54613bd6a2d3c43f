//! The error falling step by step: in degrees of twist, and as chi-square.

use serde::Serialize;

use crate::compare::StudyComparison;
use crate::compare::study_comparison::StudyRow;
use crate::input::measurement::Channel;

use super::shape::Read;

/// The ladder of a state.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ladder {
    /// Its steps, from the uncalibrated model.
    pub steps: Vec<ErrorStep>,
    /// Root mean square of the stated standard deviations of twist, deg.
    pub noise_deg: Option<f64>,
    /// Error of each case as the model stands on the last step, in the order of the study.
    pub cases: Vec<CaseError>,
}

/// A model and its error.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ErrorStep {
    /// What the model is.
    pub label: String,
    /// Root mean square error of the twists that are fitted, deg; none where no twist was measured.
    pub rms_deg: Option<f64>,
    /// Sum of squares of the errors of all that is fitted, each in its stated standard deviation.
    pub chi2: f64,
    /// Root mean square error of the twists that are held out, deg.
    pub held_out_rms_deg: Option<f64>,
    /// Numbers that are fitted.
    pub count: usize,
}

/// Error of one case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CaseError {
    /// Its name.
    pub case: String,
    /// Root mean square error of its twists, deg.
    pub rms_deg: Option<f64>,
    /// Sum of squares of its errors in sigma.
    pub chi2: f64,
}

impl Ladder {
    /// Of models of a study that were calibrated one after the other, each with its name. `is_moved`: whether something in the first was
    /// set by hand.
    pub fn of_study(calibrated: &[(String, StudyComparison)], is_moved: bool) -> Ladder {
        let Some((_, first)) = calibrated.first() else {
            return Ladder::default();
        };
        let label = match is_moved {
            true => "as moved, uncalibrated",
            false => "uncalibrated",
        };
        let mut steps = vec![step(label, first, 0)];
        let is_fitted = |model: &StudyComparison| !model.unknowns.is_empty();
        let models = calibrated.iter().filter(|(_, model)| is_fitted(model));
        steps.extend(models.map(|(name, model)| step(name, model, 1)));
        let last = calibrated.last().map_or(first, |(_, model)| model);
        let twists = first.rows.iter().filter(|row| row.channel == Channel::Twist);
        let cases = last.cases.iter().map(|case| {
            let own = || last.rows.iter().filter(|row| row.case == case.name);
            CaseError {
                case: case.name.clone(),
                rms_deg: rms(own()
                    .filter(|row| row.channel == Channel::Twist)
                    .map(|row| row.errors()[1])),
                chi2: own().map(|row| (row.errors()[1] / row.sigma).powi(2)).sum(),
            }
        });
        Ladder {
            noise_deg: rms(twists.map(|row| row.sigma)),
            cases: cases.collect(),
            steps,
        }
    }

    /// Of a measured design: as opened, and as it stands, if that is another.
    pub fn of_design(first: &Read, now: Option<&Read>) -> Ladder {
        let step = |label: &str, read: &Read| ErrorStep {
            label: label.to_string(),
            rms_deg: read.rms_deg,
            chi2: read.chi2.unwrap_or(0.0),
            held_out_rms_deg: None,
            count: read.count,
        };
        let sigmas = first.twist.measured.iter().flat_map(|run| &run.sigma_deg);
        let mut steps = vec![step("uncalibrated", first)];
        steps.extend(now.map(|now| step("as moved", now)));
        Ladder {
            steps,
            noise_deg: rms(sigmas.copied()),
            cases: Vec::new(),
        }
    }
}

/// `which`: 0 uncalibrated, 1 calibrated.
fn step(label: &str, model: &StudyComparison, which: usize) -> ErrorStep {
    let of = |is_held_out: bool| {
        model
            .rows
            .iter()
            .filter(move |row| row.is_held_out == is_held_out)
    };
    let twists = |is_held_out: bool| {
        let twists = of(is_held_out).filter(|row| row.channel == Channel::Twist);
        rms(twists.map(|row| row.errors()[which]))
    };
    let square = |row: &StudyRow| (row.errors()[which] / row.sigma).powi(2);
    ErrorStep {
        label: label.to_string(),
        rms_deg: twists(false),
        chi2: of(false).map(square).sum(),
        held_out_rms_deg: twists(true),
        count: of(false).count(),
    }
}

fn rms(errors: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = errors.fold((0.0, 0usize), |(sum, count), error| {
        (sum + error * error, count + 1)
    });
    (count > 0).then(|| (sum / count as f64).sqrt())
}
