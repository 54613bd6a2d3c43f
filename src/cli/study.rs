//! Studies on the command line: loaded, solved, compared.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::compare::StudyComparison;
use crate::compare::study::compare_study;
use crate::diagnose::{Diagnosis, Verdict};
use crate::export::html::REPORT;
use crate::export::html::measured::Measured;
use crate::export::html::study::{StudyParts, page as study_page};
use crate::export::html::wing::Wing;
use crate::export::html::wings::Wings;
use crate::export::json;
use crate::export::pictures::compared::figure as compared_figure;
use crate::export::pictures::panels;
use crate::export::pictures::write::add_study;
use crate::export::run::RunFolder;
use crate::export::study::{StudyReport, page};
use crate::input::study::LoadedStudy;
use crate::origin::MadeOf;
use crate::page::text::hanging;
use crate::study::{Campaign, Forward, StudyError, Unknown, UnknownKind};

use super::sheet::FromSheet;
use super::{Console, Failure};

/// The document that lists the files of a comparison.
pub const COMPARISON: &str = "comparison.json";

/// `washout compare STUDY`: solves, compares, writes into `output` or `output/NAME-compare`. `table`: what the study was made of, if it
/// was a table.
pub fn compare(
    (path, study): (&Path, &LoadedStudy),
    table: Option<&FromSheet>,
    output: Option<&PathBuf>,
    with_report: bool,
    console: &Console,
) -> Result<(), Failure> {
    let target = target(output, &study.study.name, "compare");
    let mut folder = RunFolder::listed_by(&target, "compare", COMPARISON)?;
    let compared = Compared::with_table(path, study, table, console)?;
    let parts = with_report.then(|| compared.parts(study, console)).transpose()?;
    add_study(&mut folder, &compared.comparison)?;
    let report = StudyReport {
        comparison: compared.comparison,
        made_of: MadeOf::files(&study.files),
        files: folder.listed_with(with_report),
    };
    if let Some(parts) = parts {
        folder.add(REPORT, study_page(&report, &parts)?.html().as_bytes())?;
    }
    folder.add_summary(&report)?;
    console.progress().check()?;
    let written = folder.commit()?;
    let sketch = console.sketch(&compared_figure(&panels::Compared::of_study(&report.comparison)));
    let after = listed(&written, &report.files) + &sketch;
    console.answer(&page(&report.comparison), &after, &report)
}

/// The document of [`compare`] alone, which names no files.
pub fn document(
    (path, study): (&Path, &LoadedStudy),
    table: Option<&FromSheet>,
    console: &Console,
) -> Result<Value, Failure> {
    Ok(json::document(&StudyReport {
        comparison: Compared::with_table(path, study, table, console)?.comparison,
        made_of: MadeOf::files(&study.files),
        files: Vec::new(),
    })?)
}

/// The folder that a verb writes into.
pub fn target(output: Option<&PathBuf>, name: &str, verb: &str) -> PathBuf {
    output
        .cloned()
        .unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-{verb}")))
}

/// Which files were written, as the last line of a page.
pub fn listed(folder: &Path, files: &[String]) -> String {
    hanging(
        "",
        &format!("Files in {}: {}", folder.display(), files.join(" ")),
        2,
    )
}

/// A study, solved and compared with its measurements.
pub fn compared(path: &Path, sets: &[String], console: &Console) -> Result<StudyComparison, Failure> {
    Ok(Compared::new(path, &LoadedStudy::load(path, sets)?, console)?.comparison)
}

/// A study compared, and the campaign that it was compared by.
#[derive(Debug)]
pub struct Compared {
    /// Its cases, solved.
    pub campaign: Campaign,
    /// The comparison.
    pub comparison: StudyComparison,
}

/// Cases of a study whose wings a report shows; of more, some evenly among them.
const SHOWN: usize = 12;

impl Compared {
    /// Solves and compares.
    pub fn new(path: &Path, study: &LoadedStudy, console: &Console) -> Result<Compared, Failure> {
        let fault = |source: StudyError| Failure::OfStudy {
            study: path.to_path_buf(),
            source,
        };
        let campaign = Campaign::new(study, &[], console.progress()).map_err(fault)?;
        let comparison = compare_study(&campaign, &study.study.title).map_err(fault)?;
        Ok(Compared { campaign, comparison })
    }

