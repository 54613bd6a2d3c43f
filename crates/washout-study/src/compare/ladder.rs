//! The error of a study falling step by step: uncalibrated, calibrated, with one effect more after the other, down to the noise.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;

use super::study::root_mean_square;
use super::study_comparison::{GroupMisfit, StudyComparison, StudyRow};

/// A model on the ladder, and its errors.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StudyLadderStep {
    /// `raw`, `calibrated`, `+ effect` for every one that was added, `− effect`, `effect anew` (it was there) or `effect fitted` (with a
    /// fixed strength), `noise`.
    pub name: String,
    /// χ² per fitted number with the correlations of the error that the study admits to the model: what a fit makes least; none
    /// for `noise`.
    pub chi_square_per_number: Option<f64>,
    /// Root mean square error of all that was fitted, each number in its stated standard deviation.
    pub in_sample_sigma: Option<f64>,
    /// The same with each case predicted from all others; none for `raw`, and where only one case is fitted.
    pub left_out_sigma: Option<f64>,
    /// The same for what is held out.
    pub held_out_sigma: Option<f64>,
    /// Errors by wing and channel.
    pub groups: Vec<StepGroup>,
}

/// Errors of a channel of a wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StepGroup {
    /// The wing.
    pub wing: String,
    /// The channel.
    pub channel: Channel,
    /// Unit of the errors.
    pub unit: String,
    /// Whether it was kept out of the fit.
    pub is_held_out: bool,
    /// Root mean square error.
    pub rmse: f64,
    /// The same with each case predicted from all others.
    pub left_out: Option<f64>,
    /// Mean square error over its variance (stated, and what the study admits to the model), each number for itself.
    pub chi_square_per_number: f64,
}

/// The steps of models that were calibrated one after the other, each with its name, and of the same cases.
pub fn ladder(calibrated: &[(String, StudyComparison)]) -> Vec<StudyLadderStep> {
    let Some((_, first)) = calibrated.first() else {
        return Vec::new();
    };
    let mut steps = vec![of_model("raw", first, Step::Stated)];
    steps.extend(
        calibrated
            .iter()
            .map(|(name, model)| of_model(name, model, Step::Calibrated)),
    );
    steps.push(of_model("noise", first, Step::Noise));
    steps
}

/// What of a comparison is meant.
#[derive(Clone, Copy, PartialEq)]
enum Step {
    Stated,
    Calibrated,
    Noise,
}

fn of_model(name: &str, model: &StudyComparison, step: Step) -> StudyLadderStep {
    let in_sigma = |is_held_out: bool, error: &dyn Fn(&StudyRow) -> Option<f64>| {
        let rows = model.rows.iter().filter(|row| row.is_held_out == is_held_out);
        root_mean_square(rows.filter_map(|row| Some(error(row)? / row.sigma)))
    };
    let own = |row: &StudyRow| {
        Some(match step {
            Step::Stated => row.errors()[0],
            Step::Calibrated => row.errors()[1],
            Step::Noise => row.sigma,
        })
    };
    let left_out = |row: &StudyRow| match step {
        Step::Stated => None,
        Step::Calibrated => row.left_out_error(),
        Step::Noise => row.left_out.map(|_| row.sigma),
    };
    let group = |group: &GroupMisfit| {
        let (rmse, left_out, chi_square_per_number) = match step {
            Step::Stated => (group.rmse[0], None, group.chi_square_per_row[0]),
            Step::Calibrated => (group.rmse[1], group.left_out, group.chi_square_per_row[1]),
            Step::Noise => {
                let sigma = group.sigma_of_measurement;
                (sigma, group.left_out.map(|_| sigma), 1.0)
            }
        };
        StepGroup {
            wing: group.wing.clone(),
            channel: group.channel,
            unit: group.unit.clone(),
            is_held_out: group.is_held_out,
            rmse,
            left_out,
            chi_square_per_number,
        }
    };
    StudyLadderStep {
        name: name.to_string(),
        chi_square_per_number: match step {
            Step::Stated => Some(model.chi_square_per_row[0]),
            Step::Calibrated => Some(model.chi_square_per_row[1]),
            Step::Noise => None,
        },
        in_sample_sigma: in_sigma(false, &own),
        left_out_sigma: in_sigma(false, &left_out),
        held_out_sigma: in_sigma(true, &own),
        groups: model.groups.iter().map(group).collect(),
    }
}
