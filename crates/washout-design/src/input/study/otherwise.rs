//! A study with some of its alternatives, and the words of its designs that may be others.

use std::collections::BTreeSet;

use super::alternative::{Alternative, Tables};
use super::{Case, LoadedStudy};
use crate::input::assumption::word_at;
use crate::input::design::Design;
use crate::input::keys::{self, Kind};
use crate::input::path::KeyPath;

/// Probability of another word where a design assumes one; the designs chose the one that seemed more probable. Assumed.
const OTHER_WORD: f64 = 0.25;

impl LoadedStudy {
    /// The other words that its designs may have where they assume one, as alternatives, in the order of their keys.
    pub fn other_words(&self) -> Vec<Alternative> {
        let mut found: Vec<Alternative> = Vec::new();
        let mut asked: BTreeSet<String> = BTreeSet::new();
        for design in self.cases.iter().map(|case| &case.loaded.design) {
            for choice in design.assumed_choices() {
                if !asked.insert(choice.key.clone()) {
                    continue;
                }
                let own = self.cases.iter().map(|case| &case.loaded.design);
                let mut designs: Vec<String> = own
                    .filter(|other| assumes(other, &choice.key, &choice.value))
                    .map(|other| other.name.clone())
                    .collect();
                designs.sort();
                designs.dedup();
                let others = words(&choice.key)
                    .into_iter()
                    .filter(|word| *word != choice.value);
                found.extend(others.map(|word| Alternative {
                    name: format!("{} = {word}", choice.key),
                    probability: OTHER_WORD,
                    set: vec![format!("{}=\"{word}\"", choice.key)],
                    designs: Some(designs.clone()),
                    measurement: None,
                    instead_of: None,
                    case: Vec::new(),
                    why: choice.why.clone(),
                }));
            }
        }
        found
    }

    /// Its tables as they are with these alternatives.
    pub(super) fn tables_with(&self, chosen: &[&Alternative]) -> Tables {
        let design_of = |table: usize, is_experiment: bool| {
            let cases = if is_experiment {
                &self.experiments
            } else {
                &self.cases
            };
            let own = cases.iter().find(|case| case.table == table);
            own.map_or("", |case| case.loaded.design.name.as_str())
        };
        let altered = |tables: &[Case], is_experiment: bool| {
            let altered = tables.iter().enumerate().map(|(index, table)| {
                let mut table = table.clone();
                for alternative in chosen {
                    let name = design_of(index, is_experiment);
                    alternative.change(&mut table, name, is_experiment);
                }
                table
            });
            altered.collect()
        };
        (
            altered(&self.study.case, false),
            altered(&self.study.experiment, true),
        )
    }
}

/// Whether a design assumes this word.
fn assumes(design: &Design, key: &str, word: &str) -> bool {
    let is_listed = design.assumed_choice.iter().any(|choice| choice.key == key);
    let value = toml::Value::try_from(design).ok();
    let own = value.and_then(|value| word_at(&value, key));
    is_listed && own.as_deref() == Some(word)
}

/// The words that may stand at a key of a design.
fn words(key: &str) -> Vec<String> {
    let kind = KeyPath::parse(key).ok().and_then(|path| keys::design().at(&path));
    match kind {
        Some(Kind::Choice(words)) => words.clone(),
        _ => Vec::new(),
    }
}
