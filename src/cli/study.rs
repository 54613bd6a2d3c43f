//! Studies on the command line: loaded, solved, compared.

use std::path::Path;

use crate::compare::study::compare_study;
use crate::export::study::page;
use crate::input::study::LoadedStudy;
use crate::study::{Campaign, StudyError};

use super::{Console, Failure};

/// `washout compare STUDY`.
pub fn compare(path: &Path, sets: &[String], console: &Console) -> Result<(), Failure> {
    let study = LoadedStudy::load(path, sets)?;
    let fault = |source: StudyError| Failure::OfStudy {
        study: path.to_path_buf(),
        source,
    };
    let campaign = Campaign::new(&study, &[], console.progress()).map_err(fault)?;
    let comparison = compare_study(&campaign, &study.study.title).map_err(fault)?;
    console.result(&page(&comparison), &comparison)
}
