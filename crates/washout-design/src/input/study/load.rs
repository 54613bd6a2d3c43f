//! From a study file to cases with their designs and measured rows.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::alternative::{self, Alternative, Tables};
use super::expand::{CaseNumber, Form, case_numbers, put_in};
use super::known::{known_designs, known_inputs, known_runs};
use super::unused::{UnusedRows, unused};
use super::{Case, Purpose, Study};
use crate::input::check::{format_is_one, refuse};
use crate::input::design::Design;
use crate::input::document::Node;
use crate::input::error::{InputError, Problem};
use crate::input::load::Loaded;
use crate::input::measurement::{Made, Measurement, Row, STATION_COLUMNS, refuse_planned};
use crate::input::{file, form, keys};
use crate::origin::InputFile;

/// A study with all that its file refers to.
#[derive(Debug, Clone)]
pub struct LoadedStudy {
    /// The study.
    pub study: Study,
    /// The study file.
    pub path: PathBuf,
    /// Its cases, families written out.
    pub cases: Vec<LoadedCase>,
    /// Experiments that could be made next, families written out; their values are yet to be measured.
    pub experiments: Vec<LoadedCase>,
    /// Rows of its measurement files that none of them uses.
    pub unused: Vec<UnusedRows>,
    /// The study file and all that it names, with what they held.
    pub files: Vec<InputFile>,
}

/// A design at one operating point, with its measured rows.
#[derive(Debug, Clone)]
pub struct LoadedCase {
    /// Its table among those of the study, from 0.
    pub table: usize,
    /// Name: that of the measured case.
    pub name: String,
    /// The form of its family, such as `bending-{mass}`; its name, if it stands alone.
    pub family: String,
    /// The numbers in which it differs from others of its family.
    pub numbers: Vec<CaseNumber>,
    /// What changes the design for this case, as `--set` takes it.
    pub sets: Vec<String>,
    /// The design with these changes.
    pub loaded: Loaded,
    /// The measurement file, as the user named it.
    pub measurement: String,
    /// How the measurement was made, if a program made it.
    pub made: Option<Made>,
    /// The measured rows that count.
    pub rows: Vec<Row>,
    /// Whether it is kept out of every fit.
    pub is_held_out: bool,
    /// The measured case to which its ratios refer.
    pub reference: Option<String>,
}

impl LoadedStudy {
    /// Whether a file is a study: it has cases, which a design has not.
    ///
    /// # Errors
    /// If the file cannot be read or is no TOML.
    pub fn is_study(path: &Path) -> Result<bool, InputError> {
        let text = file::read_text(path, "design or study")?;
        let root = Node::parse_file(&file::shown(path), &text)?;
        Ok(root.get("case").is_some())
    }

