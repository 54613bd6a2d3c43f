//! Studies on the command line: loaded, solved, compared.

use std::path::Path;

use crate::compare::StudyComparison;
use crate::compare::study::compare_study;
use crate::export::study::page;
use crate::input::study::LoadedStudy;
use crate::study::{Campaign, StudyError};

use super::{Console, Failure};

/// `washout compare STUDY`.
pub fn compare(path: &Path, sets: &[String], console: &Console) -> Result<(), Failure> {
    let comparison = compared(path, sets, console)?;
    console.result(&page(&comparison), &comparison)
}

/// A study, solved and compared with its measurements.
pub fn compared(path: &Path, sets: &[String], console: &Console) -> Result<StudyComparison, Failure> {
    let study = LoadedStudy::load(path, sets)?;
    let fault = |source: StudyError| Failure::OfStudy {
        study: path.to_path_buf(),
        source,
    };
    let campaign = Campaign::new(&study, &[], console.progress()).map_err(fault)?;
    compare_study(&campaign, &study.study.title).map_err(fault)
}
