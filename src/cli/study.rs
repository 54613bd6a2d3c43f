//! Studies on the command line: loaded, solved, compared.

use std::path::{Path, PathBuf};

use crate::compare::StudyComparison;
use crate::compare::study::compare_study;
use crate::export::pictures::write::add_study;
use crate::export::run::RunFolder;
use crate::export::study::{StudyReport, page};
use crate::input::study::LoadedStudy;
use crate::study::{Campaign, StudyError};

use super::{Console, Failure};

/// The document that lists the files of a comparison.
pub const COMPARISON: &str = "comparison.json";

/// `washout compare STUDY`: solves, compares, writes into `output` or `output/NAME-compare`.
pub fn compare(
    path: &Path,
    sets: &[String],
    output: Option<&PathBuf>,
    console: &Console,
) -> Result<(), Failure> {
    let study = LoadedStudy::load(path, sets)?;
    let target = target(output, &study.study.name, "compare");
    let mut folder = RunFolder::listed_by(&target, COMPARISON)?;
    let comparison = compared_loaded(path, &study, console)?;
    add_study(&mut folder, &comparison)?;
    let report = StudyReport {
        comparison,
        files: folder.listed(),
    };
    folder.add_summary(&report)?;
    console.progress().check()?;
    let written = folder.commit()?;
    let page = format!(
        "{}\n{}",
        page(&report.comparison),
        listed(&written, &report.files)
    );
    console.result(&page, &report)
}

/// The folder that a verb writes into.
pub fn target(output: Option<&PathBuf>, name: &str, verb: &str) -> PathBuf {
    output
        .cloned()
        .unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-{verb}")))
}

/// Which files were written, as the last line of a page.
pub fn listed(folder: &Path, files: &[String]) -> String {
    format!("Files in {}: {}\n", folder.display(), files.join(" "))
}

/// A study, solved and compared with its measurements.
pub fn compared(path: &Path, sets: &[String], console: &Console) -> Result<StudyComparison, Failure> {
    compared_loaded(path, &LoadedStudy::load(path, sets)?, console)
}

fn compared_loaded(path: &Path, study: &LoadedStudy, console: &Console) -> Result<StudyComparison, Failure> {
    let fault = |source: StudyError| Failure::OfStudy {
        study: path.to_path_buf(),
        source,
    };
    let campaign = Campaign::new(study, &[], console.progress()).map_err(fault)?;
    compare_study(&campaign, &study.study.title).map_err(fault)
}
