//! Effects hidden in a study.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::SynthesizeError;
use super::hidden::Hidden;
use super::rival::{Rival, rival};
use crate::effects::custom::Custom;
use crate::effects::{Card, Effect, instead_of, is_applicable, named, with_common_numbers};
use crate::input::measurement::Formulas;
use crate::input::study::LoadedStudy;

/// A hidden effect as it acted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Acted {
    /// The effect that was asked for.
    pub asked: String,
    /// Its family.
    pub family: String,
    /// Its strength.
    pub strength: f64,
    /// The effect or formula that acted.
    pub formula: String,
    /// The strength with which that acted.
    pub formula_strength: f64,
    /// Whether that is another formula than the diagnosis has; some effects have but one.
    #[serde(default)]
    pub is_other: bool,
}

/// Puts the hidden effects into every design on which they can act.
///
/// # Errors
/// If one is unknown, in the model already, out of range, or acts on no design.
pub fn hide(
    study: &mut LoadedStudy,
    hidden: &[Hidden],
    formulas: Formulas,
) -> Result<Vec<Acted>, SynthesizeError> {
    hidden
        .iter()
        .enumerate()
        .map(|(index, effect)| {
            let is_same = |other: &Hidden| other.name == effect.name && other.wing == effect.wing;
            if hidden[..index].iter().any(is_same) {
                return Err(effect.fault(
                    "is to be hidden twice; give one strength, or name another wing (NAME@WING=STRENGTH)",
                ));
            }
            if study.study.effect.iter().any(|known| known.name == effect.name) {
                return Err(effect.fault(
                    "stands in the study already; take it out (washout add NAME --to STUDY --remove), or hide another",
                ));
            }
            if let Some(wing) = &effect.wing
                && !study.cases.iter().any(|case| case.loaded.design.name == *wing)
            {
                let mut wings: Vec<&str> = study
                    .cases
                    .iter()
                    .map(|case| case.loaded.design.name.as_str())
                    .collect();
                wings.dedup();
                return Err(effect.fault(format!(
                    "there is no wing {wing} in this study; it has {}",
                    wings.join(", ")
                )));
            }
            match named(&effect.name) {
                Some(known) => hide_known(study, effect, &known.card(), formulas),
                None if effect.table.contains_key("kind") => hide_own(study, effect),
                None => Err(effect.fault(format!("there is no such effect; {}", instead_of(&effect.name)))),
            }
        })
        .collect()
}

fn hide_known(
    study: &mut LoadedStudy,
    effect: &Hidden,
    card: &Card,
    formulas: Formulas,
) -> Result<Acted, SynthesizeError> {
    check_range(effect, card)?;
    let other = match formulas {
        Formulas::Other => rival(effect),
        Formulas::Same => None,
    };
    let is_other = other.is_some();
    let mut parts = acting(effect, other);
    if let Some(first) = study.cases.first() {
        for (name, table) in &mut parts {
            let common = with_common_numbers(name, table, &first.loaded.design);
            common.map_err(|error| effect.fault(error.to_string()))?;
        }
    }
    let mut touched = 0;
    for case in &mut study.cases {
        if effect.is_on(&case.loaded.design) && is_applicable(card, &case.loaded.design) {
            case.loaded.design.effects.extend(parts.iter().cloned());
            touched += 1;
        }
    }
    if touched == 0 {
        return Err(effect
            .fault("acts on none of the designs of this study (washout effects NAME says what it needs)"));
    }
    Ok(Acted {
        asked: effect.name.clone(),
        family: card.family.to_string(),
        strength: effect.strength,
        formula: parts
            .iter()
            .map(|(name, table)| formula(name, table))
            .collect::<Vec<_>>()
            .join("; "),
        formula_strength: parts[0].1["strength"].as_float().unwrap_or(effect.strength),
        is_other,
    })
}

fn check_range(effect: &Hidden, card: &Card) -> Result<(), SynthesizeError> {
    let strength = &card.parameters[0];
    let [low, high] = strength.range;
    if !(low <= effect.strength && effect.strength <= high) {
        let unit = match strength.unit {
            "1" => String::new(),
            unit => format!(" {unit}"),
        };
        let [from, to] = strength.plausible;
        return Err(effect.fault(format!(
            "strength {} is outside {low} to {high}{unit}; plausible is {from} to {to}{unit} ({}; washout effects {})",
            effect.strength, strength.meaning, effect.name
        )));
    }
    Ok(())
}

/// Names and tables of what acts: another formula where there is one, else the effect itself.
fn acting(effect: &Hidden, other: Option<Rival>) -> Vec<(String, toml::Table)> {
    match other {
        Some(Rival::Known(name, strength)) => {
            vec![(name.to_string(), with_strength(&effect.table, strength))]
        }
        Some(Rival::Own(parts)) => parts
            .into_iter()
            .map(|own| (own.name, with_strength(&own.table, own.strength)))
            .collect(),
        None => vec![(effect.name.clone(), with_strength(&effect.table, effect.strength))],
    }
}

fn hide_own(study: &mut LoadedStudy, effect: &Hidden) -> Result<Acted, SynthesizeError> {
    let table = with_strength(&effect.table, effect.strength);
    let mut touched = 0;
    for case in &mut study.cases {
        let design = &mut case.loaded.design;
        let (own, _) =
            Custom::read(&effect.name, &table, design).map_err(|error| effect.fault(error.to_string()))?;
        if effect.is_on(design) && is_applicable(&own.card(), design) {
            design.effects.insert(effect.name.clone(), table.clone());
            touched += 1;
        }
    }
    if touched == 0 {
        return Err(effect.fault("acts on none of the designs of this study"));
    }
    Ok(Acted {
        asked: effect.name.clone(),
        family: "user's own".to_string(),
        strength: effect.strength,
        formula: formula(&effect.name, &table),
        formula_strength: effect.strength,
        is_other: true,
    })
}

/// What acts: an effect by its name, or a formula.
fn formula(name: &str, table: &toml::Table) -> String {
    match (table.get("acts_on"), table.get("expression")) {
        (Some(toml::Value::String(acts_on)), Some(toml::Value::String(text))) => format!("{acts_on}: {text}"),
        _ => name.to_string(),
    }
}

fn with_strength(table: &toml::Table, strength: f64) -> toml::Table {
    let mut table = table.clone();
    table.insert("strength".to_string(), toml::Value::Float(strength));
    table
}
