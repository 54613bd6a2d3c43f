//! Which effects a diagnosis may try: those that are asked for, those that the study names, or all.

use crate::effects::{Effect, all, instead_of, named};
use crate::input::refused_in;
use crate::input::study::LoadedStudy;
use crate::study::StudyError;
use crate::study::case::PreparedCase;

use super::error::DiagnoseError;

/// Effects of which the reason is told why they cannot join.
const TOLD: usize = 4;

/// Refuses names that no effect has.
///
/// # Errors
/// [`DiagnoseError::Asked`] with the nearest name.
pub fn known(asked: &[String]) -> Result<(), DiagnoseError> {
    match asked.iter().find(|name| named(name).is_none()) {
        None => Ok(()),
        Some(name) => Err(DiagnoseError::Asked {
            reason: format!("there is no effect {name}; {}", instead_of(name)),
        }),
    }
}

/// Effects to be tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidates {
    /// Their names, each once; one of them at least can join the model.
    pub names: Vec<String>,
    /// Of those that were named, why one cannot join the model and is not tried.
    pub left_out: Vec<String>,
}

impl Candidates {
    /// Those asked for, those that the study names, or all.
    ///
    /// # Errors
    /// If there is no effect of a name, or none of them can join the model.
    pub fn new(study: &LoadedStudy, asked: &[String]) -> Result<Candidates, DiagnoseError> {
        known(asked)?;
        let of_study = study.study.candidates.as_deref();
        let excluded = &study.study.excluded;
        for (list, names) in [
            ("candidates", of_study.unwrap_or_default()),
            ("excluded", excluded),
        ] {
            if let Some(index) = names.iter().position(|name| named(name).is_none()) {
                let key = format!("{list}[{index}]");
                return Err(refused(
                    study,
                    &key,
                    "there is no such effect",
                    &instead_of(&names[index]),
                ));
            }
        }
        let names = listed(study, asked);
        let unable = unable(study, &names)?;
        if unable.len() == names.len() {
            return Err(none_left(study, asked, &unable));
        }
        let is_named = !asked.is_empty() || of_study.is_some();
        let left_out = unable.iter().filter_map(|unable| match unable.stands {
            Stands::InDesign => Some(format!("{} is not tried: {}", unable.name, unable.reason)),
            Stands::Nowhere if is_named => Some(format!(
                "{} is not tried: it cannot join the model: {}",
                unable.name, unable.reason
            )),
            Stands::Nowhere | Stands::InStudy => None,
        });
        let is_asked = |name: &&String| names.contains(*name);
        let kept_out = excluded.iter().filter(|name| !is_asked(name));
        let kept_out = kept_out.map(|name| format!("{name} is not tried: it is excluded"));
        let left_out = left_out.chain(kept_out).collect();
        Ok(Candidates { names, left_out })
    }

    /// Their names.
    pub fn names(&self) -> Vec<&str> {
        self.names.iter().map(String::as_str).collect()
    }
}

/// Their names, each once.
fn listed(study: &LoadedStudy, asked: &[String]) -> Vec<String> {
    let is_stated = |effect: &&'static dyn Effect| {
        let key = effect.is_error_of();
        key.is_some_and(|key| study.study.uncertain.iter().any(|uncertain| uncertain.key == key))
    };
    let listed = match (asked, study.study.candidates.as_deref()) {
        ([], listed) => {
            let all = || all().filter(|effect| !is_stated(effect));
            let all = || all().map(|effect| effect.card().name.to_string()).collect();
            let mut names = listed.map_or_else(all, <[String]>::to_vec);
            names.retain(|name| !study.study.excluded.contains(name));
            names
        }
        (asked, _) => asked.to_vec(),
    };
    let mut names: Vec<String> = Vec::new();
    for name in listed {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn none_left(study: &LoadedStudy, asked: &[String], unable: &[Unable]) -> DiagnoseError {
    let reason = none_joins(unable);
    match (asked, study.study.candidates.as_deref()) {
        ([], None) => DiagnoseError::NoEffects,
        ([], Some(_)) => refused(
            study,
            "candidates",
            &reason,
            "Name others in candidates (washout effects NAME says what each needs), or delete candidates, to try all that can \
             act",
        ),
        _ => DiagnoseError::Asked {
            reason: format!(
                "{}: {reason}. Name others (washout effects NAME says what each needs), or name none",
                study.path.display()
            ),
        },
    }
}

fn refused(study: &LoadedStudy, key: &str, message: &str, cure: &str) -> DiagnoseError {
    refused_in(&study.path, "study file", key, message, cure).into()
}

/// An effect that cannot join the model of a study.
struct Unable {
    name: String,
    reason: String,
    stands: Stands,
}

/// Where an effect stands already.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stands {
    /// Among the effects of the study.
    InStudy,
    /// In a design of it.
    InDesign,
    Nowhere,
}

/// Those of these effects that cannot join the model of a study.
fn unable(study: &LoadedStudy, names: &[String]) -> Result<Vec<Unable>, StudyError> {
    let tried: Vec<&str> = names.iter().map(String::as_str).collect();
    let cases = study
        .cases
        .iter()
        .map(|case| PreparedCase::new(case, study, &tried));
    let cases: Vec<PreparedCase> = cases.collect::<Result<_, _>>()?;
    let mut unable = Vec::new();
    for name in names {
        let in_study = study.study.effect.iter().any(|effect| effect.name == *name);
        let tried = cases.iter().any(|case| case.tries(name));
        let stands = match (in_study, cases.iter().any(|case| case.states(name))) {
            (true, _) => Stands::InStudy,
            (false, true) if !tried => Stands::InDesign,
            _ => Stands::Nowhere,
        };
        let reason = if stands == Stands::InStudy {
            "it stands in the study already ([[effect]])".to_string()
        } else if stands == Stands::InDesign {
            format!("it stands in the design already ([effects.{name}]), and is part of the model")
        } else if tried {
            continue;
        } else {
            let mut lacking: Vec<String> = Vec::new();
            for case in cases
                .iter()
                .filter(|case| study.study.is_tried_on(&case.design.name))
            {
                let lack = named(name).and_then(|effect| case.why_not_tried(effect));
                lacking.extend(lack.filter(|lack| !lacking.contains(lack)));
            }
            lacking.join(", or ")
        };
        unable.push(Unable {
            name: name.clone(),
            reason,
            stands,
        });
    }
    Ok(unable)
}

/// Why none of the effects that are to be tried, which are these, can join the model.
fn none_joins(unable: &[Unable]) -> String {
    match unable {
        [] => "there is no effect in it".to_string(),
        [only] => format!("{} cannot join the model: {}", only.name, only.reason),
        _ => {
            let reasons = unable.iter().take(TOLD);
            let reasons: Vec<String> = reasons
                .map(|unable| format!("{}: {}", unable.name, unable.reason))
                .collect();
            let more = match unable.len().saturating_sub(TOLD) {
                0 => String::new(),
                more => format!("; and {more} more"),
            };
            format!("none of them can join the model: {}{more}", reasons.join("; "))
        }
    }
}
