//! `washout synthesize`: measurements with a hidden effect, to try a campaign and its diagnosis before trusting them.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use clap::Args;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml_edit::{DocumentMut, Item, value};

use crate::add::joining::{own_strength, own_table};
use crate::add::own::own_effects;
use crate::export::measurement::measurement_csv;
use crate::export::run::RunFolder;
use crate::export::{ExportError, json, place};
use crate::input::measurement::{Formulas, Made, Row};
use crate::input::study::LoadedStudy;
use crate::origin::InputFile;
use crate::synthesize::{Hidden, Recipe, SynthesizeError, Synthetic, synthesize};

use super::{Console, Failure};

const VERB: &str = "synthesize";

/// Arguments of `washout synthesize`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout synthesize studies/three-rods.toml --effect root-flexure=0.2 \\
    --seed 7 --output try
  # finds it, or not
  washout diagnose try/three-rods.toml
  cat try/answer.json                                     tells what it was
  # nothing hidden: is anything found?
  washout synthesize studies/three-rods.toml --seed 8
  washout synthesize studies/three-rods.toml \\
    --own examples/effect_of_ones_own.toml --output own

The wing that is measured has other meshes than the study, its uncertain inputs are drawn from their priors, outline, stiffness and air law have errors that nobody states, and the hidden effect has another formula where there is one.")]
pub struct Synthesize {
    /// The study: its cases and the sigmas of its rows are kept, values are made
    pub study: PathBuf,
    /// Hide this effect with this strength, NAME@WING=STRENGTH on one wing only; can be given several times
    #[arg(long, value_name = "NAME=STRENGTH")]
    pub effect: Vec<String>,
    /// Hide the effects of your own of this file, tables [effects.NAME] with kind = "custom"
    #[arg(long, value_name = "FILE")]
    pub own: Option<PathBuf>,
    /// Scatter of the readings over their stated sigma
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub noise: f64,
    /// One reading is off by so many sigma
    #[arg(long, value_name = "SIGMAS")]
    pub outlier: Option<f64>,
    /// Relative error of outline, stiffness and air law, one standard deviation
    #[arg(long, value_name = "SHARE", default_value_t = 0.01)]
    pub background: f64,
    /// Factor on the refinement of the meshes
    #[arg(long, value_name = "FACTOR", default_value_t = 1.25)]
    pub mesh: f64,
    /// Hide effects by the program's own formulas, even where there is another of the same physics
    #[arg(long)]
    pub same_formulas: bool,
    /// Seed of all that is drawn
    #[arg(long, value_name = "N", default_value_t = 2)]
    pub seed: u64,
    /// Folder to write into [default: output/NAME-synthetic]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// What `washout synthesize` wrote.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SynthesizeReport {
    /// The study.
    pub study: PathBuf,
    /// The measurements.
    pub measurements: Vec<PathBuf>,
    /// What is hidden.
    pub answer: PathBuf,
    /// Numbers that were measured.
    pub numbers: usize,
    /// Rows that the wing could not be asked for; they were left out.
    pub unread: Vec<String>,
    /// Hidden effects that act by the formula that the diagnosis has.
    pub same_formula: Vec<String>,
}

