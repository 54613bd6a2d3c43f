//! What an effect does to the still wing on a bench: its strength as something that can be measured without air.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::Design;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::bench::torque;
use crate::wing::{WingError, WingModel};

/// Twist that the torque is to make in the rods, deg.
const TWIST_DEG: f64 = 10.0;

/// Share of the twist by which an effect must move it to be said.
const SEEN: f64 = 0.01;

/// The still wing under a torque, with the effect and without it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OnBench {
    /// The wing, and the torque, in words.
    pub load: String,
    /// How far it turns there with the effect at its strength, deg, positive nose down.
    pub with_effect_deg: f64,
    /// The same without it, all else as calibrated.
    pub without_deg: f64,
}

impl OnBench {
    /// The first wing that the effect moves on a bench, of designs as calibrated with it; none if it moves no wing there.
    ///
    /// # Errors
    /// If it moves none that has an equilibrium there, and one has none, or the user asked to stop: why.
    pub fn of(
        study: &LoadedStudy,
        calibrated: &[Design],
        effect: &str,
        progress: &Progress,
    ) -> Result<Option<OnBench>, WingError> {
        let mut unsolved = None;
        for design in calibrated
            .iter()
            .filter(|design| design.effects.contains_key(effect))
        {
            match on_bench(study, design, effect, progress) {
                Ok(Some(found)) => return Ok(Some(found)),
                Ok(None) => {}
                Err(error) => unsolved = Some(error),
            }
        }
        unsolved.map_or(Ok(None), Err)
    }
}

/// The same of one wing; none if the effect does not move it, or no torque can be put on it.
fn on_bench(
    study: &LoadedStudy,
    calibrated: &Design,
    effect: &str,
    progress: &Progress,
) -> Result<Option<OnBench>, WingError> {
    let own = study
        .cases
        .iter()
        .find(|case| case.loaded.design.name == calibrated.name);
    let Some(mut case) = own.cloned() else {
        return Ok(None);
    };
    case.loaded.design = calibrated.clone();
    let Some(still) = torque(&case, TWIST_DEG) else {
        return Ok(None);
    };
    let at_m = still
        .loaded
        .design
        .load
        .first()
        .map_or(0.0, |load| 1e-3 * load.at_mm.value());
    let wing = WingModel::new(still.loaded)?;
    let with_effect = wing.solve(progress)?;
    let without = wing.with_effect(effect, 0.0)?.solve(progress)?;
    let Some((with_effect, without)) = with_effect.twist_at(at_m).zip(without.twist_at(at_m)) else {
        return Ok(None);
    };
    let is_seen = (with_effect - without).abs() > SEEN * without.abs();
    Ok(is_seen.then(|| OnBench {
        load: still.name,
        with_effect_deg: with_effect.to_degrees(),
        without_deg: without.to_degrees(),
    }))
}
