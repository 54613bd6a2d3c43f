//! Which effects a diagnosis may try: those of `--effect`, those that the study names, or all.

use crate::diagnose::DiagnoseError;
use crate::effects::{all, instead_of, lacks, named};
use crate::input::refused_in;
use crate::input::study::LoadedStudy;
use crate::study::case::PreparedCase;

use super::Failure;

/// Effects of which the reason is told why they cannot join.
const TOLD: usize = 4;

/// Refuses names given with `--effect` that no effect has.
pub fn known(asked: &[String]) -> Result<(), Failure> {
    match asked.iter().find(|name| named(name).is_none()) {
        None => Ok(()),
        Some(name) => Err(Failure::Option {
            option: "--effect",
            reason: format!("there is no effect {name}; {}", instead_of(name)),
        }),
    }
}

/// Effects to be tried: those asked for with `--effect`, those that the study names, or all; each once. One of them at least can
/// join the model.
pub fn candidates(study: &LoadedStudy, asked: &[String]) -> Result<Vec<String>, Failure> {
    known(asked)?;
    let of_study = study.study.candidates.as_deref();
    for (index, name) in of_study.unwrap_or_default().iter().enumerate() {
        if named(name).is_none() {
            let key = format!("candidates[{index}]");
            return Err(refused(
                study,
                &key,
                "there is no such effect",
                &first_up(&instead_of(name)),
            ));
        }
    }
    let listed = match (asked, of_study) {
        ([], None) => all().map(|effect| effect.card().name.to_string()).collect(),
        ([], Some(listed)) => listed.to_vec(),
        (asked, _) => asked.to_vec(),
    };
    let mut names: Vec<String> = Vec::new();
    for name in listed {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let Some(reason) = none_joins(study, &names)? else {
        return Ok(names);
    };
    Err(match (asked, of_study) {
        ([], None) => Failure::Diagnosis {
            study: study.path.clone(),
            source: DiagnoseError::NoEffects,
        },
        ([], Some(_)) => refused(
            study,
            "candidates",
            &reason,
            "Name others in candidates (washout effects NAME says what each needs), or delete candidates, to try all that can \
             act",
        ),
        _ => Failure::Option {
            option: "--effect",
            reason: format!(
                "{}: {reason}. Name others (washout effects NAME says what each needs), or leave --effect out",
                study.path.display()
            ),
        },
    })
}

fn refused(study: &LoadedStudy, key: &str, message: &str, cure: &str) -> Failure {
    refused_in(&study.path, "study file", key, message, cure).into()
}

/// Why none of these effects can join the model of a study; none if one can.
fn none_joins(study: &LoadedStudy, names: &[String]) -> Result<Option<String>, Failure> {
    if names.is_empty() {
        return Ok(Some("there is no effect in it".to_string()));
    }
    let tried: Vec<&str> = names.iter().map(String::as_str).collect();
    let cases = study
        .cases
        .iter()
        .map(|case| PreparedCase::new(case, study, &tried));
    let cases: Vec<PreparedCase> = cases
        .collect::<Result<_, _>>()
        .map_err(|source| Failure::OfStudy {
            study: study.path.clone(),
            source,
        })?;
    let mut reasons = Vec::new();
    for name in names {
        let reason = if study.study.effect.iter().any(|effect| effect.name == *name) {
            "it stands in the study already ([[effect]])".to_string()
        } else if cases.iter().any(|case| case.design.effects.contains_key(name)) {
            return Ok(None);
        } else {
            let mut lacking: Vec<String> = Vec::new();
            for case in &cases {
                let lack = named(name).and_then(|effect| lacks(&effect.card(), &case.design));
                lacking.extend(lack.filter(|lack| !lacking.contains(lack)));
            }
            lacking.join(", or ")
        };
        reasons.push(match names {
            [_] => reason,
            _ => format!("{name}: {reason}"),
        });
    }
    let more = match reasons.len().saturating_sub(TOLD) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    reasons.truncate(TOLD);
    let reasons = reasons.join("; ") + &more;
    Ok(Some(match names {
        [name] => format!("{name} cannot join the model: {reasons}"),
        _ => format!("none of them can join the model: {reasons}"),
    }))
}

/// A sentence with its first letter in upper case.
pub fn first_up(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map_or(String::new(), |letter| letter.to_uppercase().to_string());
    first + letters.as_str()
}
