//! A session as a value: what was opened, what was moved, what can be taken back. It solves nothing.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use crate::effects::named;
use crate::page::text::significant;

use super::effects::strengths;
use super::held::{hold, strength_in};
use super::history::History;
use super::inputs::Input;
use super::ladder::Ladder;
use super::opened::{Case, CaseWing, Opened, What, own_keys};
use super::refusal::Refusal;
use super::state::{Saving, State};
use super::table::Table;
use super::values::{Addition, StudyText, Values, written};
use super::verbs::{Save, Verbs};

/// A session.
#[derive(Clone)]
pub struct Session {
    opened: Arc<Opened>,
    verbs: Arc<dyn Verbs>,
    values: Values,
    /// As opened.
    first: Values,
    /// As saved last, or opened.
    saved: Values,
    history: History,
    case: usize,
    revision: u64,
    ladder: Ladder,
}

impl Session {
    /// Opens a design or a study; `sets` change it, as the command line has them.
    ///
    /// # Errors
    /// As [`Opened::open`].
    pub fn open(path: &Path, sets: &[String], verbs: Arc<dyn Verbs>) -> Result<Session, Refusal> {
        Session::of(Opened::open(path, sets)?, verbs)
    }

    fn of((opened, values): (Opened, Values), verbs: Arc<dyn Verbs>) -> Result<Session, Refusal> {
        let session = Session {
            opened: Arc::new(opened),
            verbs,
            first: values.clone(),
            saved: values.clone(),
            values,
            history: History::default(),
            case: 0,
            revision: 1,
            ladder: Ladder::default(),
        };
        session.wing()?;
        Ok(session)
    }

    /// Another file in the place of this one; nothing of it can be undone.
    ///
    /// # Errors
    /// As [`Session::open`]; then all stays as it was.
    pub fn reopen(&mut self, path: &Path, sets: &[String]) -> Result<(), Refusal> {
        let opened = Session::open(path, sets, Arc::clone(&self.verbs))?;
        self.replace(opened);
        Ok(())
    }

    /// The study of a table in the place of the design.
    ///
    /// # Errors
    /// If the study is refused; then all stays as it was.
    pub fn take_in(&mut self, table: &Table) -> Result<(), Refusal> {
        let (path, text, readings) = table.study()?;
        let opened = Opened::of_table(path, text, readings, (&self.opened, &self.values))?;
        self.replace(Session::of(opened, Arc::clone(&self.verbs))?);
        Ok(())
    }

    fn replace(&mut self, other: Session) {
        *self = Session {
            revision: self.revision + 1,
            ..other
        };
    }

    /// Rises with every change.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Whether its wing is the same as that of another.
    pub fn is_alike(&self, other: &Session) -> bool {
        Arc::ptr_eq(&self.opened, &other.opened) && self.case == other.case && self.values == other.values
    }

    /// The case that is shown.
    pub fn case(&self) -> usize {
        self.case
    }

    /// What was opened.
    pub fn opened(&self) -> &Arc<Opened> {
        &self.opened
    }

    /// What was moved.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// Who answers what the verbs do.
    pub fn verbs(&self) -> &Arc<dyn Verbs> {
        &self.verbs
    }

    /// The wing of the case that is shown.
    ///
    /// # Errors
    /// As [`Opened::wing`].
    pub fn wing(&self) -> Result<CaseWing, Refusal> {
        self.opened.wing(&self.values, self.case)
    }

    /// The same as it was opened.
    ///
    /// # Errors
    /// As [`Opened::wing`].
    pub fn first_wing(&self) -> Result<CaseWing, Refusal> {
        self.opened.wing(&self.first, self.case)
    }

    /// Moves inputs; `more`: whether the gesture goes on.
    ///
    /// # Errors
    /// If there is no such input, or a value is refused; then nothing is moved.
    pub fn set(&mut self, moves: &BTreeMap<String, f64>, more: bool) -> Result<(), Refusal> {
        let inputs = self.inputs();
        let mut values = self.values.clone();
        for (key, value) in moves {
            let input = inputs
                .iter()
                .find(|input| input.key == *key)
                .ok_or_else(|| self.no_such_input(key))?;
            if input.integer && value.fract() != 0.0 {
                return Err(Refusal::at(key, "must be a whole number", "Give a whole number"));
            }
            for key in std::iter::once(key).chain(&input.with) {
                // what stands as it was is not moved: the design keeps its own word for it
                let stands = self.standing(key).unwrap_or(input.original);
                match *value == stands && !self.first.numbers.contains_key(key) {
                    true => values.numbers.remove(key),
                    false => values.numbers.insert(key.clone(), *value),
                };
            }
        }
        let gesture = moves.keys().cloned().collect::<Vec<_>>().join(" ");
        let words = |before: &Values| -> String {
            let one = |(key, value): (&String, &f64)| {
                let input = inputs.iter().find(|input| input.key == *key);
                let (label, unit, original) = input.map_or((key.as_str(), "", 0.0), |input| {
                    (input.label.as_str(), input.unit, input.original)
                });
                let was = before.numbers.get(key).copied().unwrap_or(original);
                format!("{label} {} → {} {unit}", shown(was), shown(*value))
                    .trim_end()
                    .to_string()
            };
            moves.iter().map(one).collect::<Vec<_>>().join(", ")
        };
        self.opened.check(&values)?;
        self.opened.wing(&values, self.case)?;
        self.take(values, Some((&gesture, more)), words);
        Ok(())
    }

