//! How far a hidden effect moves the readings, what the model could absorb left out: by the full model, not by its slope at
//! zero.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::spot::Spot;
use super::{Blind, BlindError, Turned};
use crate::diagnose::plan::PlannedEffect;
use crate::diagnose::screening::effect_of;
use crate::effects::named;
use crate::progress::Progress;
use crate::study::{Campaign, Forward, StudyError};
use crate::synthesize::{Hidden, Recipe, unlike};

/// Tries for a strength, and the share of the wanted distance within which one is good.
const TRIES: usize = 10;
pub const NEAR: f64 = 0.15;
/// Largest factor from one try to the next.
const LONGEST: f64 = 8.0;

/// Distance at which the signature of an effect is compared with that on another wing, sigma.
const COMPARED: f64 = 10.0;
/// Cosine below which it counts as turned.
const SAME: f64 = 0.9;

/// Distances in standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// From the model without the effect.
    pub seen: f64,
    /// From the model with the nearest effect of another family.
    pub apart: f64,
}

/// Distances of each of `hidden` alone; none of those that the diagnosis cannot try.
///
/// # Errors
/// If the model with one of them has no solution.
pub fn distances(blind: &Blind, hidden: &[Hidden]) -> Result<Vec<Distance>, BlindError> {
    let mut found = Vec::new();
    for effect in hidden {
        if let Some(spot) = Spot::of(&blind.campaign, effect) {
            found.push(distance(blind, spot, effect.strength)?);
        }
    }
    Ok(found)
}

/// The strength of `effect` at `spot`, of sign `sign` if it may have that, which is seen at distance `target`, or the largest plausible
/// one if that is nearer; and the distance at which it is seen.
pub fn strength_seen_at(
    blind: &Blind,
    (effect, spot): (&PlannedEffect, Spot),
    target: f64,
    sign: f64,
) -> (f64, f64) {
    let [low, high] =
        named(&effect.effect).map_or([0.0, effect.scale], |known| known.card().parameters[0].plausible);
    let sign = if sign < 0.0 && low >= 0.0 { 1.0 } else { sign };
    let sign = if sign > 0.0 && high <= 0.0 { -1.0 } else { sign };
    let most = if sign < 0.0 { -low } else { high };
    let mut size = (effect.judged_at * target / effect.detectability).min(most);
    let mut best = (f64::INFINITY, size, 0.0);
    let [mut too_small, mut too_large] = [None, None];
    for _ in 0..TRIES {
        // a strength with which the wing has no equilibrium is too large
        let seen = distance(blind, spot, sign * size).map_or(f64::INFINITY, |distance| distance.seen);
        let off = (seen / target).max(1e-9).ln().abs();
        if off < best.0 {
            best = (off, size, seen);
        }
        if off < NEAR || (seen < target && size >= most) {
            break;
        }
        *if seen < target {
            &mut too_small
        } else {
            &mut too_large
        } = Some(size);
        let next = size * (target / seen).clamp(1.0 / LONGEST, LONGEST);
        size = match (too_small, too_large) {
            // what grows faster or slower than its strength is closed in on
            (Some(small), Some(large)) if !(small < next && next < large) => f64::sqrt(small * large),
            _ => next.min(most),
        };
    }
    (sign * best.1, best.2)
}

/// Effects that would be seen whose signature turns with errors of outline, stiffness and air law of one percent: they are
/// large where the wing's motion is near a resonance, and no campaign there can name them.
///
/// # Errors
/// If the other wing has no solution.
pub fn turned(blind: &Blind, progress: &Progress) -> Result<Vec<Turned>, BlindError> {
    let other = unlike(blind.study, &Recipe::new(0).made)?;
    let other = Campaign::new(&other, &blind.candidates, &progress.unseen())?;
    let still = other.predict(&other.start())?;
    let visible = blind
        .outlook
        .plan
        .effects
        .par_iter()
        .filter(|effect| blind.sees(effect));
    let found = visible.map(|effect| {
        progress.check().map_err(StudyError::from)?;
        let somewhere = Hidden::known(&effect.effect, 0.0);
        let Some(spot) = Spot::of(&blind.campaign, &somewhere) else {
            return Ok(None);
        };
        let (strength, _) = strength_seen_at(blind, (effect, spot), COMPARED, 1.0);
        let of = |campaign: &Campaign| -> Option<_> {
            let spot = Spot::of(campaign, &somewhere)?;
            campaign.predict(&spot.with(&campaign.start(), strength)).ok()
        };
        let cosine = of(&blind.campaign).zip(of(&other)).map(|(here, there)| {
            let here = blind.outlook.seen(&(here - &blind.outlook.predicted));
            let there = blind.outlook.seen(&(there - &still));
            here.dot(&there) / (here.norm() * there.norm()).max(f64::MIN_POSITIVE)
        });
        Ok(Some(Turned {
            effect: effect.effect.clone(),
            cosine,
        }))
    });
    let found: Vec<Option<Turned>> = found.collect::<Result<_, BlindError>>()?;
    let is_turned = |turned: &Turned| turned.cosine.is_none_or(|cosine| cosine < SAME);
    Ok(found.into_iter().flatten().filter(is_turned).collect())
}

fn distance(blind: &Blind, spot: Spot, strength: f64) -> Result<Distance, BlindError> {
    let unknowns = blind.campaign.unknowns();
    let readings = blind
        .campaign
        .predict(&spot.with(&blind.outlook.start, strength))?;
    let family = effect_of(&unknowns[spot.strength]).map_or("", |(_, family, _, _)| family);
    Ok(Distance {
        seen: blind.outlook.distance(&readings),
        apart: blind.outlook.apart(&blind.campaign, &readings, family),
    })
}
