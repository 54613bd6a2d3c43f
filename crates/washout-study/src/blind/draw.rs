//! What is hidden in a case.

use super::distance::{NEAR, strength_seen_at};
use super::novel::novel;
use super::spot::Spot;
use super::twin;
use super::{Blind, BlindError, Kind};
use crate::diagnose::plan::PlannedEffect;
use crate::diagnose::posterior::TWINS;
use crate::progress::Progress;
use crate::study::draws::Draws;
use crate::synthesize::{Hidden, Recipe};

/// An effect has a twin if the readings that it makes are explained by another less than [`TWINS`] away in the full model; effects further
/// apart by their slopes than this, sigma, are not looked at.
const NEARLY_TWINS: f64 = 2.0;
/// Scatter over what is stated where that is 30 % too small.
const QUIET: f64 = 1.0 / 0.7;
/// Refinements of the wing that is measured over that of the model.
const MESHES: [f64; 3] = [1.2, 1.3, 0.85];

/// The recipe of a case; each kind and seed has its own, and another for each try.
///
/// # Errors
/// If the campaign allows no such case, or the wing with it has no solution.
pub fn recipe(
    blind: &Blind,
    (kind, seed): (Kind, u64),
    attempt: u64,
    progress: &Progress,
) -> Result<Recipe, BlindError> {
    let own = seed.wrapping_mul(1000).wrapping_add(kind as u64);
    let draws = Draws::new(own.wrapping_add(attempt * 1_000_000_007));
    // the diagnosis draws its noise with seed 1: another seed, whatever the case
    let mut recipe = Recipe::new(1_000_000 + 1000 * seed + kind as u64);
    recipe.made.mesh = MESHES[(draws.uniform(1, 0) * MESHES.len() as f64) as usize];
    let [least, most] = blind.ranges.background;
    recipe.made.background = least + (most - least) * draws.uniform(1, 1);
    let none = |reason| BlindError::NoCase {
        kind: kind.word(),
        reason,
    };
    let is_turned = |effect: &PlannedEffect| blind.turned.iter().any(|turned| turned.effect == effect.effect);
    let may = |effect: &PlannedEffect| blind.sees(effect) && !is_turned(effect);
    match kind {
        Kind::Null => {}
        Kind::NullQuiet => recipe.noise = QUIET,
        Kind::NullOutlier => recipe.outlier = Some(8.0),
        Kind::Single => {
            let first = pick(&blind.outlook.plan.effects, draws, 0, &may)
                .ok_or(none("no effect of plausible size would be seen"))?;
            recipe.hidden = vec![hidden(blind, first, draws, 0)?];
        }
        Kind::Twin => {
            let first = pick(&blind.outlook.plan.effects, draws, 0, &|effect| {
                may(effect) && has_twin(effect, target(blind, draws, 0).min(effect.detectability))
            })
            .ok_or(none("no two effects look alike"))?;
            let hidden = hidden(blind, first, draws, 0)?;
            let spot =
                Spot::of(&blind.campaign, &hidden).ok_or(none("the effect acts on none of its wings"))?;
            let apart = twin::apart(blind, spot, hidden.strength, progress)?;
            if apart > TWINS {
                return Err(BlindError::NoTwin {
                    effect: hidden.name,
                    strength: hidden.strength,
                    apart,
                });
            }
            recipe.hidden = vec![hidden];
        }
        Kind::Pair => {
            let reason = "fewer than two families would be seen";
            let first = pick(&blind.outlook.plan.effects, draws, 0, &may).ok_or(none(reason))?;
            let other = |effect: &PlannedEffect| may(effect) && effect.family != first.family;
            let second = pick(&blind.outlook.plan.effects, draws, 1, &other).ok_or(none(reason))?;
            recipe.hidden = vec![hidden(blind, first, draws, 0)?, hidden(blind, second, draws, 1)?];
        }
        Kind::Novel => recipe.hidden = vec![novel(blind, draws, progress)?],
    }
    Ok(recipe)
}

fn pick<'a>(
    effects: &'a [PlannedEffect],
    draws: Draws,
    which: u64,
    may: &dyn Fn(&PlannedEffect) -> bool,
) -> Option<&'a PlannedEffect> {
    let mut may: Vec<&PlannedEffect> = effects.iter().filter(|effect| may(effect)).collect();
    // the order of the plan is that of its figures; names do not depend on rounding
    may.sort_by(|a, b| a.effect.cmp(&b.effect));
    let place = (draws.uniform(2, which) * may.len() as f64) as usize;
    may.get(place).copied()
}

/// Whether another effect comes as near as no statistic can tell to it where it stands `seen` sigma out of the data.
fn has_twin(effect: &PlannedEffect, seen: f64) -> bool {
    let apart = |cosine: f64| seen * (1.0 - cosine * cosine).max(0.0).sqrt();
    effect
        .confused_with
        .iter()
        .any(|other| apart(other.cosine) < NEARLY_TWINS)
}

/// Detectability that is drawn for a hidden effect, sigma.
fn target(blind: &Blind, draws: Draws, which: u64) -> f64 {
    let [low, high] = blind.ranges.detectable;
    low + (high - low) * draws.uniform(3, which)
}

/// With a strength that is seen at a distance drawn from the range, as far as it is plausible.
fn hidden(blind: &Blind, effect: &PlannedEffect, draws: Draws, which: u64) -> Result<Hidden, BlindError> {
    let target = target(blind, draws, which);
    let sign = if draws.uniform(4, which) < 0.5 { 1.0 } else { -1.0 };
    let spot = Spot::drawn(&blind.campaign, &effect.effect, draws, 8 + which).ok_or(BlindError::NoCase {
        kind: "with an effect",
        reason: "the effect acts on none of its wings",
    })?;
    let (strength, seen) = strength_seen_at(blind, (effect, spot), target, sign);
    if seen < blind.ranges.detectable[0] * (1.0 - NEAR) {
        return Err(BlindError::TooFaint {
            effect: effect.effect.clone(),
            seen,
        });
    }
    Ok(spot.hidden(&blind.campaign, &effect.effect, strength))
}
