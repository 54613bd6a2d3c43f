//! The wings of a study's cases, solved once more for a report: as stated, as calibrated, with what a diagnosis found.

use std::collections::BTreeMap;

use crate::compare::ComparedStudy;
use crate::diagnose::{Diagnosis, Verdict};
use crate::input::Assumption;
use crate::input::study::LoadedStudy;
use crate::progress::{Cancelled, Progress};
use crate::study::{Campaign, Forward, Unknown, UnknownKind};

use super::measured::Measured;
use super::study::StudyParts;
use super::wing::Wing;
use super::wings::Wings;

/// Cases of a study whose wings a report shows; of more, some evenly among them.
const SHOWN: usize = 12;

impl StudyParts {
    /// What a report shows besides: the wings as stated and as calibrated, what the designs assume.
    pub fn new(
        compared: &ComparedStudy,
        study: &LoadedStudy,
        progress: &Progress,
    ) -> Result<StudyParts, Cancelled> {
        let mut calibrated = compared.campaign.start();
        for found in &compared.comparison.unknowns {
            put(
                &compared.campaign,
                &mut calibrated,
                &found.unknown.name,
                found.value,
            );
        }
        let mut shown = wings(
            &compared.campaign,
            "as stated",
            &compared.campaign.start(),
            progress,
        )?;
        if !compared.comparison.unknowns.is_empty() {
            shown.extend(wings(&compared.campaign, "calibrated", &calibrated, progress)?);
        }
        Ok(StudyParts {
            wings: shown,
            assumed: assumed(study),
            diagnosis: None,
        })
    }
}

/// The wings as stated, and with what a diagnosis holds most probable.
pub fn found(campaign: &Campaign, diagnosis: &Diagnosis, progress: &Progress) -> Result<Wings, Cancelled> {
    let mut wings = wings(campaign, "as stated", &campaign.start(), progress)?;
    wings.extend(explained(campaign, diagnosis, progress)?);
    Ok(wings)
}

/// The wings with what a diagnosis holds most probable, if it names an effect.
pub fn explained(campaign: &Campaign, found: &Diagnosis, progress: &Progress) -> Result<Wings, Cancelled> {
    if !matches!(found.verdict, Verdict::Effect | Verdict::Set) {
        return Ok(Wings::default());
    }
    let Some(first) = found
        .hypotheses
        .iter()
        .find(|hypothesis| !hypothesis.strengths.is_empty())
    else {
        return Ok(Wings::default());
    };
    let mut at = campaign.start();
    for strength in &first.strengths {
        put(campaign, &mut at, &strength.unknown, strength.value);
        let place = position(campaign, |unknown| is_place_of(unknown, &strength.unknown));
        if let (Some(found), Some(place)) = (&strength.place, place) {
            at[place] = found.value;
        }
    }
    let state = format!("with {}", first.effects.join(" + "));
    let mut wings = wings(campaign, &state, &at, progress)?;
    wings
        .notes
        .push(format!("{state}: all else as stated, not calibrated anew."));
    Ok(wings)
}

fn put(campaign: &Campaign, at: &mut [f64], name: &str, value: f64) {
    if let Some(index) = position(campaign, |unknown| unknown.name == name) {
        at[index] = value;
    }
}

fn position(campaign: &Campaign, is_it: impl Fn(&Unknown) -> bool) -> Option<usize> {
    campaign.unknowns().iter().position(is_it)
}

fn is_place_of(unknown: &Unknown, strength: &str) -> bool {
    matches!(&unknown.kind, UnknownKind::Place { of, .. } if of == strength)
}

/// The wings of a campaign with these values of its unknowns, as far as they have a solution there.
fn wings(campaign: &Campaign, state: &str, at: &[f64], progress: &Progress) -> Result<Wings, Cancelled> {
    let count = campaign.cases().len();
    let mut wings = Wings::default();
    if count > SHOWN {
        let words = format!("{SHOWN} of {count} cases are shown {state}, evenly among them.");
        wings.notes.push(words);
    }
    for place in 0..count.min(SHOWN) {
        let index = place * count / count.min(SHOWN);
        let case = &campaign.cases()[index];
        progress.say(format_args!("{}: {} {state}", campaign.name, case.name));
        let solved = campaign.solved_at(index, at);
        progress.check()?;
        let name = format!("{}, {state}", case.name);
        match solved {
            Ok(solved) => {
                let found = &solved.at;
                let mut wing = Wing::of_solution(&name, &found.design, &found.planform, &found.solution);
                wing.measured = Measured::of_rows(&case.rows);
                wings.shown.push(wing);
            }
            Err(error) => wings.notes.push(format!("Not shown: {name}: {error}")),
        }
    }
    Ok(wings)
}

/// Designs of a study with what each assumes, each once.
fn assumed(loaded: &LoadedStudy) -> Vec<(String, Vec<Assumption>)> {
    let mut designs = BTreeMap::new();
    for case in &loaded.cases {
        let design = &case.loaded.design;
        designs
            .entry(design.name.clone())
            .or_insert_with(|| design.assumptions());
    }
    designs.into_iter().collect()
}
