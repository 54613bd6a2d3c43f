//! The tables `[[effect]]` in the text of a study, as `washout add` changes them.

use std::path::Path;

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, TomlError, value};

use crate::effects::named;

use super::added::written;
use super::error::AddError;

/// An effect that joins a study, or leaves it.
pub(super) struct EffectEntry<'a> {
    /// The file of the study.
    pub(super) study: &'a Path,
    pub(super) effect: &'a str,
    pub(super) is_removed: bool,
    /// Whether its strength is held: one that was fitted is not fitted any more.
    pub(super) is_held: bool,
    /// Sigma of the prior of its strength; none where that is not fitted.
    pub(super) sigma: Option<f64>,
    /// Its numbers besides the strength.
    pub(super) numbers: &'a toml::Table,
    /// The wings that have it; all where empty.
    pub(super) on: &'a [String],
    /// Whether these wings were named for it, rather than taken from the study.
    pub(super) is_on_named: bool,
}

impl EffectEntry<'_> {
    /// The study's text with the effect in it, or out of it.
    pub(super) fn changed(&self, text: &str, strength: f64) -> Result<String, AddError> {
        let mut document: DocumentMut = text.parse().map_err(not_toml)?;
        let tables = document
            .entry("effect")
            .or_insert(Item::ArrayOfTables(ArrayOfTables::new()));
        let Some(tables) = tables.as_array_of_tables_mut() else {
            return Err(fault(format!(
                "{}: effect = {}: write each effect as a table of its own, [[effect]], to add one or take one out",
                self.study.display(),
                document
                    .get("effect")
                    .map_or(String::new(), |own| own.to_string().trim().to_string())
            )));
        };
        if self.is_removed {
            tables.retain(|table| !self.is_in(table));
        } else {
            self.join(tables, strength)?;
        }
        if tables.is_empty() {
            document.remove("effect");
        }
        Ok(document.to_string())
    }

    fn is_in(&self, table: &Table) -> bool {
        table.get("name").and_then(Item::as_str) == Some(self.effect)
    }

    fn join(&self, tables: &mut ArrayOfTables, strength: f64) -> Result<(), AddError> {
        let stands = tables.iter().any(|table| self.is_in(table));
        if !stands {
            let mut table = Table::new();
            table["name"] = value(self.effect);
            table["strength"] = value(written(strength));
            tables.push(table);
        }
        // one that stands there already takes what is given now, and keeps the rest
        if let Some(table) = tables.iter_mut().find(|table| self.is_in(table)) {
            table["strength"] = value(written(strength));
            if self.is_held {
                table.remove("sigma");
            }
            if let Some(sigma) = self.sigma {
                table.entry("sigma").or_insert(value(written(sigma)));
            }
            if self.is_on_named || (!stands && !self.on.is_empty()) {
                let wings: toml_edit::Array = self.on.iter().map(String::as_str).collect();
                table["designs"] = value(wings);
            }
            self.add_numbers(table)?;
        }
        Ok(())
    }

    fn add_numbers(&self, table: &mut Table) -> Result<(), AddError> {
        let text = toml::to_string(self.numbers).map_err(|error| fault(error.to_string()))?;
        let given: DocumentMut = text.parse().map_err(not_toml)?;
        let given = given.as_table().clone().into_inline_table();
        if !given.is_empty() {
            let own = table
                .entry("numbers")
                .or_insert(value(toml_edit::InlineTable::new()));
            for (name, number) in given.iter() {
                own[name] = value(number.clone());
            }
        }
        Ok(())
    }
}

fn fault(reason: String) -> AddError {
    AddError::Question {
        question: "--to",
        reason,
    }
}

pub(super) fn not_toml(error: TomlError) -> AddError {
    fault(error.to_string())
}

/// Whether an effect of a study was added to its model: its strength is fitted, or it is all or none.
pub(super) fn is_added(name: &str, is_fitted: bool) -> bool {
    is_fitted || named(name).is_some_and(|effect| effect.is_all_or_none())
}

/// The study's text without these effects, as far as they were added.
pub(super) fn without(text: &str, effects: &[String]) -> Result<String, AddError> {
    let mut document: DocumentMut = text.parse().map_err(not_toml)?;
    if let Some(tables) = document.get_mut("effect").and_then(Item::as_array_of_tables_mut) {
        let is_out = |table: &Table| {
            let name = table.get("name").and_then(Item::as_str);
            let is_fitted = table.contains_key("sigma");
            name.is_some_and(|name| is_added(name, is_fitted) && effects.iter().any(|effect| effect == name))
        };
        tables.retain(|table| !is_out(table));
    }
    Ok(document.to_string())
}
