//! Whether a hidden effect can be told from another at all: readings that the model with it makes, without any error, explained
//! by another.

use crate::diagnose::Settings;
use crate::diagnose::baseline::Baseline;
use crate::diagnose::library::Trial;
use crate::diagnose::refit::{Explanation, Refits};
use crate::diagnose::screening::effect_of;
use crate::progress::Progress;
use crate::study::{Forward, WarmStart};

use super::spot::Spot;
use super::{Blind, BlindError};

/// Other families that are fitted, the most probable first.
const FITTED: usize = 3;

/// How much less well another family explains the readings of the model with the effect at `spot`, sigma: the root of what it leaves
/// of them, and of the priors of the model's uncertain inputs, that the effect itself does not. Infinite if none explains anything.
///
/// # Errors
/// If the model with the effect has no solution, or the user asked to stop.
pub fn apart(blind: &Blind, spot: Spot, strength: f64, progress: &Progress) -> Result<f64, BlindError> {
    let at = spot.with(&blind.outlook.start, strength);
    let told = blind.campaign.with_values(&blind.campaign.predict(&at)?);
    let settings = Settings {
        noise_scale: Some(1.0),
        ..blind.settings.clone()
    };
    let baseline = Baseline::new(&told, &settings, Some(&blind.table), &progress.unseen())?;
    let warm_start = baseline.warm_start.as_ref().map(WarmStart::for_trials);
    let refits = Refits::of(&baseline, warm_start.as_ref());
    let (unknowns, members) = (told.unknowns(), &baseline.data.missing);
    // the strength itself may be what it likes within its range
    let left = |found: &Explanation| {
        let pulls = found.members.iter().zip(&found.strength).map(|(&k, strength)| {
            let unknown = &unknowns[members[k]];
            ((strength - unknown.mean) / unknown.sigma).powi(2)
        });
        found.q - pulls.sum::<f64>()
    };
    let itself = match members.iter().position(|&i| i == spot.strength) {
        Some(own) => refits.refit_from(&[own], &[at], &baseline.scatter)?,
        None => None,
    };
    let own = effect_of(&unknowns[spot.strength]).map_or("", |(_, family, _, _)| family);
    let family = |trial: &&Trial| baseline.families[trial.families[0]].name.as_str();
    let mut trials: Vec<&Trial> = baseline
        .weighing
        .singles
        .iter()
        .filter(|trial| family(trial) != own)
        .collect();
    trials.sort_by(|a, b| b.ln_weight.total_cmp(&a.ln_weight));
    let mut known: Vec<usize> = Vec::new();
    trials.retain(|trial| {
        let is_new = !known.contains(&trial.families[0]);
        known.push(trial.families[0]);
        is_new
    });
    let mut nearest = f64::INFINITY;
    for trial in trials.into_iter().take(FITTED) {
        let start = refits.stepped(&trial.members, &trial.best);
        if let Some(found) = refits.refit_from(&trial.members, &[start], &baseline.scatter)? {
            nearest = nearest.min(left(&found));
        }
    }
    Ok((nearest - itself.as_ref().map_or(0.0, left)).max(0.0).sqrt())
}
