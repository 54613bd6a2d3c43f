//! The wing over its stroke: twist, forces and what the stop carries, phase by phase.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::coupling::instant::Instant;
use crate::coupling::solution::Solution;
use crate::input::design::Flapping;
use crate::lift::Forces;

use super::error::WingError;
use super::model::WingModel;

/// How the phases of a stroke were solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StrokeKind {
    /// As one periodic motion, with inertia and damping.
    Periodic,
    /// Each as if it stood still.
    QuasiStatic,
}

/// The wing over its stroke.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StrokeSummary {
    /// How it was solved.
    pub kind: StrokeKind,
    /// Periodic: evenly over the whole stroke; quasi-static: from mid-stroke toward the reversal.
    pub phases: Vec<PhaseRow>,
    /// Twist along the span at each of them.
    pub profile: Vec<StrokeTwist>,
    /// Mean over the stroke.
    pub mean: Option<Forces>,
    /// What the periodic motion was made of.
    pub periodic: Option<PeriodicSummary>,
}

/// One phase of the stroke.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PhaseRow {
    /// Phase; 0 is mid-stroke, 90 the reversal.
    pub phase_deg: f64,
    /// Twist of the tip, positive for washout in either half-stroke; absent where it cannot be read.
    pub tip_twist_deg: Option<f64>,
    /// What the stop carries about the rod's axis, positive as it pushes; while the rod flips, what drives it.
    pub stop_moment_mn_mm: Option<f64>,
    /// Where the rod is; absent where each phase was solved as if it stood still.
    pub moving: Option<MovingRow>,
    /// Forces at that phase.
    pub forces: Option<Forces>,
    /// Shape under load.
    pub file: String,
}

/// The rod at one phase of a periodic motion, in the frame of its half-stroke.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MovingRow {
    /// Time after mid-stroke.
    pub time_ms: f64,
    /// Sweep off mid-stroke.
    pub sweep_deg: f64,
    /// Pitch from upright; 90 less the angle of the root at the stop.
    pub pitch_deg: f64,
    /// Whether it is on its way between the stops.
    pub is_flipping: bool,
    /// Twist of the tip if the wing stood still under the load of this phase.
    pub standing_tip_twist_deg: Option<f64>,
}

/// Twist of one station at one phase.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StrokeTwist {
    /// Phase; 0 is mid-stroke.
    pub phase_deg: f64,
    /// Station.
    pub r_mm: f64,
    /// Twist as the design's instrument reads it; positive is washout of the half-stroke.
    pub twist_deg: f64,
    /// Rotation of the chord if the wing stood still under the load of this phase.
    pub standing_deg: Option<f64>,
    /// Rate of the rotation of the chord.
    pub rate_deg_s: Option<f64>,
}

/// What a periodic motion was made of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicSummary {
    /// Frequencies of the modes about the loaded shape, with the air that moves along.
    pub mode_hz: Vec<f64>,
    /// Damping of the structure over the critical one (assumed).
    pub damping_ratio: f64,
    /// Share of the stroke that each flip between the stops takes (assumed).
    pub flip_share: f64,
    /// Effects of the design without which the motion was found: they are made from it, or the motion has what they stand for.
    pub left_out: Vec<String>,
    /// Largest swing of the twist about that of standing still, over stations and phases.
    pub largest_swing_deg: f64,
    /// Stretches of a half-stroke, deg from mid-stroke, where the rod is taken to rest on its stop, but the stop would have to
    /// pull.
    pub released_deg: Vec<[f64; 2]>,
}

/// The shape at one phase, for whoever draws it.
#[derive(Debug)]
pub struct PhaseShape<'a> {
    /// The wing.
    pub model: &'a WingModel,
    /// The shape, in the frame of the rod.
    pub solution: &'a Solution,
    /// Where the rod is; none where each phase was solved as if it stood still.
    pub instant: Option<&'a Instant>,
}

/// The stroke of a design, or that it has none, in answer to `question`.
pub(super) fn flapping<'a>(wing: &'a WingModel, question: &'static str) -> Result<&'a Flapping, WingError> {
    let flapping = wing.design().flapping.as_ref();
    flapping.ok_or_else(|| WingError::Question {
        question,
        reason: "the design does not flap, so it has no stroke; give it a [flapping] table".to_string(),
    })
}
