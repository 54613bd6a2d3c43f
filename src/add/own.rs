//! Effects of the user's own, in a file.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::origin::InputFile;

use super::error::AddError;

/// The effects of the user's own in a file: its tables `[effects.NAME]` by name; with what the file is known by.
///
/// # Errors
/// If it cannot be read, or there is no such table in it.
pub fn own_effects(file: &Path) -> Result<(BTreeMap<String, toml::Table>, InputFile), AddError> {
    let fault = |reason: String| AddError::Question {
        question: "--own",
        reason: format!("{}: {reason}", file.display()),
    };
    let text = fs::read_to_string(file).map_err(|error| fault(error.to_string()))?;
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
