//! A study solved and compared with its measurements, with the campaign that it was compared by.

use crate::input::sheet::DesignReadings;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::{Campaign, StudyError};

use super::study::compare_study;
use super::study_comparison::StudyComparison;

/// A study compared.
#[derive(Debug)]
pub struct ComparedStudy {
    /// Its cases, solved.
    pub campaign: Campaign,
    /// Measured minus modelled.
    pub comparison: StudyComparison,
}

impl ComparedStudy {
    /// Solves and compares.
    ///
    /// # Errors
    /// As [`Campaign::new`] and [`compare_study`].
    pub fn new(study: &LoadedStudy, progress: &Progress) -> Result<ComparedStudy, StudyError> {
        let campaign = Campaign::new(study, &[], progress)?;
        let comparison = compare_study(&campaign, &study.study.title)?;
        Ok(ComparedStudy { campaign, comparison })
    }

    /// The same of a study that was made of a table: what looks wrong there is said first, what is assumed last.
    pub fn of_table(mut self, table: &DesignReadings) -> ComparedStudy {
        let words = &mut self.comparison.words;
        words.splice(0..0, table.doubts());
        words.extend(table.assumed());
        self
    }
}
