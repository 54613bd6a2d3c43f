//! A table of readings as a user gives it: its file, and the design that it was measured on.

use std::path::{Path, PathBuf};

use super::study::Names;
use super::{Sheet, Sigmas};
use crate::input::error::InputError;
use crate::input::study::LoadedStudy;

/// A table, read for a design, and where both came from.
#[derive(Debug)]
pub struct DesignReadings {
    /// What it holds.
    pub sheet: Sheet,
    /// The design file.
    pub design: PathBuf,
    /// The table.
    pub table: PathBuf,
    /// Standard deviations that were given for readings that state none.
    pub sigma: Sigmas,
    /// The conditions that no fit sees, by the names of their cases.
    pub held_out: Vec<String>,
}

impl DesignReadings {
    /// Reads a table.
    ///
    /// # Errors
    /// As [`Sheet::load`], or if the design is a study.
    pub fn load(table: &Path, design: &Path, sigma: &Sigmas) -> Result<DesignReadings, InputError> {
        if LoadedStudy::is_study(design)? {
            return Err(InputError::about_file(
                &design.display().to_string(),
                "is a study, which names its own readings",
                "Give a design, or leave --with out",
            ));
        }
        Ok(DesignReadings {
            sheet: Sheet::load(table, design, sigma)?,
            design: design.to_path_buf(),
            table: table.to_path_buf(),
            sigma: sigma.clone(),
            held_out: Vec::new(),
        })
    }

    /// The same with conditions that no fit sees, so that they test it: each as the table names it (`22 Hz`) or as its case (`22hz`).
    ///
    /// # Errors
    /// If there is no such condition, or none is left to be fitted.
    pub fn holding_out(mut self, conditions: &[String]) -> Result<DesignReadings, InputError> {
        let cases: Vec<&String> = self
            .sheet
            .families
            .iter()
            .flat_map(|family| &family.cases)
            .collect();
        let refused = |message: String, cure: &str| Err(InputError::about_file("--hold-out", message, cure));
        let names = || {
            cases
                .iter()
                .map(|case| case.as_str())
                .collect::<Vec<_>>()
                .join(", ")
        };
        let mut held_out = Vec::new();
        for condition in conditions {
            match cases.iter().find(|case| plain(case) == plain(condition)) {
                Some(case) => held_out.push((*case).clone()),
                None => {
                    return refused(
                        format!("{condition} is no condition of {}", self.sheet.measurement.file),
                        &format!("One of {}", names()),
                    );
                }
            }
        }
        if cases.iter().all(|case| held_out.contains(case)) {
            let cure = "Leave at least one condition to be fitted";
            return refused(format!("holds out all there are: {}", names()), cure);
        }
        self.held_out = held_out;
        Ok(self)
    }

    /// What looks wrong in the table, to be said before any answer; none if nothing does.
    pub fn doubts(&self) -> Option<String> {
        let doubts = self.sheet.doubts.join(" ");
        (!doubts.is_empty())
            .then(|| format!("Check the table first, all else is of it as it stands: {doubts}"))
    }

    /// What is assumed, for the document: who reads that has not seen it; none if nothing is.
    pub fn assumed(&self) -> Option<String> {
        let assumed = self
            .sheet
            .assumed
            .iter()
            .map(|[what, is]| format!("{what}: {is}"));
        let assumed: Vec<String> = assumed.collect();
        (!assumed.is_empty()).then(|| format!("Not in the table, so taken to be: {}.", assumed.join("; ")))
    }

    /// The study of the table, as `washout init --study --readings` writes it, without a file; `sets` change the design.
    ///
    /// # Errors
    /// As [`LoadedStudy::load`].
    pub fn study(&self, sets: &[String]) -> Result<LoadedStudy, InputError> {
        let name = self.name();
        let path = PathBuf::from(format!("{name}.toml"));
        let names = Names {
            study: &name,
            design: &self.design.display().to_string(),
            readings: &self.sheet.measurement.file,
        };
        // what is set is known
        let design = self.sheet.loaded.design.with(sets)?;
        let text = self.sheet.study(names, &self.held_out, &design.assumptions());
        LoadedStudy::with_readings(&path, &text, sets, &self.sheet.measurement)
    }

    /// The text of the study, as [`Sheet::study`] has it.
    pub fn text(&self, names: Names) -> String {
        let assumed = self.sheet.loaded.design.assumptions();
        self.sheet.study(names, &self.held_out, &assumed)
    }

    /// Name of the study: of its design and its table.
    pub fn name(&self) -> String {
        let stem = self.table.file_stem().unwrap_or_default().to_string_lossy();
        let plain = |c: char| {
            if c.is_ascii_alphanumeric() || c == '_' {
                c
            } else {
                '-'
            }
        };
        let stem: String = stem.chars().map(plain).collect();
        format!("{}-{stem}", self.sheet.loaded.design.name)
    }
}

/// A condition without what may be written in several ways: `22 Hz, 35 deg` and `22hz-35deg` are one, `10 m/s` and `10m_s`. A stroke before a
/// number that no letter or digit precedes is its sign.
fn plain(condition: &str) -> String {
    let mut plain = String::new();
    let mut before = ' ';
    let mut rest = condition.chars().peekable();
    while let Some(c) = rest.next() {
        let is_sign = c == '-'
            && !before.is_alphanumeric()
            && rest
                .peek()
                .is_some_and(|next| next.is_ascii_digit() || *next == '.');
        if c.is_alphanumeric() || c == '.' || is_sign {
            plain.extend(c.to_lowercase());
        }
        before = c;
    }
    plain
}
