//! What was opened, a design or a study, and the wing that it makes of what was moved.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;

use crate::input::measurement::Measurement;
use crate::input::study::{LoadedCase, LoadedStudy, Uncertain};
use crate::input::{Design, InputError, Loaded};
use crate::study::case::PreparedCase;
use crate::wing::WingModel;

use super::inputs::{Input, Prior, inputs};
use super::refusal::Refusal;
use super::values::{Step, StudyText, Values};

/// Nodes of a mesh that the page follows: a solve of it takes a GB and some ten seconds. What is moved may ask for any mesh.
const MOST_NODES: usize = 20_000;

/// A file that was opened.
#[derive(Debug)]
pub struct Opened {
    /// The file as it was named.
    pub path: PathBuf,
    /// What it held.
    pub text: String,
    /// What changes it besides numbers: `key=word`.
    pub words: Vec<String>,
    /// What it is.
    pub what: What,
    /// Where its readings come from, if it was made of a table and stands in no file yet.
    pub readings: Option<Readings>,
}

/// Readings of a table that a study was made of.
#[derive(Debug)]
pub struct Readings {
    /// As read, under the name by which the study has them.
    pub measured: Measurement,
    /// The design.
    pub design: PathBuf,
    /// Where the table is put when the study is saved.
    pub table: PathBuf,
    /// What the table holds.
    pub bytes: Arc<[u8]>,
}

/// A design or a study.
#[derive(Debug)]
pub enum What {
    /// A design, as read.
    Design(Box<Loaded>),
    /// A study, as read.
    Study(Box<LoadedStudy>),
}

/// A case that can be shown.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Whether it is kept out of fits.
    pub held_out: bool,
    /// Name of its wing.
    pub wing: String,
    /// Root mean square error of its twists as the model is calibrated, deg; none while that is not known.
    pub rms_deg: Option<f64>,
    /// Sum of squares of its errors in sigma.
    pub chi2: Option<f64>,
}

/// A wing that is to be solved, with what was measured on it.
#[derive(Debug, Clone)]
pub struct CaseWing {
    /// Name of the case.
    pub name: String,
    /// The wing.
    pub model: WingModel,
    /// Its measured rows, if there are any.
    pub measured: Option<Measurement>,
}

impl Opened {
    /// Opens a file; `sets` change it, as the command line has them.
    ///
    /// # Errors
    /// As [`Design::load`] and [`LoadedStudy::load`].
    pub fn open(path: &Path, sets: &[String]) -> Result<(Opened, Values), Refusal> {
        let (mut values, mut words) = (Values::default(), Vec::new());
        let is_study = LoadedStudy::is_study(path)?;
        for set in sets {
            match number_of(set) {
                Some((key, value)) => match strength_key(&key).filter(|_| !is_study) {
                    Some(effect) => values.effects.insert(effect.to_string(), value),
                    None => values.numbers.insert(key, value),
                },
                None => {
                    words.push(set.clone());
                    None
                }
            };
        }
        let all = [words.clone(), values.sets()].concat();
        let what = match is_study {
            true => What::Study(Box::new(LoadedStudy::load(path, &all)?)),
            false => What::Design(Box::new(Design::load(path, &all)?)),
        };
        let text = std::fs::read_to_string(path)
            .map_err(|error| Refusal::new(format!("{}: {error}", path.display())))?;
        let opened = Opened {
            path: path.to_path_buf(),
            words,
            what,
            text: text.clone(),
            readings: None,
        };
        if is_study {
            values.study = Some(Arc::new(opened.study(text, Vec::new())?));
        }
        Ok((opened, values))
    }

    /// A study of this text that a table makes of a design, as if it stood at `path`; numbers that were moved stay so.
    ///
    /// # Errors
    /// As [`LoadedStudy::with_readings`].
    pub fn of_table(
        path: PathBuf,
        text: String,
        readings: Readings,
        (design, moved): (&Opened, &Values),
    ) -> Result<(Opened, Values), Refusal> {
        let study = LoadedStudy::with_readings(&path, &text, &design.words, &readings.measured)?;
        // what the table says of a condition is what was measured
        let own: Vec<String> = own_keys(&study).map(str::to_string).collect();
        let numbers = moved.numbers.iter().filter(|(key, _)| !own.contains(key));
        let numbers = numbers.map(|(key, value)| (key.clone(), *value)).collect();
        let opened = Opened {
            path,
            words: design.words.clone(),
            what: What::Study(Box::new(study)),
            text: text.clone(),
            readings: Some(readings),
        };
        let values = Values {
            study: Some(Arc::new(opened.study(text, Vec::new())?)),
            numbers,
            ..Values::default()
        };
        Ok((opened, values))
    }

