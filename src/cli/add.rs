//! `washout add`: an effect joins the model of a study, and the error falls, or does not.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::compare::ComparedStudy;
use crate::compare::ladder::{StudyLadderStep, ladder};
use crate::compare::study_comparison::StudyComparison;
use crate::effects::{Card, named};
use crate::export::html::{self, Document};
use crate::export::ladder as ladder_text;
use crate::export::pictures::ladder::Fall;
use crate::export::pictures::write::add_falls;
use crate::export::run::RunFolder;
use crate::input::study::LoadedStudy;
use crate::origin::{InputFile, MadeOf};
use crate::page::text::{significant, wrapped};

use super::added::{Other, elsewhere, implausible, no_fall, others, with_strengths};
use super::effect_tables::{EffectEntry, is_added, without};
use super::study_file::StudyFile;
use super::written::{listed, target as target_of};
use super::{Console, Failure, joining};

/// The document that lists the files of a ladder.
pub const LADDER: &str = "ladder.json";

/// Arguments of `washout add`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout add skin-bending --to studies/pre-pazy-skin.toml \\
    --output with-skin.toml
  washout add skin-bending --to with-skin.toml --remove
  washout add rod-split --number from=0.53 --on twist-v2 --to my-study.toml
  washout add glue-seam --own examples/effect_of_ones_own.toml \\
    --to my-study.toml

The effect is fitted together with all else that the study leaves open, and written with its fitted strength; the prior of the strength stays as wide as what is plausible. Comments of the study are kept. The error is shown rung by rung: as stated and calibrated without any effect that was added, then with one after the other of those in the study, this one last (or taken out), down to the noise; fitted, left out (each case predicted from the others), held out. Writes output/NAME-ladder/ besides: the same as a picture (SVG), with its numbers (CSV); ladder.json.")]
pub struct Add {
    /// The effect: its name, or with --own that of a table [effects.NAME]
    pub effect: String,
    /// The study
    #[arg(long, value_name = "STUDY")]
    pub to: PathBuf,
    /// An effect of your own: the file with its table [effects.NAME], kind = "custom"
    #[arg(long, value_name = "FILE", conflicts_with = "remove")]
    pub own: Option<PathBuf>,
    /// Another number of the effect, e.g. from=0.53; can be given many times
    #[arg(long, value_name = "NAME=VALUE", conflicts_with_all = ["remove", "own"])]
    pub number: Vec<String>,
    /// The wing that has it, by the name of its design; can be given many times [default: candidates_on of the study, or all on which it can act]
    #[arg(long, value_name = "WING", conflicts_with = "remove")]
    pub on: Vec<String>,
    /// Take the effect out instead
    #[arg(long)]
    pub remove: bool,
    /// Write the study here instead of over the old one; paths in it stay relative to it, so keep the folder
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Folder for the picture of the error [default: output/NAME-ladder]
    #[arg(long, value_name = "DIR")]
    pub ladder: Option<PathBuf>,
    /// Write report.html into that folder besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
}

/// What `washout add` prints; `ladder.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AddReport {
    /// The study as written.
    pub written: PathBuf,
    /// The effect.
    pub effect: String,
    /// Its fitted strength and standard error (0 if it is there wholly or not at all); none if it was taken out.
    pub strength: Option<[f64; 2]>,
    /// The other effects that are fitted in the study, with the strengths that it has now.
    pub others: Vec<Other>,
    /// What is to be thought of: strengths that are not plausible, an error that does not fall, wings that change.
    pub notes: Vec<String>,
    /// The error falling: as stated and calibrated without any effect that was added, with one after the other of those in the
    /// study, with this one (or without it), the noise.
    pub ladder: Vec<StudyLadderStep>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// A study with the effect in it, or out of it, fitted.
struct Fit {
    /// The study's text.
    text: String,
    strength: Option<[f64; 2]>,
    others: Vec<Other>,
    notes: Vec<String>,
    ladder: Vec<StudyLadderStep>,
}