    /// Gives an effect a strength, or takes it out; `more`: whether the gesture goes on.
    ///
    /// # Errors
    /// If there is no such effect, or it cannot act with that; then nothing is changed.
    pub fn effect(&mut self, name: &str, strength: Option<f64>, more: bool) -> Result<(), Refusal> {
        let effect = named(name).ok_or_else(|| Refusal::at(name, "there is no such effect", ""))?;
        let [low, high] = effect.card().parameters[0].range;
        if strength.is_some_and(|strength| !(low..=high).contains(&strength)) {
            let message = format!("must lie in {} … {}", shown(low), shown(high));
            return Err(Refusal::at(name, message, effect.card().parameters[0].meaning));
        }
        let was = self.strength(name);
        if was == strength {
            if !more {
                self.history.close();
            }
            return Ok(());
        }
        let mut values = self.values.clone();
        hold(
            &self.opened,
            self.first.study.as_deref(),
            &mut values,
            name,
            strength,
        )?;
        let at_effect = |refusal: Refusal| Refusal {
            key: Some(name.to_string()),
            ..refusal
        };
        self.opened.wing(&values, self.case).map_err(at_effect)?;
        let title = name.replace('-', " ");
        let shown = |strength: Option<f64>| strength.map_or("none".to_string(), shown);
        let opened = Arc::clone(&self.opened);
        let words = move |before: &Values| {
            let was = strength_in(&opened, before, name);
            format!("{title} {} → {}", shown(was), shown(strength))
        };
        self.take(values, Some((&format!("effect {name}"), more)), words);
        Ok(())
    }

    /// Shows another case; that is no change of the model, and undo does not take it back.
    ///
    /// # Errors
    /// If there is none.
    pub fn show(&mut self, case: usize) -> Result<(), Refusal> {
        let cases = self.opened.cases().len();
        if case >= cases {
            let message = format!(
                "there is no case {case}; the first is 0 and the last {}",
                cases - 1
            );
            return Err(Refusal::new(message));
        }
        self.opened.wing(&self.values, case)?;
        if case != self.case {
            self.case = case;
            self.revision += 1;
        }
        Ok(())
    }

    /// Takes the last step back.
    ///
    /// # Errors
    /// If there is none.
    pub fn undo(&mut self) -> Result<(), Refusal> {
        let values = self.history.undo();
        self.values = values.ok_or_else(|| Refusal::new("there is nothing to undo"))?;
        self.revision += 1;
        Ok(())
    }

    /// Does a step that was taken back again.
    ///
    /// # Errors
    /// If there is none.
    pub fn redo(&mut self) -> Result<(), Refusal> {
        let values = self.history.redo();
        self.values = values.ok_or_else(|| Refusal::new("there is nothing to do again"))?;
        self.revision += 1;
        Ok(())
    }

    /// All as it was opened; one step of undo.
    pub fn reset(&mut self) {
        self.take(self.first.clone(), None, |_| "all as it was opened".to_string());
    }

    /// Gives effects of a design the strengths that a diagnosis found; one step of undo.
    ///
    /// # Errors
    /// If the wing cannot be made so; then nothing is changed.
    pub fn joined(&mut self, words: &str, additions: &[Addition]) -> Result<(), Refusal> {
        let mut values = self.values.clone();
        for addition in additions {
            values.effects.insert(addition.effect.clone(), addition.strength);
            for number in &addition.numbers {
                if let Some((name, value)) = number.split_once('=')
                    && let Ok(value) = value.parse()
                {
                    values
                        .numbers
                        .insert(format!("effects.{}.{name}", addition.effect), value);
                }
            }
        }
        self.opened.wing(&values, self.case)?;
        self.take(values, None, |_| words.to_string());
        Ok(())
    }

