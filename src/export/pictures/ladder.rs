//! The error falling from the uncalibrated model to the noise: `ladder.svg`.

use crate::compare::{self, StudyLadderStep};
use crate::diagnose::ladder::LadderStep;
use crate::input::measurement::Channel;
use crate::plot::{Figure, Ink, Key, Panel, Sample, Shape, Stair, Step};

use super::panels::distinct;
use super::{with_unit, words};
use crate::export::ladder::step_words;

/// How errors are summed up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Root mean square, in the unit of the channel.
    RootMeanSquare,
    /// χ² per number: each counts by its variance.
    ChiSquare,
    /// Root mean square, each number in its stated standard deviation.
    InSigma,
}

/// Errors of one channel, step by step.
#[derive(Debug, Clone, PartialEq)]
pub struct Fall {
    /// What they are.
    pub measure: Measure,
    /// Name of the wing; empty if it is of all.
    pub wing: String,
    /// What was measured; none if it is of all channels.
    pub channel: Option<Channel>,
    /// Groups of data: fitted, left out, held out.
    pub groups: Vec<String>,
    /// Each step with the error of each group; none where a group has none.
    pub steps: Vec<(String, Vec<Option<f64>>)>,
}

/// Name of a group of data, and its error at a step.
type StepGroup = (&'static str, fn(&LadderStep) -> Option<f64>);

impl Fall {
    /// Of the ladder of a diagnosis; groups that no step has are left out.
    pub fn of_diagnosis(ladder: &[LadderStep]) -> Vec<Fall> {
        let Some(first) = ladder.first() else {
            return Vec::new();
        };
        let all: [StepGroup; 3] = [
            (FITTED, |step| Some(step.in_sample)),
            (LEFT_OUT, |step| step.left_out),
            (HELD_OUT, |step| step.held_out),
        ];
        let kept: Vec<_> = all
            .into_iter()
            .filter(|(_, of)| ladder.iter().any(|step| of(step).is_some()))
            .collect();
        vec![Fall {
            measure: Measure::RootMeanSquare,
            wing: String::new(),
            channel: Some(first.channel),
            groups: kept.iter().map(|(name, _)| name.to_string()).collect(),
            steps: ladder
                .iter()
                .map(|step| {
                    (
                        step_words(&step.name).to_string(),
                        kept.iter().map(|(_, of)| of(step)).collect(),
                    )
                })
                .collect(),
        }]
    }

    /// Of the ladder of a study, of all channels, then wing by wing and channel by channel; groups that no step has are left out.
    pub fn of_study(ladder: &[StudyLadderStep]) -> Vec<Fall> {
        let Some(first) = ladder.first() else {
            return Vec::new();
        };
        let groups = || ladder.iter().flat_map(|step| &step.groups);
        let kept: Vec<&StudyGroup> = STUDY_GROUPS
            .iter()
            .filter(|of| groups().any(|group| of.error(group, Measure::RootMeanSquare).is_some()))
            .collect();
        let fall = |wing: &str, channel: Channel, measure: Measure| {
            let level = |step: &StudyLadderStep, of: &StudyGroup| {
                let mut own = step
                    .groups
                    .iter()
                    .filter(|group| group.wing == wing && group.channel == channel);
                own.find_map(|group| of.error(group, measure))
            };
            let with_levels = |step: &StudyLadderStep| {
                let levels = kept.iter().map(|of| level(step, of)).collect();
                (step_words(&step.name).to_string(), levels)
            };
            Fall {
                measure,
                wing: wing.to_string(),
                channel: Some(channel),
                groups: kept.iter().map(|of| of.name.to_string()).collect(),
                steps: ladder.iter().map(with_levels).collect(),
            }
        };
        let all = |step: &StudyLadderStep| {
            let levels = kept.iter().map(|of| (of.in_sigma)(step)).collect();
            (step_words(&step.name).to_string(), levels)
        };
        let mut falls = vec![Fall {
            measure: Measure::InSigma,
            wing: String::new(),
            channel: None,
            groups: kept.iter().map(|of| of.name.to_string()).collect(),
            steps: ladder.iter().map(all).collect(),
        }];
        let key = |group: &compare::StepGroup| (group.wing.clone(), group.channel);
        for (wing, channel) in distinct(first.groups.iter().map(key)) {
            let measures = [Measure::RootMeanSquare, Measure::ChiSquare];
            falls.extend(measures.map(|measure| fall(&wing, channel, measure)));
        }
        falls
    }
}

/// Name of the step below which no model should get.
const NOISE: &str = "noise";

/// Names of the groups of data.
const FITTED: &str = "fitted";
const LEFT_OUT: &str = "each case predicted from the others";
const HELD_OUT: &str = "held out";

/// A group of data of a study.
struct StudyGroup {
    name: &'static str,
    is_held_out: bool,
    root_mean_square: fn(&compare::StepGroup) -> Option<f64>,
    chi_square: fn(&compare::StepGroup) -> Option<f64>,
    in_sigma: fn(&StudyLadderStep) -> Option<f64>,
}

const STUDY_GROUPS: [StudyGroup; 3] = [
    StudyGroup {
        name: FITTED,
        is_held_out: false,
        root_mean_square: |group| Some(group.rmse),
        chi_square: |group| Some(group.chi_square_per_number),
        in_sigma: |step| step.in_sample_sigma,
    },
    StudyGroup {
        name: LEFT_OUT,
        is_held_out: false,
        root_mean_square: |group| group.left_out,
        chi_square: |_| None,
        in_sigma: |step| step.left_out_sigma,
    },
    StudyGroup {
        name: HELD_OUT,
        is_held_out: true,
        root_mean_square: |group| Some(group.rmse),
        chi_square: |group| Some(group.chi_square_per_number),
        in_sigma: |step| step.held_out_sigma,
    },
];

impl StudyGroup {
    fn error(&self, group: &compare::StepGroup, measure: Measure) -> Option<f64> {
        let error = match measure {
            Measure::RootMeanSquare => self.root_mean_square,
            Measure::ChiSquare => self.chi_square,
            Measure::InSigma => return None,
        };
        error(group).filter(|_| group.is_held_out == self.is_held_out)
    }
}

/// One panel for each.
pub fn figure(title: &str, falls: &[Fall]) -> Figure {
    let groups = falls.first().map_or(&[][..], |fall| &fall.groups);
    let key = |(index, group): (usize, &String)| Key {
        label: group.clone(),
        sample: Sample::Marker(Ink::Curve(index), Shape::Circle, true),
    };
    Figure {
        title: title.to_string(),
        legend: groups.iter().enumerate().map(key).collect(),
        panels: falls.iter().map(panel).collect(),
        columns: None,
        caption: "Dashed: the standard deviation of the measurement, which a fit with many unknowns may come below."
            .to_string(),
    }
}

fn panel(fall: &Fall) -> Panel {
    let channel = fall.channel.map_or("all channels".to_string(), words);
    let title = match fall.wing.as_str() {
        "" => channel,
        wing => format!("{wing}: {channel}"),
    };
    let step = |(label, levels): &(String, Vec<Option<f64>>)| Step {
        label: label.clone(),
        levels: levels.clone(),
    };
    let (models, floor) = match fall.steps.split_last() {
        Some((last, models)) if last.0 == NOISE => (models, Some(last)),
        _ => (&fall.steps[..], None),
    };
    Panel::Stair(Stair {
        title,
        y_label: match fall.measure {
            Measure::RootMeanSquare => {
                let unit = fall.channel.map_or("", |channel| channel.unit());
                with_unit("root mean square error", unit)
            }
            Measure::ChiSquare => "chi-square per number".to_string(),
            Measure::InSigma => with_unit("root mean square error", "stated σ"),
        },
        groups: fall.groups.clone(),
        steps: models.iter().map(step).collect(),
        floor: floor.map(step),
    })
}
