//! An effect that joined a study: the document of `washout add`, and what it says.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::add::{OnBench, Other};
use crate::compare::{StepGroup, StudyLadderStep};
use crate::effects::named;
use crate::page::text::significant;
use crate::page::{Page, Part};
use crate::program::MadeOf;

use super::ladder;

/// What `washout add` prints; `ladder.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AddReport {
    /// The study as written.
    pub written: PathBuf,
    /// The effect.
    pub effect: String,
    /// Its fitted strength and standard error (0 if it is there wholly or not at all); none if it was taken out.
    pub strength: Option<[f64; 2]>,
    /// What it is, one sentence, and what a strength of 1 means; none of an effect of one's own.
    pub what: Option<[String; 2]>,
    /// What the strength is on the wing as something that a bench measures: the number, and its unit with what it is; none if no number says it.
    #[serde(default)]
    pub stands_for: Option<(f64, String)>,
    /// What the strength does to the still wing under a torque; none if nothing, or the effect was taken out.
    pub on_bench: Option<OnBench>,
    /// The other effects that are fitted in the study, with the strengths that it has now.
    pub others: Vec<Other>,
    /// What is to be thought of: strengths that are not plausible, an error that does not fall, wings that change.
    pub notes: Vec<String>,
    /// The error falling: uncalibrated and calibrated without any effect that was added, with one after the other of those in the
    /// study, with this one (or without it), the noise.
    pub ladder: Vec<StudyLadderStep>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// What an effect of the library is, and what its strength means, with its unit.
pub fn what(effect: &str) -> Option<[String; 2]> {
    let card = named(effect)?.card();
    let strength = card.parameters.first()?;
    let unit = match strength.unit {
        "1" => String::new(),
        unit => format!(" ({unit})"),
    };
    Some([card.summary.to_string(), format!("{}{unit}", strength.meaning)])
}

/// What `washout add` says.
pub fn page(report: &AddReport) -> Page {
    let what = match report.strength {
        Some([value, 0.0]) => format!(
            "{} with strength {}, all of it",
            report.effect,
            significant(value, 4)
        ),
        Some([value, error]) => format!(
            "{} with strength {} ± {}",
            report.effect,
            significant(value, 4),
            significant(error, 2)
        ),
        None => format!("without {}", report.effect),
    };
    let steps = Part::Table(ladder::steps(&report.ladder));
    let title = format!("{}: {what}", report.written.display());
    let lead = vec![
        Part::Sentence(words(report)),
        Part::List(report.others.iter().map(again).collect()),
        Part::Notes(report.notes.clone()),
    ];
    let mut page = Page {
        brief: [
            vec![Part::Subtitle(title.clone())],
            lead.clone(),
            vec![steps.clone()],
        ]
        .concat(),
        title,
        kind: "ladder",
        lead,
        ..Page::default()
    };
    page.section("ladder", "Error step by step", vec![steps]);
    page.section("wings", "Error wing by wing", ladder::groups(&report.ladder));
    page
}

/// What joined or left, what that does to the error, and what it would do on a bench.
fn words(report: &AddReport) -> String {
    let what = report.what.as_ref().filter(|_| report.strength.is_some());
    let here = report.stands_for.as_ref().map_or(String::new(), |(value, unit)| {
        format!("; here {} {unit}", significant(*value, 3))
    });
    let what = what.map(|[summary, strength]| format!("{summary} Strength: {strength}{here}."));
    let on_bench = report.on_bench.as_ref().map(|bench| {
        format!(
            "On a bench, {} turns by {} deg at {} mm as calibrated with it, and by {} deg as calibrated without: a way to check it by hand.",
            bench.load,
            significant(bench.with_effect_deg, 3),
            bench.r_mm,
            significant(bench.without_deg, 3)
        )
    });
    let parts = [what, fall(&report.ladder), on_bench];
    parts.into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// How the last step moves the error: in the unit of the channel where one wing was read in one channel, else of all in σ.
fn fall(ladder: &[StudyLadderStep]) -> Option<String> {
    let [.., before, after, noise] = ladder else {
        return None;
    };
    let first = before.groups.first()?;
    let is_one = |group: &StepGroup| (&group.wing, group.channel) == (&first.wing, first.channel);
    let (of, unit) = match before.groups.iter().all(is_one) {
        true => (first.channel.name(), first.unit.as_str()),
        false => ("all channels", "sigma"),
    };
    let error = |step: &StudyLadderStep, is_held_out: bool| match unit {
        "sigma" if is_held_out => step.held_out_sigma,
        "sigma" => step.in_sample_sigma,
        _ => {
            let mut groups = step.groups.iter();
            groups
                .find(|group| group.is_held_out == is_held_out)
                .map(|group| group.rmse)
        }
    };
    let pair = |is_held_out: bool, used: &str| {
        let [before, after] =
            [error(before, is_held_out)?, error(after, is_held_out)?].map(|error| significant(error, 3));
        Some(format!("from {before} to {after} {unit} where it was {used}"))
    };
    let pairs: Vec<String> = [pair(false, "fitted"), pair(true, "held out")]
        .into_iter()
        .flatten()
        .collect();
    let noise = error(noise, false).map_or(String::new(), |noise| {
        format!("; the scatter alone would leave {}", significant(noise, 3))
    });
    (!pairs.is_empty()).then(|| format!("The error of {of} goes {}{noise}.", pairs.join(" and ")))
}

/// An effect that was fitted again beside the one that joined.
fn again(other: &Other) -> String {
    let [now, error] = other.strength;
    format!(
        "{} fitted again: {} ± {} ({} before)",
        other.effect,
        significant(now, 4),
        significant(error, 2),
        significant(other.before, 4)
    )
}
