//! The wings of a study's cases, solved once more for a report: uncalibrated, calibrated, with what a diagnosis found.

use std::collections::BTreeMap;

use crate::compare::ComparedStudy;
use crate::coupling::sensitivity::Nearby;
use crate::diagnose::strengths::Strength;
use crate::diagnose::{Diagnosis, Verdict};
use crate::input::Assumption;
use crate::input::study::LoadedStudy;
use crate::observation::Observer;
use crate::progress::{Cancelled, Progress};
use crate::study::{Campaign, Forward, Unknown, UnknownKind};

use super::effects::{EffectAtWork, EffectsAtWork};
use super::measured::Measured;
use super::study::StudyParts;
use super::wing::Wing;
use super::wings::Wings;

/// Cases of a study whose wings a report shows; of more, some evenly among them.
const SHOWN: usize = 12;

impl StudyParts {
    /// What a report shows besides: the wings uncalibrated and calibrated, what the designs assume.
    pub fn new(
        compared: &ComparedStudy,
        study: &LoadedStudy,
        progress: &Progress,
    ) -> Result<StudyParts, Cancelled> {
        let calibrated = compared.calibrated();
        let mut shown = wings(
            &compared.campaign,
            "uncalibrated",
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

/// The wings with what a diagnosis holds most probable, then those uncalibrated.
pub fn found(campaign: &Campaign, diagnosis: &Diagnosis, progress: &Progress) -> Result<Wings, Cancelled> {
    let mut shown = explained(campaign, diagnosis, progress)?;
    shown.extend(wings(campaign, "uncalibrated", &campaign.start(), progress)?);
    Ok(shown)
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
        put(campaign, &mut at, strength);
    }
    let state = format!("with {}", first.effects.join(" + "));
    let mut wings = wings(campaign, &state, &at, progress)?;
    wings
        .notes
        .push(format!("In the wings {state} all else is uncalibrated."));
    Ok(wings)
}

/// Effects that a report draws; of more the most probable.
const DRAWN: usize = 6;

/// The effects of the most probable hypotheses, each by itself at its size on the first wing that it acts on, as far as that has a solution;
/// what is not drawn is noted.
pub fn at_work(
    campaign: &Campaign,
    found: &Diagnosis,
    progress: &Progress,
) -> Result<EffectsAtWork, Cancelled> {
    let likely = found.hypotheses.iter().filter(|hypothesis| hypothesis.in_set);
    let mut effects: Vec<&Strength> = Vec::new();
    for strength in likely.flat_map(|hypothesis| &hypothesis.strengths) {
        if effects.iter().all(|known| known.effect != strength.effect) {
            effects.push(strength);
        }
    }
    let mut drawn = EffectsAtWork::default();
    let more: Vec<&str> = effects
        .iter()
        .skip(DRAWN)
        .map(|own| own.effect.as_str())
        .collect();
    if !more.is_empty() {
        drawn
            .notes
            .push(format!("Less probable, and not drawn: {}.", more.join(", ")));
    }
    for strength in effects.into_iter().take(DRAWN) {
        progress.say(format_args!("{}: {} drawn", campaign.name, strength.effect));
        match one_at_work(campaign, strength) {
            Some(one) => drawn.shown.push(one),
            None => drawn.notes.push(format!(
                "Not drawn: {}, for the first wing that it acts on has no solution with it alone.",
                strength.effect
            )),
        }
        progress.check()?;
    }
    Ok(drawn)
}

/// An effect at work; none where it acts on no wing, or a wing has no solution.
fn one_at_work(campaign: &Campaign, strength: &Strength) -> Option<EffectAtWork> {
    let without = campaign.start();
    let mut with = without.clone();
    put(campaign, &mut with, strength);
    let design = |case: usize, at: &[f64]| campaign.design_at(case, at).ok();
    let case = (0..campaign.cases().len()).find(|&case| design(case, &without) != design(case, &with))?;
    let [without, with] = [without, with].map(|at| campaign.solved_at(case, &at).ok());
    let (without, with) = (without?, with?);
    Some(EffectAtWork {
        effect: strength.effect.clone(),
        case: campaign.cases()[case].name.clone(),
        mesh: without.at.solution.mesh.clone(),
        difference: with.difference(&without)?,
        twist_deg: [twist_deg(&without.at)?, twist_deg(&with.at)?],
    })
}

/// Twist along the span as it is read: places (m), twist (deg).
fn twist_deg(solved: &Nearby) -> Option<Vec<[f64; 2]>> {
    let observer = Observer::new(&solved.design, &solved.planform, &solved.solution).ok()?;
    let readings = observer.along_span().into_iter();
    Some(
        readings
            .map(|reading| [reading.r_m, reading.twist_rad.to_degrees()])
            .collect(),
    )
}

/// Puts an effect at its size and place.
fn put(campaign: &Campaign, at: &mut [f64], strength: &Strength) {
    if let Some(index) = position(campaign, |unknown| unknown.name == strength.unknown) {
        at[index] = strength.value;
    }
    let place = position(campaign, |unknown| is_place_of(unknown, &strength.unknown));
    if let (Some(found), Some(place)) = (&strength.place, place) {
        at[place] = found.value;
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