    /// Name of the design or the study.
    pub fn name(&self) -> &str {
        match &self.what {
            What::Design(loaded) => &loaded.design.name,
            What::Study(study) => &study.study.name,
        }
    }

    /// `design` or `study`.
    pub fn kind(&self) -> &'static str {
        match self.what {
            What::Design(_) => "design",
            What::Study(_) => "study",
        }
    }

    /// A text of the study that was opened, read.
    ///
    /// # Errors
    /// As [`LoadedStudy::from_text`].
    pub fn study(&self, text: String, steps: Vec<Step>) -> Result<StudyText, InputError> {
        let loaded = self.read(&text, &self.words)?;
        Ok(StudyText { text, loaded, steps })
    }

    /// A text of the study, read, with what changes it.
    ///
    /// # Errors
    /// As [`LoadedStudy::from_text`].
    pub fn read(&self, text: &str, sets: &[String]) -> Result<LoadedStudy, InputError> {
        match &self.readings {
            Some(readings) => LoadedStudy::with_readings(&self.path, text, sets, &readings.measured),
            None => LoadedStudy::from_text(&self.path, text, sets),
        }
    }

    /// The cases; a design is one.
    pub fn cases(&self) -> Vec<Case> {
        match &self.what {
            What::Design(loaded) => vec![Case {
                name: loaded.design.name.clone(),
                held_out: false,
                wing: loaded.design.name.clone(),
                rms_deg: None,
                chi2: None,
            }],
            What::Study(study) => study.cases.iter().map(of_case).collect(),
        }
    }

    /// Whether anything was measured.
    pub fn is_measured(&self) -> bool {
        match &self.what {
            What::Design(loaded) => loaded.measurement.is_some(),
            What::Study(study) => study.cases.iter().any(|case| !case.rows.is_empty()),
        }
    }

    /// The designs as opened, one for each wing.
    pub fn designs(&self) -> Vec<&Design> {
        match &self.what {
            What::Design(loaded) => vec![&loaded.design],
            What::Study(study) => each_wing(study).map(|case| &case.loaded.design).collect(),
        }
    }

    /// Inputs of a case as opened. Of a study: those that all its wings have and no case sets for itself.
    pub fn inputs(&self, case: usize) -> Vec<Input> {
        match &self.what {
            What::Design(loaded) => inputs(&loaded.design, &[]),
            What::Study(study) => {
                let Some(shown) = study.cases.get(case) else {
                    return Vec::new();
                };
                let wings: Vec<Vec<Input>> = self
                    .designs()
                    .into_iter()
                    .map(|design| inputs(design, &[]))
                    .collect();
                let priors: Vec<Prior> = study.study.uncertain.iter().map(prior).collect();
                let own: Vec<&str> = own_keys(study).collect();
                let is_same =
                    |input: &Input, other: &Input| input.key == other.key && input.with == other.with;
                let is_offered = |input: &Input| {
                    let mut keys = input.with.iter().map(String::as_str).chain([input.key.as_str()]);
                    let is_common = wings
                        .iter()
                        .all(|wing| wing.iter().any(|other| is_same(input, other)));
                    is_common && keys.all(|key| !own.contains(&key))
                };
                inputs(&shown.loaded.design, &priors)
                    .into_iter()
                    .filter(is_offered)
                    .collect()
            }
        }
    }

    /// The wing of a case with what was moved, meshed.
    ///
    /// # Errors
    /// If the design refuses a number, or no such wing can be laid out or meshed, or its mesh is more than a page can follow.
    pub fn wing(&self, values: &Values, case: usize) -> Result<CaseWing, Refusal> {
        let wing = self.meshed(values, case)?;
        match wing.model.mesh.nodes.len() {
            nodes if nodes > MOST_NODES => Err(Refusal {
                cure: Some(
                    "Take a coarser mesh, a smaller mesh.refine, or solve it by washout solve".to_string(),
                ),
                ..Refusal::new(format!(
                    "The mesh of this wing has {nodes} nodes, and the page follows {MOST_NODES}"
                ))
            }),
            _ => Ok(wing),
        }
    }

    fn meshed(&self, values: &Values, case: usize) -> Result<CaseWing, Refusal> {
        match &self.what {
            What::Design(_) => {
                let loaded = Design::load_text(&self.text, &self.path, &self.sets(values))?;
                Ok(CaseWing {
                    name: loaded.design.name.clone(),
                    measured: loaded.measurement.clone(),
                    model: WingModel::new(loaded)?,
                })
            }
            What::Study(opened) => {
                let study = values.study.as_ref().map_or(&**opened, |text| &text.loaded);
                let case = study
                    .cases
                    .get(case)
                    .ok_or_else(|| Refusal::new(format!("there is no case {case}")))?;
                wing_of(study, case, values)
            }
        }
    }

    /// Refuses what one of the wings does not take, whichever is shown.
    ///
    /// # Errors
    /// As [`Opened::wing`], but for the mesh.
    pub fn check(&self, values: &Values) -> Result<(), Refusal> {
        let What::Study(study) = &self.what else {
            return Ok(());
        };
        for case in each_wing(study) {
            moved(case, values)?;
        }
        Ok(())
    }

    /// Refuses a file that is not as it was when it was opened.
    ///
    /// # Errors
    /// If it is not.
    pub fn refuse_changed(&self) -> Result<(), Refusal> {
        let now = std::fs::read_to_string(&self.path).ok();
        let is_new = self.readings.is_some() && !self.path.exists();
        match is_new || now.is_some_and(|now| now == self.text) {
            true => Ok(()),
            false => Err(Refusal::new(format!(
                "{} was changed since it was opened; open it anew",
                self.path.display()
            ))),
        }
    }

    /// What changes the file, as `--set` takes it.
    pub fn sets(&self, values: &Values) -> Vec<String> {
        [self.words.clone(), values.sets()].concat()
    }
}