impl Synthesize {
    /// Makes and writes them.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let study = LoadedStudy::load_planned(&self.study, &[])?;
        let recipe = self.recipe(&study)?;
        let target = match &self.output {
            Some(folder) => folder.clone(),
            None => PathBuf::from("output").join(format!("{}-synthetic", study.study.name)),
        };
        refuse_own(&study, &target)?;
        measured(&study, &target)?;
        RunFolder::refuse(&target, VERB)?;
        let made = synthesize(&study, &recipe, console.progress()).map_err(|source| self.refused(source))?;
        let folder = RunFolder::create(&target, VERB)?;
        let report = write(&self.study, folder, &made)?;
        console.result(&page(&report), &report)
    }

    /// A fault of an effect is one of the option that names it.
    fn refused(&self, source: SynthesizeError) -> Failure {
        match source {
            SynthesizeError::Hidden { effect, reason } => {
                let is_it = |text: &String| {
                    let name = text.split(['=', '@']).next();
                    name.is_some_and(|name| name.trim() == effect)
                };
                let (option, reason) = match (&self.own, self.effect.iter().any(is_it)) {
                    (Some(file), false) => ("--own", format!("{}: {effect}: {reason}", file.display())),
                    _ => ("--effect", format!("{effect}: {reason}")),
                };
                Failure::Option { option, reason }
            }
            source => Failure::Synthesis {
                study: self.study.clone(),
                source,
            },
        }
    }

    fn recipe(&self, study: &LoadedStudy) -> Result<Recipe, Failure> {
        let option = |option: &'static str, reason: String| Failure::Option { option, reason };
        for (name, value, low, high) in [
            ("--noise", self.noise, 0.0, 100.0),
            ("--outlier", self.outlier.unwrap_or(0.0), 0.0, 1000.0),
            ("--background", self.background, 0.0, 0.2),
            ("--mesh", self.mesh, 0.2, 5.0),
        ] {
            if !(low..=high).contains(&value) {
                return Err(option(name, format!("{value} is outside {low} to {high}")));
            }
        }
        let mut hidden = Vec::new();
        for text in &self.effect {
            let parsed = text
                .split_once('=')
                .and_then(|(name, strength)| Some((name, strength.trim().parse::<f64>().ok()?)));
            let Some((name, strength)) = parsed.filter(|(_, strength)| strength.is_finite()) else {
                let reason = format!("{text} is not NAME=STRENGTH; write e.g. --effect root-flexure=0.2");
                return Err(option("--effect", reason));
            };
            let (name, wing) = match name.split_once('@') {
                Some((name, wing)) => (name, Some(wing.trim().to_string())),
                None => (name, None),
            };
            let known = Hidden::known(name.trim(), strength);
            hidden.push(Hidden { wing, ..known });
        }
        if let Some(file) = &self.own {
            for (name, table) in own_effects(file)?.0 {
                let strength = own_strength(file, &name, &table)?;
                let designs = study.cases.iter().map(|case| &case.loaded.design);
                own_table(file, &name, &table, designs, strength)?;
                hidden.push(Hidden {
                    name,
                    strength,
                    table,
                    wing: None,
                });
            }
        }
        Ok(Recipe {
            hidden,
            made: Made {
                mesh: self.mesh,
                formulas: if self.same_formulas {
                    Formulas::Same
                } else {
                    Formulas::Other
                },
                background: self.background,
                seed: self.seed,
            },
            noise: self.noise,
            outlier: self.outlier,
        })
    }
}

/// Refuses a folder that holds a file of the study, which would be written over.
fn refuse_own(study: &LoadedStudy, target: &Path) -> Result<(), Failure> {
    let Ok(whole) = target.canonicalize() else {
        return Ok(());
    };
    let is_inside = |file: &&InputFile| {
        let path = Path::new(&file.file).canonicalize();
        path.is_ok_and(|path| path.starts_with(&whole))
    };
    match study.files.iter().find(is_inside) {
        None => Ok(()),
        Some(file) => Err(Failure::Option {
            option: "--output",
            reason: format!(
                "{} belongs to the study and would be written over; give another folder",
                file.file
            ),
        }),
    }
}

/// Writes study, measurements and answer.
fn write(study: &Path, mut folder: RunFolder, made: &Synthetic) -> Result<SynthesizeReport, Failure> {
    let target = folder.target().to_path_buf();
    let answer_text = json::text(&json::document(&made.answer)?)?;
    let comments = [
        made.answer.recipe.made.to_string(),
        "These numbers come from no experiment: they are readings of a model with errors of its own."
            .to_string(),
    ];
    let mut measurements = Vec::new();
    let mut numbers = 0;
    for (name, rows) in &measured(&made.study, &target)? {
        let rows: Vec<Row> = rows.values().cloned().collect();
        numbers += rows.len();
        folder.add(name, measurement_csv(&comments, &rows)?.as_bytes())?;
        measurements.push(target.join(name));
    }
    let name = file_name(&study.to_string_lossy());
    folder.add(&name, study_beside(study, &target)?.as_bytes())?;
    folder.add("answer.json", answer_text.as_bytes())?;
    folder.commit()?;
    Ok(SynthesizeReport {
        study: target.join(name),
        measurements,
        answer: target.join("answer.json"),
        numbers,
        unread: made.answer.unread.clone(),
        same_formula: (made.answer.acted.iter())
            .filter(|acted| !acted.is_other)
            .map(|acted| acted.asked.clone())
            .collect(),
    })
}

