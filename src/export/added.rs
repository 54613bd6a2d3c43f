//! An effect that joined a study: the document of `washout add`, and what it says.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::add::Other;
use crate::compare::StudyLadderStep;
use crate::origin::MadeOf;
use crate::page::text::{significant, wrapped};

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
    /// The error falling: as stated and calibrated without any effect that was added, with one after the other of those in the
    /// study, with this one (or without it), the noise.
    pub ladder: Vec<StudyLadderStep>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// What the tables of errors tell.
const STEPS: &str = "Root mean square of all channels, in stated sigma; chi2: chi-square per fitted number, with errors of the model that go \
                     together along the span (discrepancy), which is what a fit makes least. Left out: each case predicted from the others.";
const GROUPS: &str = "rmse: root mean square error; chi2: chi-square per number, each number for itself.";

/// An effect that was fitted again beside the one that joined.
fn again(other: &Other) -> String {
    let [now, error] = other.strength;
    format!(
        "  {} fitted again: {} ± {} ({} before)\n",
        other.effect,
        significant(now, 4),
        significant(error, 2),
        significant(other.before, 4)
    )
}

/// The page of `washout add`.
pub fn page(report: &AddReport) -> String {
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
    let others = report.others.iter().map(again);
    let notes = report.notes.iter().map(|note| wrapped(note, 2));
    let more: String = others.chain(notes).collect();
    format!(
        "{}: {what}\n{more}\nError step by step\n{}{}\nError wing by wing\n{}{}",
        report.written.display(),
        wrapped(STEPS, 2),
        ladder::steps(&report.ladder),
        wrapped(GROUPS, 2),
        ladder::groups(&report.ladder)
    )
}
