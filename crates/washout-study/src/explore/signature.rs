//! What an effect does to an example wing, that of `washout init`: the picture on its card.

use std::path::Path;

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::aero::Flow;
use crate::effects::Effect;
use crate::input::design::{Design, INIT};
use crate::progress::Progress;
use crate::wing::WingModel;

use super::ExploreError;

/// The mesh of the example wing.
const COARSE: &str = "mesh.refine=0.5";
/// Halvings of a strength with which the wing has no equilibrium.
const HALVINGS: usize = 4;

/// What an effect changes on the example wing, where all else stays.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Signature {
    /// Its strength, in the unit of its card: the largest plausible one, or what is left of it after halvings until the wing has an
    /// equilibrium.
    pub strength: f64,
    /// The largest plausible one.
    pub plausible: f64,
    /// Keys of the example that were set, so that the effect has something to act on.
    pub set: Vec<String>,
    /// Twist at the base, the spars and the tip.
    pub stations: Vec<TwistChange>,
    /// Change of the deflection of the leading edge at the tip, mm, positive along +z.
    pub tip_deflection_mm: f64,
    /// Change of the force of the air across stream and span, mN.
    pub lift_mn: f64,
}

/// Twist at a station.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TwistChange {
    /// Distance from the wing base, mm.
    pub r_mm: f64,
    /// Twist without the effect, deg, positive washout.
    pub without_deg: f64,
    /// What the effect adds, deg.
    pub change_deg: f64,
}

/// The signature of an effect at its largest plausible strength.
///
/// # Errors
/// If the example has no solution with it, or the user asked to stop.
pub fn signature(effect: &dyn Effect, progress: &Progress) -> Result<Signature, ExploreError> {
    let card = effect.card();
    let set: Vec<String> = (effect.set_on_example().iter())
        .map(|set| set.to_string())
        .collect();
    let without = read(&set, progress)?;
    let plausible = card.parameters[0].scale();
    let mut strength = plausible;
    let mut halvings = 0;
    let with = loop {
        let own = format!("effects.{}.strength={strength:?}", card.name);
        match read(&[&set[..], &[own]].concat(), progress) {
            Err(ExploreError::Coupling(error)) if error.is_not_converged() && halvings < HALVINGS => {
                halvings += 1;
                strength *= 0.5;
            }
            found => break found?,
        }
    };
    let stations = without.twist.iter().zip(&with.twist);
    Ok(Signature {
        strength,
        plausible,
        set,
        stations: stations
            .map(|(without, with)| TwistChange {
                r_mm: without[0],
                without_deg: without[1],
                change_deg: with[1] - without[1],
            })
            .collect(),
        tip_deflection_mm: with.tip_deflection_mm - without.tip_deflection_mm,
        lift_mn: with.lift_mn - without.lift_mn,
    })
}

/// What is read of the example: station, mm, and twist, deg; deflection of the leading edge at the tip; force across the stream.
struct Read {
    twist: Vec<[f64; 2]>,
    tip_deflection_mm: f64,
    lift_mn: f64,
}

fn read(set: &[String], progress: &Progress) -> Result<Read, ExploreError> {
    let text = INIT.replace("NAME", "example");
    let text = match set.iter().any(|set| set.starts_with("steady.")) {
        true => without_flapping(&text),
        false => text,
    };
    let sets = [set, &[COARSE.to_string()]].concat();
    let design: Design = Design::load_text(&text, Path::new("the wing of washout init"), &sets)?.design;
    let wing = WingModel::of_design(design)?.solve(&progress.unseen())?;
    let observer = wing.observer()?;
    let readings = observer.profile().readings;
    let twist = readings
        .iter()
        .map(|reading| [1e3 * reading.r_m, reading.twist_rad.to_degrees()]);
    let tip = readings.last().and_then(|tip| observer.leading_edge(tip.r_m));
    let force: Vector3<f64> = wing.solution.air_force_n.iter().map(|f| Vector3::from(*f)).sum();
    let across = Flow::from_design(wing.model.design()).map_or(Vector3::z(), |flow| flow.lift_direction());
    Ok(Read {
        twist: twist.collect(),
        tip_deflection_mm: tip.map_or(0.0, |tip| 1e3 * tip.deflection_m),
        lift_mn: 1e3 * force.dot(&across),
    })
}

/// The example without its table of flapping, for one of a steady stream in its place.
fn without_flapping(text: &str) -> String {
    let mut is_flapping = false;
    let kept = text.lines().filter(|line| {
        if line.starts_with('[') {
            is_flapping = *line == "[flapping]";
        }
        !is_flapping
    });
    kept.collect::<Vec<_>>().join("\n")
}