/// The rows of a study by the name of the file, and there by line.
fn measured(study: &LoadedStudy, folder: &Path) -> Result<BTreeMap<String, BTreeMap<usize, Row>>, Failure> {
    let mut from: BTreeMap<String, &str> = BTreeMap::new();
    let mut files: BTreeMap<String, BTreeMap<usize, Row>> = BTreeMap::new();
    for case in &study.cases {
        let (own, name) = (case.measurement.as_str(), file_name(&case.measurement));
        let known = *from.entry(name.clone()).or_insert(own);
        if known != own {
            return Err(Failure::Option {
                option: "STUDY",
                reason: format!(
                    "{known} and {own} would be one file in {}; give them different names",
                    folder.display()
                ),
            });
        }
        let rows = files.entry(name).or_default();
        rows.extend(case.rows.iter().map(|row| (row.line, row.clone())));
    }
    Ok(files)
}

fn file_name(path: &str) -> String {
    Path::new(path)
        .file_name()
        .map_or_else(|| path.to_string(), |name| name.to_string_lossy().into_owned())
}

/// The text of a study as it stands in another folder, its measurements beside it.
fn study_beside(study: &Path, folder: &Path) -> Result<String, Failure> {
    let fault = |reason: String| Failure::Option {
        option: "STUDY",
        reason,
    };
    let text =
        std::fs::read_to_string(study).map_err(|error| fault(format!("{}: {error}", study.display())))?;
    let mut document: DocumentMut = text
        .parse()
        .map_err(|error: toml_edit::TomlError| fault(error.to_string()))?;
    let home = study.parent().unwrap_or(Path::new(""));
    for (table, own_measurement) in [("case", true), ("experiment", false)] {
        let Some(tables) = document.get_mut(table).and_then(Item::as_array_of_tables_mut) else {
            continue;
        };
        for case in tables.iter_mut() {
            for key in ["design", "measurement"] {
                let Some(old) = case.get(key).and_then(Item::as_str).map(str::to_string) else {
                    continue;
                };
                case[key] = value(match key {
                    "measurement" if own_measurement => file_name(&old),
                    _ => relative(&home.join(old), folder)?,
                });
            }
        }
    }
    Ok(document.to_string())
}

/// The whole path of a folder that may be yet to be written.
fn whole_place(folder: &Path) -> Result<PathBuf, ExportError> {
    let place = place::of_folder(folder)?;
    let parent = match place.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let parent = parent.canonicalize().map_err(ExportError::file("find", parent))?;
    Ok(parent.join(place.file_name().unwrap_or_default()))
}

/// A path as seen from a folder.
fn relative(path: &Path, folder: &Path) -> Result<String, Failure> {
    let whole = |path: &Path| path.canonicalize().map_err(ExportError::file("find", path));
    let (path, folder) = (whole(path)?, whole_place(folder)?);
    let same = path
        .components()
        .zip(folder.components())
        .take_while(|(a, b)| a == b)
        .count();
    let mut relative = PathBuf::new();
    relative.extend(folder.components().skip(same).map(|_| Component::ParentDir));
    relative.extend(path.components().skip(same));
    Ok(relative.to_string_lossy().replace('\\', "/"))
}

fn page(report: &SynthesizeReport) -> String {
    let measurements: Vec<String> = report
        .measurements
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    let study = report.study.display();
    let mut page = format!(
        "{study}: {} numbers in {}; what is hidden stands in {}\n",
        report.numbers,
        measurements.join(", "),
        report.answer.display()
    );
    for row in &report.unread {
        page += &format!("  left out, for the wing cannot be asked for it: {row}\n");
    }
    if !report.same_formula.is_empty() {
        page += &format!(
            "  by the formula that the diagnosis has too: {} (meshes, inputs and background differ)\n",
            report.same_formula.join(", ")
        );
    }
    page + &format!("Look for it with: washout diagnose {study}\n")
}
