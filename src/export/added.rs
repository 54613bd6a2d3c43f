//! An effect that joined a study: the document of `washout add`, and what it says.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::add::Other;
use crate::compare::StudyLadderStep;
use crate::origin::MadeOf;
use crate::page::text::significant;
use crate::page::{Page, Part};

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
    let mut page = Page {
        title: format!("{}: {what}", report.written.display()),
        kind: "ladder",
        lead: vec![
            Part::List(report.others.iter().map(again).collect()),
            Part::Notes(report.notes.clone()),
        ],
        brief: vec![steps.clone()],
        ..Page::default()
    };
    page.section("ladder", "Error step by step", vec![steps]);
    page.section("wings", "Error wing by wing", ladder::groups(&report.ladder));
    page
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
