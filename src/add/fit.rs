//! An effect that joins a study, or leaves it: fitted together with all else that is open, and the error step by step.

use std::path::{Path, PathBuf};

use crate::compare::ladder::{StudyLadderStep, ladder};
use crate::compare::{ComparedStudy, StudyComparison};
use crate::effects::{Card, named, stands_for};
use crate::input::Design;
use crate::input::study::LoadedStudy;
use crate::origin::InputFile;
use crate::progress::Progress;
use crate::study::StudyError;

use super::OnBench;
use super::added::{Other, elsewhere, implausible, no_fall, others, with_strengths};
use super::effect_tables::EffectEntry;
use super::error::AddError;
use super::joining;
use super::moved::{added_effects, stages};
use super::own::own_effects;

/// Prior standard deviation of a strength that is fitted, over the size that is plausible.
const PRIOR: f64 = 1.5;

/// An effect that is to join a study, or to leave it.
#[derive(Debug, Clone, Default)]
pub struct Joining {
    /// The effect: its name, or that of a table of `own`.
    pub effect: String,
    /// A file of effects of one's own, tables `[effects.NAME]`.
    pub own: Option<PathBuf>,
    /// Numbers of the effect besides its strength, each `NAME=VALUE`.
    pub numbers: Vec<String>,
    /// The wings that have it, by the names of their designs; those that the study tries effects on, or all, where none is named.
    pub on: Vec<String>,
    /// The strength at which it is held, so that neither it nor another is fitted for good; none: it is fitted.
    pub strength: Option<f64>,
    /// Whether it leaves.
    pub is_removed: bool,
}

/// A study with the effect in it, or out of it, fitted.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The study's text, with the strengths that were found.
    pub text: String,
    /// Fitted strength and standard error (0 if it is there wholly or not at all); none if it was taken out.
    pub strength: Option<[f64; 2]>,
    /// What the strength is on the wing as something that a bench measures: the number, and its unit with what it is; none if no number says it.
    pub stands_for: Option<(f64, String)>,
    /// What the strength does to the still wing; none if nothing, or the effect was taken out.
    pub on_bench: Option<OnBench>,
    /// The other effects that are fitted in the study, with the strengths that it has now.
    pub others: Vec<Other>,
    /// What is to be thought of.
    pub notes: Vec<String>,
    /// The error step by step.
    pub ladder: Vec<StudyLadderStep>,
    /// Each wing as calibrated on the study as it is now, to be solved at other operating points.
    pub designs: Vec<Design>,
    /// Files that were read besides those of the study.
    pub files: Vec<InputFile>,
}

/// What is known of the effect before anything is solved.
struct Known {
    /// Its plausible size.
    scale: f64,
    /// Its numbers besides the strength.
    numbers: toml::Table,
    /// The file of one's own that it stands in.
    file: Option<InputFile>,
}

/// A study before the effect joins or leaves it.
struct Before {
    /// Each step with its name.
    steps: Vec<(String, StudyComparison)>,
    /// Its wings as calibrated at the last step.
    designs: Vec<Design>,
}

impl Joining {
    /// Refuses a name that no effect has.
    ///
    /// # Errors
    /// With the nearest name.
    pub fn check_name(&self) -> Result<(), AddError> {
        if self.own.is_none() && !self.is_removed && named(&self.effect).is_none() {
            return Err(joining::no_such_effect(&self.effect));
        }
        Ok(())
    }

    /// Refuses, before anything is solved, what this study cannot take.
    ///
    /// # Errors
    /// With the number, wing, file or effect that is at fault.
    pub fn check(&self, study: &LoadedStudy) -> Result<(), AddError> {
        self.known(study).map(|_| ())
    }

    /// Fits the study at `study.path`, whose text is `text`, with the effect.
    ///
    /// # Errors
    /// If what is asked for is refused, the text is no study, it gives no result, or the user asked to stop.
    pub fn fitted(&self, study: &LoadedStudy, text: &str, progress: &Progress) -> Result<Fit, AddError> {
        let known = self.known(study)?;
        let on = match self.on.is_empty() {
            true => study.study.candidates_on.as_deref().unwrap_or_default(),
            false => &self.on,
        };
        // what is all or none is written as it is, and not fitted
        let whole = named(&self.effect).filter(|effect| effect.is_all_or_none());
        let whole = self.strength.or(whole.map(|_| known.scale));
        let entry = EffectEntry {
            study: &study.path,
            effect: &self.effect,
            is_removed: self.is_removed,
            is_held: self.strength.is_some(),
            sigma: whole.is_none().then_some(PRIOR * known.scale),
            numbers: &known.numbers,
            on,
            is_on_named: !self.on.is_empty(),
        };
        let changed = entry.changed(text, whole.unwrap_or(0.0))?;
        let added = added_effects(study);
        let Before {
            mut steps,
            designs: before,
        } = steps_before(study, text, progress)?;
        let stands = study.study.effect.iter().any(|effect| effect.name == self.effect);
        let change = self.change(added.contains(&self.effect), stands);
        progress.say(&change);
        let (changed_study, fitted) = solved(&study.path, &changed, progress)?;
        let designs = calibrated(&changed_study, &fitted)?;
        let on_bench = match self.is_removed {
            true => Ok(None),
            false => OnBench::of(
                &changed_study,
                &designs,
                &before,
                &self.effect,
                &progress.unseen(),
            ),
        };
        let after = fitted.comparison;
        let key = format!("effects.{}.strength", self.effect);
        let found = after.unknowns.iter().find(|unknown| unknown.unknown.name == key);
        let whole = whole.filter(|_| !self.is_removed).map(|scale| [scale, 0.0]);
        let strength = whole.or(found.map(|unknown| [unknown.value, unknown.standard_error]));
        let others = match self.strength {
            Some(_) => Vec::new(),
            None => others(study, &after, &self.effect),
        };
        let mut notes = implausible(&after);
        if let Err(reason) = &on_bench {
            notes.push(format!(
                "What {} does to the still wing on a bench is not known: {reason}.",
                self.effect
            ));
        }
        notes.extend(elsewhere(study, &self.effect, &self.on));
        steps.push((change, after));
        let ladder = ladder(&steps);
        let written = match strength {
            Some([value, _]) => entry.changed(text, value)?,
            None => changed,
        };
        // one that stood there had its fall before
        if !self.is_removed && !stands {
            notes.extend(no_fall(&ladder));
        }
        Ok(Fit {
            text: with_strengths(&written, &others)?,
            strength,
            stands_for: designs.iter().find_map(|design| stands_for(design, &self.effect)),
            on_bench: on_bench.ok().flatten(),
            others,
            notes,
            ladder,
            designs,
            files: known.file.into_iter().collect(),
        })
    }