    /// Takes a study in that something was added to; one step of undo.
    ///
    /// # Errors
    /// If a wing of it cannot be made; then nothing is changed.
    pub fn added(&mut self, words: &str, study: StudyText) -> Result<(), Refusal> {
        let values = Values {
            study: Some(Arc::new(study)),
            numbers: BTreeMap::new(),
            effects: BTreeMap::new(),
        };
        self.opened.wing(&values, self.case)?;
        self.take(values, None, |_| words.to_string());
        Ok(())
    }

    /// The ladder of the study or of the measured design as it stands.
    pub fn climb(&mut self, ladder: Ladder) {
        self.ladder = ladder;
    }

    /// The ladder, as far as it is known.
    pub fn ladder(&self) -> &Ladder {
        &self.ladder
    }

    /// What was moved is saved.
    pub fn is_saved(&mut self, values: Values) {
        self.saved = values;
    }

    /// What is to be saved, given to `ask`.
    pub fn saving<T>(&self, ask: impl FnOnce(&Save) -> T) -> T {
        let opened = &self.opened;
        let sets = opened.sets(&self.values);
        match &opened.what {
            What::Design(loaded) => ask(&Save::Design {
                path: &opened.path,
                name: &loaded.design.name,
                sets: &sets,
            }),
            What::Study(study) => {
                let text = self.values.study.as_deref();
                ask(&Save::Study {
                    path: &opened.path,
                    name: &study.study.name,
                    steps: text.map_or(&[], |own| &own.steps),
                    sets: &sets,
                    readings: opened.readings.as_ref(),
                })
            }
        }
    }

    /// The state as the page reads it.
    pub fn state(&self) -> State {
        let designs = self.opened.designs();
        State {
            kind: "live",
            format: 1,
            name: self.opened.name().to_string(),
            of: self.opened.kind(),
            file: self.opened.path.display().to_string(),
            revision: self.revision,
            case: self.case,
            cases: self.cases(),
            inputs: self.inputs(),
            effects: strengths(designs.iter().copied(), |name| self.strength(name)),
            undo: self.history.undo_words().map(str::to_string),
            redo: self.history.redo_words().map(str::to_string),
            ladder: self.ladder.steps.clone(),
            noise_deg: self.ladder.noise_deg,
            measured: self.opened.is_measured(),
            dirty: self.values != self.saved,
            save: Saving {
                commands: self.saving(|save| self.verbs.commands(save)),
            },
        }
    }

    /// The cases with their errors on the last step of the ladder, as far as that is known.
    fn cases(&self) -> Vec<Case> {
        let mut cases = self.opened.cases();
        for case in &mut cases {
            let error = self.ladder.cases.iter().find(|error| error.case == case.name);
            case.rms_deg = error.and_then(|error| error.rms_deg);
            case.chi2 = error.map(|error| error.chi2);
        }
        cases
    }

    /// The inputs of the case that is shown, where they stand now.
    fn inputs(&self) -> Vec<Input> {
        let mut inputs = self.opened.inputs(self.case);
        for input in &mut inputs {
            let moved = self.values.numbers.get(&input.key).copied();
            input.value = moved.or_else(|| self.standing(&input.key)).unwrap_or(input.value);
            input.low = input.low.min(input.value);
            input.high = input.high.max(input.value);
        }
        inputs
    }

    /// The number of a key in the text of the study: an effect that was fitted with numbers moved took these into it.
    fn standing(&self, key: &str) -> Option<f64> {
        let study = self.values.study.as_ref()?;
        study.loaded.cases.get(self.case)?.loaded.design.get(key)
    }

    /// Strength of an effect; none if it is not in the model.
    fn strength(&self, name: &str) -> Option<f64> {
        strength_in(&self.opened, &self.values, name)
    }

    fn no_such_input(&self, key: &str) -> Refusal {
        let own = match &self.opened.what {
            What::Study(study) => own_keys(study).any(|own| own == key),
            What::Design(_) => false,
        };
        match own {
            true => Refusal::at(
                key,
                "is set by the cases of the study, for it was measured so",
                "Show another case",
            ),
            false => Refusal::at(key, "is no input that can be moved here", ""),
        }
    }

    /// Takes values over as a step.
    fn take(&mut self, values: Values, gesture: Option<(&str, bool)>, words: impl Fn(&Values) -> String) {
        self.history.add(&self.values, &values, gesture, words);
        if self.values != values {
            self.values = values;
            self.revision += 1;
        }
    }
}

/// A number with six digits at most.
fn shown(value: f64) -> String {
    let short: f64 = significant(value, 6).parse().unwrap_or(value);
    written(short)
}