    /// Reads a study with the designs and measurements that it names; `sets` change every design.
    ///
    /// # Errors
    /// Whatever is wrong with it, with place and cure.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// use washout::input::study::LoadedStudy;
    ///
    /// let study = LoadedStudy::load(Path::new("studies/paper-wings.toml"), &[])?;
    /// assert_eq!(study.cases.len(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn load(path: &Path, sets: &[String]) -> Result<LoadedStudy, InputError> {
        let (text, input) = file::read_input(path, "study file")?;
        LoadedStudy::of_measured(path, &text, sets, input)
    }

    /// Reads a study from its text as if it stood at `path`.
    ///
    /// # Errors
    /// As [`LoadedStudy::load`].
    pub fn from_text(path: &Path, text: &str, sets: &[String]) -> Result<LoadedStudy, InputError> {
        let input = InputFile::new(file::shown(path), text.as_bytes());
        LoadedStudy::of_measured(path, text, sets, input)
    }

    /// Reads a study from its text, with readings that are at hand: they stand for the file of their name.
    ///
    /// # Errors
    /// As [`LoadedStudy::load`].
    pub fn with_readings(
        path: &Path,
        text: &str,
        sets: &[String],
        readings: &Measurement,
    ) -> Result<LoadedStudy, InputError> {
        let input = InputFile::new(file::shown(path), text.as_bytes());
        LoadedStudy::from_planned(path, text, sets, input, Some(readings))
    }

    fn of_measured(
        path: &Path,
        text: &str,
        sets: &[String],
        input: InputFile,
    ) -> Result<LoadedStudy, InputError> {
        let study = LoadedStudy::from_planned(path, text, sets, input, None)?;
        for case in &study.cases {
            refuse_planned(&case.measurement, &case.rows)?;
        }
        Ok(study)
    }

    /// Reads a study of which measurements may still be missing.
    ///
    /// # Errors
    /// As [`LoadedStudy::load`].
    pub fn load_planned(path: &Path, sets: &[String]) -> Result<LoadedStudy, InputError> {
        let (text, input) = file::read_input(path, "study file")?;
        LoadedStudy::from_planned(path, &text, sets, input, None)
    }

    fn from_planned(
        path: &Path,
        text: &str,
        sets: &[String],
        input: InputFile,
        readings: Option<&Measurement>,
    ) -> Result<LoadedStudy, InputError> {
        LoadedStudy::of_tables(path, text, sets, input, (readings, None))
    }

    /// The study with these alternatives of it; `sets` change every design, as they did when it was read.
    ///
    /// # Errors
    /// As [`LoadedStudy::load`].
    pub fn with_alternatives(
        &self,
        chosen: &[&Alternative],
        sets: &[String],
    ) -> Result<LoadedStudy, InputError> {
        let (text, input) = file::read_input(&self.path, "study file")?;
        let tables = self.tables_with(chosen);
        LoadedStudy::of_tables(&self.path, &text, sets, input, (None, Some(tables)))
    }

    fn of_tables(
        path: &Path,
        text: &str,
        sets: &[String],
        input: InputFile,
        (readings, tables): (Option<&Measurement>, Option<Tables>),
    ) -> Result<LoadedStudy, InputError> {
        let mut root = Node::parse_file(&file::shown(path), text)?;
        root.rename("slop", "discrepancy");
        if root.get("planform").is_some() && root.get("case").is_none() {
            return Err(InputError::about_file(
                &file::shown(path),
                "is a design, not a study",
                "`washout init NAME --study --design DESIGN --readings TABLE` makes a study of it and of a table of readings. `washout diagnose` \
                 and `compare` take the two as they are: DESIGN --with TABLE",
            ));
        }
        format_is_one(&root)?;
        form::check(&root, keys::study())?;
        let mut study = Study::deserialize(&root.to_json()).map_err(|error| {
            let message = format!("cannot be read: {error}");
            InputError::new(root.file(), "", "", Problem::Syntax { message }, "")
        })?;
        check(&study, &root)?;
        if let Some((cases, experiments)) = tables {
            (study.case, study.experiment) = (cases, experiments);
        }
        let mut measured: Vec<Measurement> = Vec::new();
        let mut families = |tables: &[Case], word: &str| {
            let mut cases = Vec::new();
            for (index, case) in tables.iter().enumerate() {
                let table = format!("{word}[{index}]");
                let from = Origin {
                    path,
                    root: &root,
                    sets,
                    readings,
                };
                measured.push(family(case, (&table, index), &from, &mut cases)?);
            }
            Ok(cases)
        };
        let cases = families(&study.case, "case")?;
        let experiments = families(&study.experiment, "experiment")?;
        let designs: Vec<&Design> = cases
            .iter()
            .map(|case: &LoadedCase| &case.loaded.design)
            .collect();
        known_designs(&study, &root, &designs)?;
        known_inputs(&study, &root, &designs)?;
        let rows = cases.iter().chain(&experiments).flat_map(|case| &case.rows);
        known_runs(&study, &root, rows)?;
        Ok(LoadedStudy {
            unused: unused_rows(&study, &measured, cases.iter().chain(&experiments)),
            files: all_files(input, &measured, cases.iter().chain(&experiments)),
            study,
            path: path.to_path_buf(),
            cases,
            experiments,
        })
    }
}

/// Rows of the measurement files, one for each table of cases, that no case uses.
fn unused_rows<'a>(
    study: &Study,
    measured: &[Measurement],
    cases: impl Iterator<Item = &'a LoadedCase> + Clone,
) -> Vec<UnusedRows> {
    let tables = || study.case.iter().chain(&study.experiment).zip(measured);
    let mut found = Vec::new();
    for (place, file) in measured.iter().enumerate() {
        if measured[..place].iter().any(|known| known.file == file.file) {
            continue;
        }
        let of_file = cases.clone().filter(|case| case.measurement == file.file);
        let used: Vec<&str> = of_file.map(|case| case.name.as_str()).collect();
        let tables = tables().filter(|(_, own)| own.file == file.file);
        let forms: Vec<&str> = tables.map(|(case, _)| case.measured.as_str()).collect();
        found.extend(unused(file, &used, &forms));
    }
    found
}

/// The study file and all that it names, each once.
fn all_files<'a>(
    input: InputFile,
    measured: &[Measurement],
    cases: impl Iterator<Item = &'a LoadedCase>,
) -> Vec<InputFile> {
    let measured = measured.iter().filter_map(|file| file.input.as_ref());
    let named = measured.chain(cases.flat_map(|case| &case.loaded.files));
    let mut files = vec![input];
    for file in named {
        if !files.contains(file) {
            files.push(file.clone());
        }
    }
    files
}

