//! What `washout add` writes and says beside the effect that it is asked for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml_edit::{DocumentMut, Item, value};

use crate::compare::ladder::StudyLadderStep;
use crate::compare::study_comparison::StudyComparison;
use crate::input::study::LoadedStudy;
use crate::page::text::significant;
use crate::study::UnknownKind;

use super::error::AddError;

/// Share by which an error must fall to count as falling.
const TOLD: f64 = 0.005;

/// An effect of the study besides the one that is added, with its strength at the fit of all.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Other {
    /// The effect.
    pub effect: String,
    /// Its strength in the study before.
    pub before: f64,
    /// Its strength now, and the standard error.
    pub strength: [f64; 2],
}

/// The effects of a study other than `effect`, as the fit has them.
pub fn others(study: &LoadedStudy, fitted: &StudyComparison, effect: &str) -> Vec<Other> {
    let mut found: Vec<Other> = Vec::new();
    for own in study.study.effect.iter().filter(|own| own.name != effect) {
        let key = format!("effects.{}.strength", own.name);
        let unknown = fitted.unknowns.iter().find(|known| known.unknown.name == key);
        if let Some(unknown) =
            unknown.filter(|_| own.sigma.is_some() && found.iter().all(|f| f.effect != own.name))
        {
            found.push(Other {
                effect: own.name.clone(),
                before: own.strength,
                strength: [unknown.value, unknown.standard_error],
            });
        }
    }
    found
}

/// The study's text with their strengths: what was fitted with one effect less holds no more.
///
/// # Errors
/// If the text is no TOML.
pub fn with_strengths(text: &str, others: &[Other]) -> Result<String, AddError> {
    let fault = |error: toml_edit::TomlError| AddError::Question {
        question: "--to",
        reason: error.to_string(),
    };
    let mut document: DocumentMut = text.parse().map_err(fault)?;
    let tables = document.get_mut("effect").and_then(Item::as_array_of_tables_mut);
    for table in tables.into_iter().flat_map(|tables| tables.iter_mut()) {
        let name = table.get("name").and_then(Item::as_str);
        let own = others.iter().find(|other| name == Some(other.effect.as_str()));
        if let Some(other) = own.filter(|_| table.contains_key("sigma")) {
            table["strength"] = value(written(other.strength[0]));
        }
    }
    Ok(document.to_string())
}

/// Strengths that lie outside of what is plausible by more than two standard errors.
pub fn implausible(fitted: &StudyComparison) -> Vec<String> {
    let told = fitted.unknowns.iter().filter_map(|found| {
        let UnknownKind::Effect { effect, plausible: [low, high], .. } = &found.unknown.kind else {
            return None;
        };
        let beyond = (low - found.value).max(found.value - high);
        (beyond > 2.0 * found.standard_error).then(|| {
            format!(
                "{effect}: {} ± {} lies outside its plausible range of {} to {}; it may stand for something else.",
                significant(found.value, 4),
                significant(found.standard_error, 2),
                significant(*low, 3),
                significant(*high, 3)
            )
        })
    });
    told.collect()
}

/// That an effect which stands in the study acts on other wings now.
pub fn elsewhere(study: &LoadedStudy, effect: &str, on: &[String]) -> Option<String> {
    let before = study.study.effect.iter().find(|own| own.name == effect)?;
    let before = before.designs.as_deref().unwrap_or_default();
    let words = |wings: &[String]| match wings {
        [] => "all wings".to_string(),
        wings => wings.join(", "),
    };
    (!on.is_empty() && before != on)
        .then(|| format!("{effect} acts on {} now, on {} before.", words(on), words(before)))
}

/// That the last step, which adds an effect, does not lower the error of what is held out, or else left out.
pub fn no_fall(ladder: &[StudyLadderStep]) -> Option<String> {
    let [.., before, after, _noise] = ladder else {
        return None;
    };
    let held_out = before.held_out_sigma.zip(after.held_out_sigma);
    let left_out = before.left_out_sigma.zip(after.left_out_sigma);
    let (what, (before, after)) = match (held_out, left_out) {
        (Some(errors), _) => ("held out", errors),
        (None, errors) => ("left out", errors?),
    };
    (after > before * (1.0 - TOLD)).then(|| {
        format!(
            "The error of what is {what} does not fall: {} before, {} with it.",
            significant(before, 3),
            significant(after, 3)
        )
    })
}

/// A number as it is written into a study, with six digits.
pub(super) fn written(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
