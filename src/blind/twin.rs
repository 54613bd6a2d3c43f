//! Whether a hidden effect can be told from another at all: readings that the model with it makes, without any error, explained
//! by another.

use crate::diagnose::Settings;
use crate::diagnose::baseline::Baseline;
use crate::diagnose::library::{Scales, families, heaviest};
use crate::diagnose::refit::Explanation;
use crate::diagnose::screening::effect_of;
use crate::progress::Progress;
use crate::study::{Footing, Forward};

use super::spot::Spot;
use super::{Blind, BlindError};

/// Other families that are fitted, the best of the linear model first.
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
    let baseline = Baseline::new(&told, &settings, Some(&blind.shared), &progress.unseen())?;
    let footing = baseline.footing.as_ref().map(Footing::for_trials);
    let refits = baseline.refits(footing.as_ref());
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
        Some(own) => refits.refit_from(&[own], &[at])?,
        None => None,
    };
    let families = families(&told, &baseline.data, &baseline.directions.lengths);
    let own = effect_of(&unknowns[spot.strength]).map_or("", |(_, family, _, _)| family);
    let mut trials = Scales::of(&baseline).singles(&families, 1.0);
    trials.retain(|trial| trial.members.len() == 1 && families[trial.families[0]].name != own);
    let mut nearest = f64::INFINITY;
    for index in heaviest(&trials, FITTED, 1) {
        let trial = &trials[index];
        if let Some(found) = refits.refit(&trial.members, &trial.linear.estimate[..1])? {
            nearest = nearest.min(left(&found));
        }
    }
    Ok((nearest - itself.as_ref().map_or(0.0, left)).max(0.0).sqrt())
}