fn check(study: &Study, root: &Node) -> Result<(), InputError> {
    let name = &study.name;
    if name.is_empty()
        || !name
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "_-".contains(c))
    {
        let cure = "Use letters, digits, - and _, e.g. name = \"my-study\"";
        return refuse(root, "name", "must be usable as the name of a folder", &[], cure);
    }
    if study.case.is_empty() {
        return refuse(root, "case", "there is no case", &[], "Add a table [[case]]");
    }
    for (index, uncertain) in study.uncertain.iter().enumerate() {
        if let Some([low, high]) = uncertain.range {
            let inside = uncertain.mean.is_none_or(|mean| low <= mean && mean <= high);
            if low >= high || !inside {
                let key = format!("uncertain[{index}].range");
                let cure = "Give the lower end first, and the mean between both";
                return refuse(root, &key, "is no range around the mean", &["mean"], cure);
            }
        }
    }
    alternative::check(study, root)
}

/// What the tables of a study are read from.
struct Origin<'a> {
    path: &'a Path,
    root: &'a Node,
    sets: &'a [String],
    readings: Option<&'a Measurement>,
}

impl Origin<'_> {
    /// The path of a file that a table of cases names.
    fn beside(&self, table: &str, key: &str, name: &str) -> Result<PathBuf, InputError> {
        let path = file::beside(self.path, name);
        if path.is_file() {
            return Ok(path);
        }
        let cure = format!(
            "Looked for {}; paths are relative to the study",
            file::shown(&path)
        );
        refuse(self.root, &format!("{table}.{key}"), "no such file", &[], cure)
    }
}

/// Adds the cases of one table; gives all that its measurement file holds.
fn family(
    case: &Case,
    (table, number): (&str, usize),
    from: &Origin,
    cases: &mut Vec<LoadedCase>,
) -> Result<Measurement, InputError> {
    let design_path = from.beside(table, "design", &case.design)?;
    let all = match from.readings.filter(|readings| readings.file == case.measurement) {
        Some(readings) => readings.clone(),
        None => Measurement::load(&from.beside(table, "measurement", &case.measurement)?)?,
    };
    let form = match Form::parse(&case.measured) {
        Ok(form) => form,
        Err(message) => {
            let cure = "Write e.g. measured = \"bending-{mass}\"";
            return refuse(from.root, &format!("{table}.measured"), message, &[], cure);
        }
    };
    for (name, numbers) in members(case, table, from.root, &all, &form)? {
        let changes = changes(case, table, from, &numbers)?;
        let loaded = Design::load(&design_path, &changes)?;
        let measurement = all.case(name);
        measurement.check_stations(&loaded.design, STATION_COLUMNS)?;
        let counts = |row: &Row| {
            case.channels
                .as_ref()
                .is_none_or(|channels| channels.contains(&row.channel))
        };
        cases.push(LoadedCase {
            table: number,
            name: name.to_string(),
            family: case.measured.clone(),
            numbers: case_numbers(&case.set, &numbers),
            sets: changes,
            loaded,
            measurement: measurement.file.clone(),
            made: measurement.made,
            rows: measurement.rows.into_iter().filter(counts).collect(),
            is_held_out: case.purpose == Purpose::HeldOut || case.held_out.iter().any(|held| held == name),
            reference: case.reference.clone(),
        });
    }
    Ok(all)
}

/// A measured case of a family: its name, and the numbers that its form has there.
type Member<'a> = (&'a str, Vec<(&'a str, f64)>);

/// The measured cases of a family, at least one, among them all that are held out.
fn members<'a>(
    case: &Case,
    table: &str,
    root: &Node,
    all: &'a Measurement,
    form: &Form<'a>,
) -> Result<Vec<Member<'a>>, InputError> {
    let names = all.cases();
    let found: Vec<Member> = names
        .iter()
        .filter_map(|name| Some((*name, form.read(name)?)))
        .collect();
    if found.is_empty() {
        let shown = names.iter().take(8).copied().collect::<Vec<_>>().join(", ");
        let more = if names.len() > 8 { ", …" } else { "" };
        let cure = format!("These are the cases of {}: {shown}{more}", all.file);
        let message = "no measured case has this name";
        return refuse(root, &format!("{table}.measured"), message, &[], cure);
    }
    let mut held_out = case.held_out.iter();
    if let Some(other) = held_out.find(|held| !found.iter().any(|(name, _)| name == held)) {
        let cure = format!("Name cases of the form {}", case.measured);
        let message = format!("{other} is none of these cases");
        return refuse(root, &format!("{table}.held_out"), message, &["measured"], cure);
    }
    Ok(found)
}

/// What changes the design for a case with these numbers: settings of the case, then of the user.
fn changes(
    case: &Case,
    table: &str,
    from: &Origin,
    numbers: &[(&str, f64)],
) -> Result<Vec<String>, InputError> {
    let mut changes = Vec::new();
    for set in &case.set {
        match put_in(set, numbers) {
            Ok(change) => changes.push(change),
            Err(message) => {
                let cure = "Write e.g. set = [\"load[0].mass_kg={mass}\"] with measured = \"bending-{mass}\"";
                return refuse(from.root, &format!("{table}.set"), message, &["measured"], cure);
            }
        }
    }
    changes.extend_from_slice(from.sets);
    Ok(changes)
}