/// Keys that the cases of a study set for themselves.
pub fn own_keys(study: &LoadedStudy) -> impl Iterator<Item = &str> {
    let sets = study.study.case.iter().flat_map(|case| &case.set);
    sets.filter_map(|set| Some(set.split_once('=')?.0.trim()))
}

/// The wing of a case of a study with what was moved and the effects of the study.
fn wing_of(study: &LoadedStudy, case: &LoadedCase, values: &Values) -> Result<CaseWing, Refusal> {
    let moved = LoadedCase {
        loaded: moved(case, values)?,
        ..case.clone()
    };
    let prepared = PreparedCase::new(&moved, study, &[]).map_err(Refusal::new)?;
    let loaded = Loaded {
        design: prepared.design,
        ..moved.loaded
    };
    let measured = (!case.rows.is_empty()).then(|| Measurement {
        file: case.measurement.clone(),
        rows: case.rows.clone(),
        ..Measurement::default()
    });
    Ok(CaseWing {
        name: case.name.clone(),
        model: WingModel::new(loaded)?,
        measured,
    })
}

/// The design of a case with the numbers that were moved.
fn moved(case: &LoadedCase, values: &Values) -> Result<Loaded, Refusal> {
    match values.numbers.is_empty() {
        true => Ok(case.loaded.clone()),
        false => {
            let sets = [case.sets.clone(), values.sets()].concat();
            Ok(Design::load(&case.loaded.path, &sets)?)
        }
    }
}

/// One case of each wing.
fn each_wing(study: &LoadedStudy) -> impl Iterator<Item = &LoadedCase> {
    let is_first = |(index, case): &(usize, &LoadedCase)| {
        let name = &case.loaded.design.name;
        study.cases[..*index]
            .iter()
            .all(|other| other.loaded.design.name != *name)
    };
    study
        .cases
        .iter()
        .enumerate()
        .filter(is_first)
        .map(|(_, case)| case)
}

fn of_case(case: &LoadedCase) -> Case {
    Case {
        name: case.name.clone(),
        held_out: case.is_held_out,
        wing: case.loaded.design.name.clone(),
        rms_deg: None,
        chi2: None,
    }
}

fn prior(uncertain: &Uncertain) -> Prior {
    Prior {
        key: uncertain.key.clone(),
        mean: uncertain.mean,
        sigma: uncertain.sigma,
        range: uncertain.range,
    }
}

/// `key=number`, if it is one.
fn number_of(set: &str) -> Option<(String, f64)> {
    let (key, value) = set.split_once('=')?;
    let number: f64 = value.trim().parse().ok()?;
    number.is_finite().then(|| (key.trim().to_string(), number))
}

/// The effect whose strength a key is.
fn strength_key(key: &str) -> Option<&str> {
    key.strip_prefix("effects.")?.strip_suffix(".strength")
}
