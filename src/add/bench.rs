//! What an effect does to the still wing on a bench: its strength as something that can be measured without air.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::Design;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::bench::torque;
use crate::wing::{SolvedWing, WingModel};

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
    /// The first wing that the effect moves on a bench, of designs as calibrated with it; none if it moves no wing there, or it has no
    /// equilibrium.
    pub fn of(
        study: &LoadedStudy,
        calibrated: &[Design],
        effect: &str,
        progress: &Progress,
    ) -> Option<OnBench> {
        let mut wings = calibrated.iter();
        wings.find_map(|design| on_bench(study, design, effect, progress))
    }
}

fn on_bench(study: &LoadedStudy, calibrated: &Design, effect: &str, progress: &Progress) -> Option<OnBench> {
    let numbers = calibrated.effects.get(effect)?;
    let strength = numbers.get("strength")?.as_float()?;
    let mut case = study
        .cases
        .iter()
        .find(|case| case.loaded.design.name == calibrated.name)?
        .clone();
    case.loaded.design = calibrated.clone();
    let still = torque(&case, TWIST_DEG)?;
    let at_m = 1e-3 * still.loaded.design.load.first()?.at_mm.value();
    let wing = WingModel::new(still.loaded).ok()?;
    let twist_deg = |strength: f64| -> Option<f64> {
        let solved: SolvedWing = wing.with_effect(effect, strength).ok()?.solve(progress).ok()?;
        Some(solved.twist_at(at_m)?.to_degrees())
    };
    let (with_effect_deg, without_deg) = (twist_deg(strength)?, twist_deg(0.0)?);
    let is_seen = (with_effect_deg - without_deg).abs() > SEEN * without_deg.abs();
    is_seen.then_some(OnBench {
        load: still.name,
        with_effect_deg,
        without_deg,
    })
}