impl Add {
    /// Fits, writes and shows.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        if self.own.is_none() && !self.remove && named(&self.effect).is_none() {
            return Err(joining::no_such_effect(&self.effect));
        }
        let study = LoadedStudy::load(&self.to, &[])?;
        let file = StudyFile::read(&self.to, self.output.as_ref())?;
        let (scale, table, own) = self.effect(&study)?;
        let target = target_of(self.ladder.as_ref(), &study.study.name, "ladder");
        let folder = RunFolder::listed_by(&target, "add", LADDER)?;
        let on = match self.on.is_empty() {
            true => study.study.candidates_on.as_deref().unwrap_or_default(),
            false => &self.on,
        };
        // what is all or none is written as it is, and not fitted
        let is_whole = named(&self.effect).is_some_and(|effect| effect.is_all_or_none());
        let entry = EffectEntry {
            study: &self.to,
            effect: &self.effect,
            is_removed: self.remove,
            sigma: (!is_whole).then_some(1.5 * scale),
            numbers: &table,
            on,
            is_on_named: !self.on.is_empty(),
        };
        let whole = is_whole.then_some(scale);
        let fit = self.fitted(&study, &file.text, &entry, whole, console)?;
        let made_of = MadeOf::files(study.files.iter().chain(&own));
        self.write(fit, made_of, &study, &file, folder, console)
    }

    /// `whole`: the strength of an effect that is all or none.
    fn fitted(
        &self,
        study: &LoadedStudy,
        text: &str,
        entry: &EffectEntry,
        whole: Option<f64>,
        console: &Console,
    ) -> Result<Fit, Failure> {
        let changed = entry.changed(text, whole.unwrap_or(0.0))?;
        let mut steps = self.steps_before(study, text, console)?;
        let stands = study.study.effect.iter().any(|effect| effect.name == self.effect);
        let change = match (self.remove, added_effects(study).contains(&self.effect), stands) {
            (true, ..) => format!("− {}", self.effect),
            (false, true, _) => format!("{} anew", self.effect),
            (false, false, true) => format!("{} fitted", self.effect),
            (false, false, false) => format!("+ {}", self.effect),
        };
        console.progress().say(&change);
        let after = self.compared(&changed, console)?;
        let key = format!("effects.{}.strength", self.effect);
        let found = after.unknowns.iter().find(|unknown| unknown.unknown.name == key);
        let whole = whole.filter(|_| !self.remove).map(|scale| [scale, 0.0]);
        let strength = whole.or(found.map(|unknown| [unknown.value, unknown.standard_error]));
        let others = others(study, &after, &self.effect);
        let mut notes = implausible(&after);
        notes.extend(elsewhere(study, &self.effect, &self.on));
        steps.push((change, after));
        let ladder = ladder(&steps);
        let written = match strength {
            Some([value, _]) => entry.changed(text, value)?,
            None => changed,
        };
        // one that stood there had its fall before
        if !self.remove && !stands {
            notes.extend(no_fall(&ladder));
        }
        Ok(Fit {
            text: with_strengths(&written, &others)?,
            strength,
            others,
            notes,
            ladder,
        })
    }

    /// The study without any effect that was added, and with one after the other of them.
    fn steps_before(
        &self,
        study: &LoadedStudy,
        text: &str,
        console: &Console,
    ) -> Result<Vec<(String, StudyComparison)>, Failure> {
        let added = added_effects(study);
        let mut steps = Vec::new();
        for count in 0..=added.len() {
            let step = match count {
                0 => "calibrated".to_string(),
                _ => format!("+ {}", added[count - 1]),
            };
            console.progress().say(&step);
            steps.push((step, self.compared(&without(text, &added[count..])?, console)?));
        }
        Ok(steps)
    }

    /// Writes the study and the folder, and says what was found.
    fn write(
        &self,
        fit: Fit,
        made_of: MadeOf,
        study: &LoadedStudy,
        file: &StudyFile,
        mut folder: RunFolder,
        console: &Console,
    ) -> Result<(), Failure> {
        add_falls(&mut folder, &study.study.name, &Fall::of_study(&fit.ladder))?;
        let report = AddReport {
            written: file.target.clone(),
            effect: self.effect.clone(),
            strength: fit.strength,
            others: fit.others,
            notes: fit.notes,
            ladder: fit.ladder,
            made_of,
            files: folder.listed_with(self.report),
        };
        if self.report {
            html::folder::add(&mut folder, &page(&report), Document::new("ladder", &report)?)?;
        }
        folder.add_summary(&report)?;
        console.progress().check()?;
        // the study last: whoever is stopped between the two can do the same again
        let pictures = folder.commit()?;
        file.write(&fit.text)?;
        let page = format!("{}\n{}", page(&report), listed(&pictures, &report.files));
        console.result(&page, &report)
    }

    /// Plausible size of the effect; its table and file if it is the user's own.
    fn effect(&self, study: &LoadedStudy) -> Result<(f64, toml::Table, Option<InputFile>), Failure> {
        joining::wings(study, &self.on)?;
        if self.remove {
            joining::present(study, &self.effect)?;
        }
        if let Some(file) = &self.own {
            let (mut tables, input) = own_effects(file)?;
            let Some(mut table) = tables.remove(&self.effect) else {
                let names: Vec<&str> = tables.keys().map(String::as_str).collect();
                return Err(joining::no_such_table(file, &self.effect, &names));
            };
            joining::own_strength(file, &self.effect, &table)?;
            let designs = study.cases.iter().map(|case| &case.loaded.design);
            let meant = designs.filter(|design| match self.on.is_empty() {
                true => study.study.is_tried_on(&design.name),
                false => self.on.contains(&design.name),
            });
            joining::own_table(file, &self.effect, &table, meant, 0.0)?;
            table.remove("strength");
            return Ok((1.0, table, Some(input)));
        }
        match named(&self.effect) {
            Some(effect) => {
                let card = effect.card();
                Ok((card.parameters[0].scale(), self.numbers(&card)?, None))
            }
            None if self.remove => Ok((1.0, toml::Table::new(), None)),
            None => Err(joining::no_such_effect(&self.effect)),
        }
    }

    /// The effect's numbers besides its strength.
    fn numbers(&self, card: &Card) -> Result<toml::Table, Failure> {
        let mut numbers = toml::Table::new();
        for text in &self.number {
            let (name, number) = joining::number(text, card)?;
            if numbers.insert(name.clone(), toml::Value::Float(number)).is_some() {
                return Err(Failure::Option {
                    option: "--number",
                    reason: format!("{text}: {name} is given twice; give it once"),
                });
            }
        }
        Ok(numbers)
    }

    fn compared(&self, text: &str, console: &Console) -> Result<StudyComparison, Failure> {
        let study = LoadedStudy::from_text(&self.to, text, &[])?;
        let fault = |source| Failure::OfStudy {
            study: self.to.clone(),
            source,
        };
        let compared = ComparedStudy::new(&study, console.progress()).map_err(fault)?;
        Ok(compared.comparison)
    }
}