    /// The name of its step of the ladder.
    fn change(&self, is_added: bool, stands: bool) -> String {
        match (self.is_removed, is_added, stands) {
            (true, ..) => format!("− {}", self.effect),
            (false, true, _) => format!("{} anew", self.effect),
            (false, false, true) => format!("{} fitted", self.effect),
            (false, false, false) => format!("+ {}", self.effect),
        }
    }

    /// Checks what is asked for, before anything is solved.
    fn known(&self, study: &LoadedStudy) -> Result<Known, AddError> {
        self.check_name()?;
        self.check_strength()?;
        joining::wings(study, &self.on)?;
        if self.is_removed {
            joining::present(study, &self.effect)?;
        }
        if let Some(file) = &self.own {
            return self.known_of_own(study, file);
        }
        match named(&self.effect) {
            Some(effect) => {
                let card = effect.card();
                Ok(Known {
                    scale: card.parameters[0].scale(),
                    numbers: self.card_numbers(&card)?,
                    file: None,
                })
            }
            None if self.is_removed => Ok(Known {
                scale: 1.0,
                numbers: toml::Table::new(),
                file: None,
            }),
            None => Err(joining::no_such_effect(&self.effect)),
        }
    }

    /// The same of an effect of one's own.
    fn known_of_own(&self, study: &LoadedStudy, file: &Path) -> Result<Known, AddError> {
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
        Ok(Known {
            scale: 1.0,
            numbers: table,
            file: Some(input),
        })
    }

    /// Refuses a strength that the effect does not take.
    fn check_strength(&self) -> Result<(), AddError> {
        let (Some(strength), Some(effect)) = (self.strength, named(&self.effect)) else {
            return Ok(());
        };
        let [low, high] = effect.card().parameters[0].range;
        match (low..=high).contains(&strength) {
            true => Ok(()),
            false => Err(AddError::Question {
                question: "--strength",
                reason: format!(
                    "{strength}: {} takes {low} … {high} (washout effects {})",
                    self.effect, self.effect
                ),
            }),
        }
    }

    /// The effect's numbers besides its strength.
    fn card_numbers(&self, card: &Card) -> Result<toml::Table, AddError> {
        let mut numbers = toml::Table::new();
        for text in &self.numbers {
            let (name, number) = joining::number(text, card)?;
            if numbers.insert(name.clone(), toml::Value::Float(number)).is_some() {
                return Err(AddError::Question {
                    question: "--number",
                    reason: format!("{text}: {name} is given twice; give it once"),
                });
            }
        }
        Ok(numbers)
    }
}

/// The study without any effect that was added, and with one after the other of them; and its wings as calibrated at the last step.
fn steps_before(study: &LoadedStudy, text: &str, progress: &Progress) -> Result<Before, AddError> {
    let (mut steps, mut designs) = (Vec::new(), Vec::new());
    for (step, text) in stages(study, text)? {
        progress.say(&step);
        let (stage, compared) = solved(&study.path, &text, progress)?;
        designs = calibrated(&stage, &compared)?;
        steps.push((step, compared.comparison));
    }
    Ok(Before { steps, designs })
}

fn calibrated(study: &LoadedStudy, compared: &ComparedStudy) -> Result<Vec<Design>, AddError> {
    let designs = compared.calibrated_designs(study);
    designs.map_err(|source| of_study(&study.path, source))
}

fn solved(path: &Path, text: &str, progress: &Progress) -> Result<(LoadedStudy, ComparedStudy), AddError> {
    let study = LoadedStudy::from_text(path, text, &[])?;
    let compared = ComparedStudy::new(&study, progress).map_err(|source| of_study(path, source))?;
    Ok((study, compared))
}

fn of_study(path: &Path, source: StudyError) -> AddError {
    AddError::Study {
        study: path.to_path_buf(),
        source,
    }
}
