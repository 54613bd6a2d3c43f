//! The error falling from the model as stated to the noise: `ladder.svg`.

use crate::compare::study::GroupMisfit;
use crate::diagnose::ladder::Rung;
use crate::input::measurement::Channel;
use crate::plot::{Figure, Ink, Key, Panel, Sample, Step, Waterfall};

use super::panels::distinct;
use super::{with_unit, words};

/// How errors are summed up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Root mean square, in the unit of the channel.
    RootMeanSquare,
    /// χ² per number: each counts by its variance.
    ChiSquare,
}

/// Errors of one channel, step by step.
#[derive(Debug, Clone, PartialEq)]
pub struct Fall {
    /// What they are.
    pub measure: Measure,
    /// Name of the wing; empty if it is of all.
    pub wing: String,
    /// What was measured.
    pub channel: Channel,
    /// Groups of data: fitted, left out, held out.
    pub groups: Vec<String>,
    /// Each step with the error of each group; none where a group has none.
    pub steps: Vec<(String, Vec<Option<f64>>)>,
}

/// Name of a group of data, and its error at a rung.
type RungGroup = (&'static str, fn(&Rung) -> Option<f64>);

impl Fall {
    /// Of the ladder of a diagnosis; groups that no rung has are left out.
    pub fn of_rungs(rungs: &[Rung]) -> Vec<Fall> {
        let Some(first) = rungs.first() else {
            return Vec::new();
        };
        let all: [RungGroup; 3] = [
            ("fitted", |rung| Some(rung.in_sample)),
            ("each case predicted from the others", |rung| rung.left_out),
            ("held out", |rung| rung.held_out),
        ];
        let kept: Vec<_> = all
            .into_iter()
            .filter(|(_, of)| rungs.iter().any(|rung| of(rung).is_some()))
            .collect();
        vec![Fall {
            measure: Measure::RootMeanSquare,
            wing: String::new(),
            channel: first.channel,
            groups: kept.iter().map(|(name, _)| name.to_string()).collect(),
            steps: rungs
                .iter()
                .map(|rung| {
                    (
                        step_words(&rung.name),
                        kept.iter().map(|(_, of)| of(rung)).collect(),
                    )
                })
                .collect(),
        }]
    }

    /// Of an effect that joined or left a study, wing by wing and channel by channel: `before` and `after` are the misfits
    /// without and with the `change`.
    pub fn of_groups(before: &[GroupMisfit], after: &[GroupMisfit], change: &str) -> Vec<Fall> {
        let key = |group: &GroupMisfit| (group.wing.clone(), group.channel);
        let falls = distinct(before.iter().map(key))
            .into_iter()
            .map(|(wing, channel)| {
                let pick = |groups: &[GroupMisfit], is_held_out: bool| {
                    let is_it = |group: &&GroupMisfit| {
                        group.wing == wing && group.channel == channel && group.is_held_out == is_held_out
                    };
                    groups.iter().find(is_it).cloned()
                };
                let kept: Vec<bool> = [false, true]
                    .into_iter()
                    .filter(|held| pick(before, *held).is_some())
                    .collect();
                let levels = |groups: &[GroupMisfit], of: fn(&GroupMisfit) -> f64| {
                    kept.iter()
                        .map(|held| pick(groups, *held).map(|group| of(&group)))
                        .collect()
                };
                let names = kept
                    .iter()
                    .map(|held| if *held { "held out" } else { "fitted" }.to_string());
                let groups: Vec<String> = names.collect();
                let fall = |measure: Measure, of: [fn(&GroupMisfit) -> f64; 3]| Fall {
                    measure,
                    groups: groups.clone(),
                    steps: vec![
                        ("as stated".to_string(), levels(before, of[0])),
                        ("calibrated".to_string(), levels(before, of[1])),
                        (change.to_string(), levels(after, of[1])),
                        ("noise".to_string(), levels(before, of[2])),
                    ],
                    wing: wing.clone(),
                    channel,
                };
                [
                    fall(
                        Measure::RootMeanSquare,
                        [
                            |group| group.rmse[0],
                            |group| group.rmse[1],
                            |group| group.sigma_of_measurement,
                        ],
                    ),
                    fall(
                        Measure::ChiSquare,
                        [
                            |group| group.chi_square_per_row[0],
                            |group| group.chi_square_per_row[1],
                            |_| 1.0,
                        ],
                    ),
                ]
            });
        falls.flatten().collect()
    }
}

fn step_words(name: &str) -> String {
    match name {
        "raw" => "as stated".to_string(),
        name => name.to_string(),
    }
}

/// One waterfall for each.
pub fn figure(title: &str, falls: &[Fall]) -> Figure {
    let groups = falls.first().map_or(&[][..], |fall| &fall.groups);
    let key = |(index, group): (usize, &String)| Key {
        label: group.clone(),
        sample: Sample::Swatch(Ink::Curve(index)),
    };
    Figure {
        title: title.to_string(),
        legend: groups.iter().enumerate().map(key).collect(),
        panels: falls.iter().map(panel).collect(),
        columns: None,
        caption: "Full bars: what there is; pale bars: what a step changes, from the level before to its line. Noise: the \
                  standard deviation of the measurement, below which no model should get."
            .to_string(),
    }
}

fn panel(fall: &Fall) -> Panel {
    let last = fall.steps.len().saturating_sub(1);
    let title = match fall.wing.as_str() {
        "" => words(fall.channel),
        wing => format!("{wing}: {}", words(fall.channel)),
    };
    let step = |(index, (label, levels)): (usize, &(String, Vec<Option<f64>>))| Step {
        label: label.clone(),
        levels: levels.clone(),
        is_total: index == 0 || index == last,
    };
    Panel::Waterfall(Waterfall {
        title,
        y_label: match fall.measure {
            Measure::RootMeanSquare => with_unit("root mean square error", fall.channel.unit()),
            Measure::ChiSquare => "chi-square per number".to_string(),
        },
        groups: fall.groups.clone(),
        steps: fall.steps.iter().enumerate().map(step).collect(),
    })
}