/// The effects of the user's own in a file: its tables `[effects.NAME]` by name; with what the file is known by.
pub(super) fn own_effects(file: &Path) -> Result<(BTreeMap<String, toml::Table>, InputFile), Failure> {
    let fault = |reason: String| Failure::Option {
        option: "--own",
        reason: format!("{}: {reason}", file.display()),
    };
    let text = std::fs::read_to_string(file).map_err(|error| fault(error.to_string()))?;
    let root: toml::Table = text
        .parse()
        .map_err(|error: toml::de::Error| fault(error.to_string()))?;
    let cure = "there is no table [effects.NAME] with kind = \"custom\", acts_on and expression";
    let tables = root.get("effects").and_then(toml::Value::as_table);
    let tables = tables.ok_or_else(|| fault(cure.to_string()))?;
    let is_own = |table: &&toml::Table| table.contains_key("kind");
    let found: BTreeMap<String, toml::Table> = tables
        .iter()
        .filter_map(|(name, table)| Some((name.clone(), table.as_table().filter(is_own)?.clone())))
        .collect();
    match found.is_empty() {
        true => Err(fault(cure.to_string())),
        false => Ok((found, InputFile::new(file.display().to_string(), text.as_bytes()))),
    }
}

/// Names of the effects of a study that were added, in its order.
fn added_effects(study: &LoadedStudy) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for effect in &study.study.effect {
        if is_added(&effect.name, effect.sigma.is_some()) && !names.contains(&effect.name) {
            names.push(effect.name.clone());
        }
    }
    names
}

/// What the tables of errors tell.
const STEPS: &str = "Root mean square of all channels, in stated sigma; chi2: chi-square per fitted number, with errors of the model that go \
                     together along the span (discrepancy), which is what a fit makes least. Left out: each case predicted from the others.";
const GROUPS: &str = "rmse: root mean square error; chi2: chi-square per number, each number for itself.";

/// The page of `washout add`.
pub fn page(report: &AddReport) -> String {
    let what = match report.strength {
        Some([value, 0.0]) => format!(
            "{} with strength {}, all of it",
            report.effect,
            significant(value, 4)
        ),
        Some([value, error]) => format!(
            "{} with strength {} ± {}",
            report.effect,
            significant(value, 4),
            significant(error, 2)
        ),
        None => format!("without {}", report.effect),
    };
    let others = report.others.iter().map(Other::line);
    let notes = report.notes.iter().map(|note| wrapped(note, 2));
    let more: String = others.chain(notes).collect();
    format!(
        "{}: {what}\n{more}\nError step by step\n{}{}\nError wing by wing\n{}{}",
        report.written.display(),
        wrapped(STEPS, 2),
        ladder_text::steps(&report.ladder),
        wrapped(GROUPS, 2),
        ladder_text::groups(&report.ladder)
    )
}
