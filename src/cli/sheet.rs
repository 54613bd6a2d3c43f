//! A table of readings on the command line: what was understood of it, and the study that it makes.

use std::path::{Path, PathBuf};

use crate::export::measurement::measurement_csv;
use crate::input::sheet::Sheet;
use crate::input::sheet::study::Names;
use crate::input::study::LoadedStudy;
use crate::page::text::{Table, significant, wrapped};

use super::Failure;
use super::design_arguments::beside;

/// A table, read for a design, and where it came from.
#[derive(Debug)]
pub struct FromSheet {
    /// What it holds.
    pub sheet: Sheet,
    /// The design file.
    pub design: PathBuf,
    /// The table.
    pub table: PathBuf,
    /// Standard deviation that was given for its readings.
    sigma: Option<f64>,
}

/// A number of an option, with a decimal point or comma as tables have it.
///
/// # Errors
/// In words, if it is none.
pub fn number(text: &str) -> Result<f64, String> {
    let plain = text.trim().replace(',', ".");
    plain
        .parse()
        .map_err(|_| "is no number; write e.g. 0.4 or 0,4".to_string())
}

/// The files of a study that was made of a table.
pub struct Files {
    /// The study.
    pub study: String,
    /// Its measurement file.
    pub readings: String,
}

impl FromSheet {
    /// Reads a table.
    ///
    /// # Errors
    /// As [`Sheet::load`], or if `sigma` is no standard deviation.
    pub fn load(table: &Path, design: &Path, sigma: Option<f64>) -> Result<FromSheet, Failure> {
        if sigma.is_some_and(|sigma| !(1e-9..=1e9).contains(&sigma)) {
            return Err(Failure::Option {
                option: "--sigma",
                reason: "must lie in 1e-9 … 1e9: one standard deviation of a reading, in its unit"
                    .to_string(),
            });
        }
        if LoadedStudy::is_study(design)? {
            return Err(Failure::Option {
                option: "--with",
                reason: format!(
                    "{} is a study, which names its own readings; give a design, or leave --with out",
                    design.display()
                ),
            });
        }
        Ok(FromSheet {
            sheet: Sheet::load(table, design, sigma)?,
            design: design.to_path_buf(),
            table: table.to_path_buf(),
            sigma,
        })
    }

    /// What was understood, what is assumed and what looks wrong, before anything is solved.
    pub fn understood(&self) -> String {
        let sheet = &self.sheet;
        let mut text = format!("What {} says\n", sheet.measurement.file);
        let pairs = |heads: [&'static str; 2], rows: &[[String; 2]]| {
            let mut table = Table::new(heads);
            rows.iter().for_each(|row| table.row(row.clone()));
            table.render()
        };
        text += &pairs(["column", "is"], &sheet.understood);
        let mut cases = Table::new(["condition", "sets", "readings", "stations mm", "values"]);
        for family in &sheet.families {
            for case in &family.cases {
                let rows = sheet.measurement.rows.iter().filter(|row| row.case == *case);
                let rows: Vec<_> = rows.collect();
                let ends = |values: Vec<f64>| match values.iter().copied().reduce(f64::min) {
                    None => String::new(),
                    Some(least) => {
                        let most = values.iter().copied().fold(least, f64::max);
                        format!("{} … {}", significant(least, 4), significant(most, 4))
                    }
                };
                let units: Vec<&str> = rows.iter().map(|row| row.channel.unit()).collect();
                let is_one = units.iter().all(|unit| *unit == units[0]);
                cases.row([
                    case.clone(),
                    family
                        .set
                        .iter()
                        .filter_map(|set| Some(set.split_once('=')?.0))
                        .collect::<Vec<_>>()
                        .join(", "),
                    rows.len().to_string(),
                    ends(rows.iter().filter_map(|row| row.r_mm).collect()),
                    match is_one {
                        true => format!(
                            "{} {}",
                            ends(rows.iter().map(|row| row.value).collect()),
                            units[0]
                        ),
                        false => "several channels".to_string(),
                    },
                ]);
            }
        }
        text += &format!("\n{}", cases.render());
        if !sheet.assumed.is_empty() {
            text += "\nNot in the table, so taken to be\n";
            text += &pairs(["what", "is"], &sheet.assumed);
        }
        for doubt in &sheet.doubts {
            text += &format!("\n{}", wrapped(&format!("Check: {doubt}"), 0));
        }
        text
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
    pub fn study(&self, sets: &[String]) -> Result<LoadedStudy, Failure> {
        let name = self.name();
        let path = PathBuf::from(format!("{name}.toml"));
        let text = self.sheet.study(Names {
            study: &name,
            design: &self.design.display().to_string(),
            readings: &self.sheet.measurement.file,
        });
        Ok(LoadedStudy::with_readings(
            &path,
            &text,
            sets,
            &self.sheet.measurement,
        )?)
    }

    /// The texts of the study and of its measurement file, for a study of this name in this folder.
    ///
    /// # Errors
    /// If the readings cannot be put into words.
    pub fn files(&self, name: &str, folder: &Path) -> Result<Files, Failure> {
        let study = self.sheet.study(Names {
            study: name,
            design: &beside(&folder.join(name), &self.design).display().to_string(),
            readings: &format!("{name}-measured.csv"),
        });
        let table = &self.sheet.measurement;
        let mut comments = vec![format!("source: {}", table.file)];
        comments.extend(table.comments.iter().cloned());
        let readings = measurement_csv(&comments, &table.rows)?;
        Ok(Files { study, readings })
    }

    /// The command that writes the study.
    pub fn to_keep(&self) -> String {
        let sigma = self
            .sigma
            .map_or(String::new(), |sigma| format!(" --sigma {sigma}"));
        format!(
            "  washout init {} --study --design {} --readings {}{sigma}\n",
            self.name(),
            self.design.display(),
            self.table.display()
        )
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
