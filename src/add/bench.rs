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

/// How well a bench tells two twists apart: what it reads, deg, and what is not known of the wing, as a share of its twist. Assumed; they choose the
/// station alone.
const READ_DEG: f64 = 0.25;
const KNOWN: f64 = 0.1;

/// The still wing under a torque, with the effect and without it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OnBench {
    /// The wing, and the torque, in words.
    pub load: String,
    /// Where it is to be read, from the wing base, mm: of the ends of the spars, where both are farthest apart for their size.
    pub r_mm: f64,
    /// How far the wing as calibrated with the effect turns there, deg, positive nose down.
    pub with_effect_deg: f64,
    /// The same of the wing as calibrated without it.
    pub without_deg: f64,
}

impl OnBench {
    /// The first wing that the effect moves on a bench; none if it moves no wing there. `with` and `without`: the designs as calibrated with
    /// the effect and without it.
    ///
    /// # Errors
    /// If it moves none that has an equilibrium there, and one has none, or the user asked to stop: why.
    pub fn of(
        study: &LoadedStudy,
        with: &[Design],
        without: &[Design],
        effect: &str,
        progress: &Progress,
    ) -> Result<Option<OnBench>, WingError> {
        let mut unsolved = None;
        for design in with.iter().filter(|design| design.effects.contains_key(effect)) {
            let other = without.iter().find(|other| other.name == design.name);
            match on_bench(study, [design, other.unwrap_or(design)], effect, progress) {
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
    [with, without]: [&Design; 2],
    effect: &str,
    progress: &Progress,
) -> Result<Option<OnBench>, WingError> {
    let own = study
        .cases
        .iter()
        .find(|case| case.loaded.design.name == with.name);
    let Some(case) = own else {
        return Ok(None);
    };
    let as_calibrated = |design: &Design| {
        let mut case = case.clone();
        case.loaded.design = design.clone();
        case
    };
    let Some((bench, still)) = torque(&as_calibrated(with), TWIST_DEG) else {
        return Ok(None);
    };
    let at_mm = bench.at_mm;
    let model = WingModel::new(still.loaded)?;
    let with_effect = model.solve(progress)?;
    let alone = model.with_effect(effect, 0.0)?.solve(progress)?;
    let is_seen = |r_mm: f64| {
        let twists = with_effect.twist_at(1e-3 * r_mm).zip(alone.twist_at(1e-3 * r_mm));
        twists.is_some_and(|(with, alone)| (with - alone).abs() > SEEN * alone.abs())
    };
    if !is_seen(at_mm) {
        return Ok(None);
    }
    // the same torque, though the rods of the other may be softer
    let mut other = as_calibrated(without);
    bench.put(&mut other.loaded.design);
    let mut other = WingModel::new(other.loaded)?;
    if without.effects.contains_key(effect) {
        other = other.with_effect(effect, 0.0)?;
    }
    let without = other.solve(progress)?;
    let spars = with.spar.iter().map(|spar| spar.at_mm.value());
    let read = spars.chain([at_mm]).filter_map(|r_mm| {
        let at_m = 1e-3 * r_mm;
        let (with, without) = with_effect.twist_at(at_m).zip(without.twist_at(at_m))?;
        Some([r_mm, with.to_degrees(), without.to_degrees()])
    });
    let apart = |[_, with, without]: &[f64; 3]| (with - without).abs() / READ_DEG.hypot(KNOWN * without);
    let best = read.max_by(|a, b| apart(a).total_cmp(&apart(b)));
    Ok(best.map(|[r_mm, with_effect_deg, without_deg]| OnBench {
        load: still.name,
        r_mm,
        with_effect_deg,
        without_deg,
    }))
}
