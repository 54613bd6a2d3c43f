//! The text of a study with what somebody moves in it, and the texts that its ladder is made of.

use toml_edit::{Array, DocumentMut, Item, value};

use crate::input::study::LoadedStudy;

use super::effect_tables::{EffectEntry, is_added, not_toml, without};
use super::error::AddError;

/// A study's text with `sets` (`key=value`) in each of its cases and experiments, behind those that they have; a set of the same key and
/// form before it goes.
///
/// # Errors
/// If the text is no TOML, or a case no table.
pub fn with_sets(text: &str, sets: &[String]) -> Result<String, AddError> {
    if sets.is_empty() {
        return Ok(text.to_string());
    }
    let mut document: DocumentMut = text.parse().map_err(not_toml)?;
    for name in ["case", "experiment"] {
        let tables = document.get_mut(name).and_then(Item::as_array_of_tables_mut);
        for table in tables.into_iter().flat_map(|tables| tables.iter_mut()) {
            let own = table.entry("set").or_insert(value(Array::new()));
            if let Some(own) = own.as_array_mut() {
                put(own, sets);
            }
        }
    }
    Ok(document.to_string())
}

fn put(own: &mut Array, sets: &[String]) {
    let key = |set: &str| set.split_once('=').map(|(key, _)| key.trim().to_string());
    let of_user: Vec<Option<String>> = sets.iter().map(|set| key(set)).collect();
    // what a case sets by a number of its name is of the measurement, and stays
    own.retain(|set| {
        let set = set.as_str().unwrap_or_default();
        set.contains('{') || !of_user.contains(&key(set))
    });
    sets.iter().for_each(|set| own.push(set.as_str()));
}

/// A study's text with an effect held at a strength, so that it is not fitted; all else stays. None: without it.
///
/// # Errors
/// If the text is no TOML, or its effects are no tables of their own.
pub fn with_strength(
    study: &LoadedStudy,
    text: &str,
    effect: &str,
    strength: Option<f64>,
) -> Result<String, AddError> {
    let numbers = toml::Table::new();
    let entry = EffectEntry {
        study: &study.path,
        effect,
        is_removed: strength.is_none(),
        is_held: true,
        sigma: None,
        numbers: &numbers,
        on: study.study.candidates_on.as_deref().unwrap_or_default(),
        is_on_named: false,
    };
    entry.changed(text, strength.unwrap_or(0.0))
}

/// The text of a study without any effect that was added, and with one after the other of them; each with its name.
///
/// # Errors
/// If the text is no TOML.
pub fn stages(study: &LoadedStudy, text: &str) -> Result<Vec<(String, String)>, AddError> {
    let added = added_effects(study);
    let stage = |count: usize| {
        let name = match count {
            0 => "calibrated".to_string(),
            _ => format!("+ {}", added[count - 1]),
        };
        Ok((name, without(text, &added[count..])?))
    };
    (0..=added.len()).map(stage).collect()
}

/// Names of the effects of a study that were added, in its order.
pub(super) fn added_effects(study: &LoadedStudy) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for effect in &study.study.effect {
        if is_added(&effect.name, effect.sigma.is_some()) && !names.contains(&effect.name) {
            names.push(effect.name.clone());
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_join_every_case_and_comments_stay() {
        let text = "# mine\n[[case]]\nset = [\"a=1\", \"b={f}\"] # kept\n\n[[case]]\nmeasured = \"x\"\n\n[[experiment]]\nset = []\n";
        let found = with_sets(text, &["a=2".to_string(), "b=3".to_string()]).expect("TOML");
        assert_eq!(
            found,
            "# mine\n[[case]]\nset = [ \"b={f}\", \"a=2\", \"b=3\"] # kept\n\n[[case]]\nmeasured = \"x\"\nset = [\"a=2\", \"b=3\"]\n\n\
             [[experiment]]\nset = [\"a=2\", \"b=3\"]\n"
        );
    }
}
