//! What is said of an effect that is to join a study, checked before anything is solved: its name, numbers, own table, wings.

use std::path::Path;

use crate::effects::custom::Custom;
use crate::effects::{Card, EffectError, Parameter, instead_of, named};
use crate::input::study::{LoadedCase, LoadedStudy};
use crate::input::{Design, nearest, refused_in};

use super::error::AddError;

/// There is no effect of this name, nor a table of one's own.
pub fn no_such_effect(name: &str) -> AddError {
    AddError::Question {
        question: "washout add EFFECT",
        reason: format!(
            "there is no effect {name}; {}; one of your own comes with --own FILE",
            instead_of(name)
        ),
    }
}

/// A file with effects of one's own has none of this name, only `names`.
pub fn no_such_table(file: &Path, name: &str, names: &[&str]) -> AddError {
    let near = did_you_mean(";", name, names.iter().copied());
    AddError::Question {
        question: "--own",
        reason: format!(
            "{} has no table [effects.{name}], only {}{near}",
            file.display(),
            names.join(", ")
        ),
    }
}

/// The nearest of the known names, if one is near, behind `mark`.
fn did_you_mean<'a>(mark: &str, name: &str, known: impl Iterator<Item = &'a str>) -> String {
    nearest(name, known).map_or(String::new(), |near| format!("{mark} did you mean {near}?"))
}

/// Reads `NAME=VALUE` of `--number`: another number of an effect than its strength.
pub fn number(text: &str, card: &Card) -> Result<(String, f64), AddError> {
    let refuse = |reason: String| {
        Err(AddError::Question {
            question: "--number",
            reason: format!("{text}: {reason} (washout effects {})", card.name),
        })
    };
    let others = card.parameters.get(1..).unwrap_or_default();
    let (Some(first), [strength, ..]) = (others.first(), card.parameters) else {
        let reason = format!(
            "{} has no number but its strength, which is fitted; leave it out",
            card.name
        );
        return refuse(reason);
    };
    let Some((name, value)) = text.split_once('=') else {
        return refuse(format!(
            "is not NAME=VALUE, such as {}={}",
            first.name,
            first.scale()
        ));
    };
    let (name, value) = (name.trim(), value.trim());
    if name == strength.name {
        return refuse(format!("the {name} is fitted; leave it out"));
    }
    let Some(parameter) = others.iter().find(|parameter| parameter.name == name) else {
        let near = did_you_mean(",", name, others.iter().map(|parameter| parameter.name));
        let known: Vec<String> = others.iter().map(shown).collect();
        return refuse(format!(
            "{} has no number {name}{near}; besides its strength it has {}",
            card.name,
            known.join(", and ")
        ));
    };
    let Ok(number) = value.parse::<f64>() else {
        return refuse(format!("'{value}' is no number; give {}", shown(parameter)));
    };
    let [low, high] = parameter.range;
    match low <= number && number <= high {
        true => Ok((name.to_string(), number)),
        false => refuse(format!("{value} is out of range; give {}", shown(parameter))),
    }
}

/// A number of an effect with its ranges and what it is.
fn shown(parameter: &Parameter) -> String {
    let ([low, high], [from, to]) = (parameter.range, parameter.plausible);
    let unit = match parameter.unit {
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    format!(
        "{} in {low} … {high}{unit} (plausible {from} … {to}): {}",
        parameter.name, parameter.meaning
    )
}

/// Refuses a table of one's own that is no effect, or whose formula cannot be computed on these wings at this strength.
pub fn own_table<'a>(
    file: &Path,
    name: &str,
    table: &toml::Table,
    designs: impl Iterator<Item = &'a Design>,
    strength: f64,
) -> Result<(), AddError> {
    let refuse = |key: &str, problem: &str, cure: &str| {
        let key = match key {
            "" => format!("effects.{name}"),
            key => format!("effects.{name}.{key}"),
        };
        Err(AddError::Question {
            question: "--own",
            reason: refused_in(file, "file of effects", &key, problem, cure).to_string(),
        })
    };
    if named(name).is_some() {
        return refuse(
            "",
            "there is an effect of this name already",
            "give yours another name",
        );
    }
    let mut table = table.clone();
    table.insert("strength".to_string(), toml::Value::Float(strength));
    for design in designs {
        let Err(error) = Custom::read(name, &table, design) else {
            continue;
        };
        return match error {
            EffectError::Own {
                key, problem, cure, ..
            } => refuse(&key, &problem, &cure),
            EffectError::NoValue { problem, cure, .. } => refuse("expression", &problem, &cure),
            EffectError::Formula { error, .. } => {
                let problem = format!("column {} of the formula: {}", error.column, error.problem);
                refuse("expression", &problem, &error.cure)
            }
            other => refuse("", &other.to_string(), "mend the table"),
        };
    }
    Ok(())
}

/// The strength that a table of one's own states; 1, the formula as it is written, where it states none.
pub fn own_strength(file: &Path, name: &str, table: &toml::Table) -> Result<f64, AddError> {
    let Some(value) = table.get("strength") else {
        return Ok(1.0);
    };
    let plain = |value: &toml::Value| value.as_float().or(value.as_integer().map(|whole| whole as f64));
    let found = plain(value).or_else(|| plain(value.get("assumed")?));
    found.ok_or_else(|| {
        let key = format!("effects.{name}.strength");
        let cure = "Write strength = 1.0: the formula as it is written";
        AddError::Question {
            question: "--own",
            reason: refused_in(file, "file of effects", &key, "must be a number", cure).to_string(),
        }
    })
}

/// Refuses names of wings that the study has not.
pub fn wings(study: &LoadedStudy, on: &[String]) -> Result<(), AddError> {
    let mut known: Vec<&str> = Vec::new();
    for case in &study.cases {
        if !known.contains(&case.loaded.design.name.as_str()) {
            known.push(&case.loaded.design.name);
        }
    }
    let Some(wing) = on.iter().find(|wing| !known.contains(&wing.as_str())) else {
        return Ok(());
    };
    let near = did_you_mean(",", wing, known.iter().copied());
    Err(AddError::Question {
        question: "--on",
        reason: format!(
            "there is no wing {wing} in {}{near}; it has {}",
            study.path.display(),
            known.join(", ")
        ),
    })
}

/// Refuses to take out an effect that does not stand in the study.
pub fn present(study: &LoadedStudy, name: &str) -> Result<(), AddError> {
    let mut present: Vec<&str> = Vec::new();
    for effect in &study.study.effect {
        if effect.name == name {
            return Ok(());
        }
        present.push(&effect.name);
    }
    let path = study.path.display();
    let has = |case: &&LoadedCase| case.loaded.design.effects.contains_key(name);
    let reason = match (study.cases.iter().find(has), &present[..]) {
        (Some(case), _) => format!(
            "{name} stands in the design {}, not in {path}; delete its table [effects.{name}] there",
            case.loaded.path.display()
        ),
        (None, []) => format!("{name} is not in {path}; there is no effect in it, so nothing to take out"),
        (None, present) => {
            let near = did_you_mean(",", name, present.iter().copied());
            format!("{name} is not in {path}{near}; in it: {}", present.join(", "))
        }
    };
    Err(AddError::Question {
        question: "--remove",
        reason,
    })
}