    /// The same of a study that was made of a table, if it was: what looks wrong there is said first, what is assumed last.
    fn with_table(
        path: &Path,
        study: &LoadedStudy,
        table: Option<&FromSheet>,
        console: &Console,
    ) -> Result<Compared, Failure> {
        let mut compared = Compared::new(path, study, console)?;
        let words = &mut compared.comparison.words;
        words.splice(0..0, table.and_then(FromSheet::doubts));
        words.extend(table.and_then(FromSheet::assumed));
        Ok(compared)
    }

    /// What a report shows besides: the wings as stated and as calibrated, what the designs assume.
    pub fn parts(&self, study: &LoadedStudy, console: &Console) -> Result<StudyParts, Failure> {
        let mut calibrated = self.campaign.start();
        for found in &self.comparison.unknowns {
            put(&self.campaign, &mut calibrated, &found.unknown.name, found.value);
        }
        let mut wings = wings(&self.campaign, "as stated", &self.campaign.start(), console)?;
        if !self.comparison.unknowns.is_empty() {
            wings.extend(self::wings(&self.campaign, "calibrated", &calibrated, console)?);
        }
        Ok(StudyParts {
            wings,
            assumed: assumed(study),
            diagnosis: None,
        })
    }
}

/// The wings as stated, and with what a diagnosis holds most probable.
pub fn found(campaign: &Campaign, diagnosis: &Diagnosis, console: &Console) -> Result<Wings, Failure> {
    let mut wings = wings(campaign, "as stated", &campaign.start(), console)?;
    wings.extend(explained(campaign, diagnosis, console)?);
    Ok(wings)
}

/// The wings with what a diagnosis holds most probable, if it names an effect.
pub fn explained(campaign: &Campaign, found: &Diagnosis, console: &Console) -> Result<Wings, Failure> {
    if !matches!(found.verdict, Verdict::Effect | Verdict::Set) {
        return Ok(Wings::default());
    }
    let Some(first) = found
        .hypotheses
        .iter()
        .find(|hypothesis| !hypothesis.strengths.is_empty())
    else {
        return Ok(Wings::default());
    };
    let mut at = campaign.start();
    for strength in &first.strengths {
        put(campaign, &mut at, &strength.unknown, strength.value);
        let place = position(campaign, |unknown| is_place_of(unknown, &strength.unknown));
        if let (Some(found), Some(place)) = (&strength.place, place) {
            at[place] = found.value;
        }
    }
    let state = format!("with {}", first.effects.join(" + "));
    let mut wings = wings(campaign, &state, &at, console)?;
    wings
        .notes
        .push(format!("{state}: all else as stated, not calibrated anew."));
    Ok(wings)
}

fn put(campaign: &Campaign, at: &mut [f64], name: &str, value: f64) {
    if let Some(index) = position(campaign, |unknown| unknown.name == name) {
        at[index] = value;
    }
}

fn position(campaign: &Campaign, is_it: impl Fn(&Unknown) -> bool) -> Option<usize> {
    campaign.unknowns().iter().position(is_it)
}

fn is_place_of(unknown: &Unknown, strength: &str) -> bool {
    matches!(&unknown.kind, UnknownKind::Place { of, .. } if of == strength)
}

/// The wings of a campaign with these values of its unknowns, as far as they have a solution there.
fn wings(campaign: &Campaign, state: &str, at: &[f64], console: &Console) -> Result<Wings, Failure> {
    let count = campaign.cases().len();
    let mut wings = Wings::default();
    if count > SHOWN {
        let words = format!("{SHOWN} of {count} cases are shown {state}, evenly among them.");
        wings.notes.push(words);
    }
    for place in 0..count.min(SHOWN) {
        let index = place * count / count.min(SHOWN);
        let case = &campaign.cases()[index];
        console
            .progress()
            .say(format_args!("{}: {} {state}", campaign.name, case.name));
        let solved = campaign.solved_at(index, at);
        console.progress().check()?;
        let name = format!("{}, {state}", case.name);
        match solved {
            Ok(solved) => {
                let found = &solved.at;
                let mut wing = Wing::of_solution(&name, &found.design, &found.planform, &found.solution);
                wing.measured = Measured::of_rows(&case.rows);
                wings.shown.push(wing);
            }
            Err(error) => wings.notes.push(format!("Not shown: {name}: {error}")),
        }
    }
    Ok(wings)
}

/// Designs of a study with what each assumes, each once.
pub fn assumed(loaded: &LoadedStudy) -> Vec<(String, Vec<crate::input::Assumption>)> {
    let mut designs = BTreeMap::new();
    for case in &loaded.cases {
        let design = &case.loaded.design;
        designs
            .entry(design.name.clone())
            .or_insert_with(|| design.assumptions());
    }
    designs.into_iter().collect()
}
