//! A study solved and compared with its measurements, with the campaign that it was compared by.

use std::path::Path;

use crate::input::Design;
use crate::input::sheet::DesignReadings;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::{Campaign, Forward, StudyError};

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

    /// Values of the campaign's unknowns as they were calibrated.
    pub fn calibrated(&self) -> Vec<f64> {
        let mut at = self.campaign.start();
        for found in &self.comparison.unknowns {
            let mut unknowns = self.campaign.unknowns().iter();
            let place = unknowns.position(|unknown| unknown.name == found.unknown.name);
            place.into_iter().for_each(|place| at[place] = found.value);
        }
        at
    }

    /// The design of each wing as calibrated, with the effects of the study in it: of the first case of the wing, what only the reading
    /// has left out. Paths in it are whole.
    ///
    /// # Errors
    /// If a value is out of the range of its key.
    pub fn calibrated_designs(&self, study: &LoadedStudy) -> Result<Vec<Design>, StudyError> {
        let at = self.calibrated();
        let mut designs: Vec<Design> = Vec::new();
        for (index, case) in study.cases.iter().enumerate() {
            let own = &case.loaded.design;
            if designs.iter().any(|known| known.name == own.name) {
                continue;
            }
            let mut design = self.campaign.design_at(index, &at)?;
            design.measured = None;
            let home = case.loaded.path.parent().unwrap_or(Path::new(""));
            let files = [design.air.table.as_mut(), design.mesh.file.as_mut()];
            for file in files.into_iter().flatten() {
                let whole = std::path::absolute(home.join(&*file));
                *file = whole.map_or(file.clone(), |whole| whole.display().to_string());
            }
            designs.push(design);
        }
        Ok(designs)
    }

    /// The same of a study that was made of a table: what looks wrong there is said first, what is assumed last.
    pub fn of_table(mut self, table: &DesignReadings) -> ComparedStudy {
        let words = &mut self.comparison.words;
        words.splice(0..0, table.doubts());
        words.extend(table.assumed());
        self
    }
}
