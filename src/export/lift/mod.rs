//! What twist buys in lift, power and efficiency: the document of `washout lift`.

pub mod page;

pub mod tables;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::lift::{Forces, Ratios};
use crate::origin::MadeOf;

/// What `washout lift` prints with `--json`; `summary.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LiftSummary {
    /// Where the twist comes from, in words.
    pub twist: String,
    /// The wings, in the order of the command line.
    pub wings: Vec<WingLift>,
    /// Name of the wing that ratios refer to.
    pub reference: String,
    /// The other wings over the reference.
    pub ratios: Vec<WingRatios>,
    /// Means over the stroke along the span.
    pub span: Vec<SpanCurve>,
    /// Forces over one half-stroke.
    pub stroke: Vec<StrokeCurve>,
    /// Means over the stroke for rising amplitudes; empty if not asked for.
    pub sweep: Vec<SweepCurve>,
    /// How the ratios move with what is not known; empty if not asked for.
    pub sensitivity: Vec<Sensitivity>,
    /// Things that limit what the numbers say.
    pub warnings: Vec<String>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// One wing, one of a pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WingLift {
    /// Name.
    pub name: String,
    /// Design or profile file.
    pub file: String,
    /// Flapping frequency.
    pub frequency_hz: f64,
    /// Half of the peak-to-peak stroke angle.
    pub half_amplitude_deg: f64,
    /// Whether that amplitude is assumed.
    pub half_amplitude_is_assumed: bool,
    /// Angle of attack of the root at its stop.
    pub stop_angle_deg: f64,
    /// Twist at mid-stroke at the tip, where the wing is cut.
    pub tip_twist_deg: f64,
    /// Effects that act on the air.
    pub effects: Vec<String>,
    /// Means over the stroke.
    pub mean: Forces,
    /// Mean along the span of the local ratio of mean lift to mean drag.
    pub local_lift_to_drag: f64,
    /// Root mean square departure of the lift distribution from an ellipse, over the mean lift per length.
    pub departure_from_ellipse: Option<f64>,
    /// Power against the wing's own inertia; absent unless asked for.
    pub inertial: Option<Inertial>,
}

/// Power against the wing's own inertia.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Inertial {
    /// Inertia of one wing about the stroke axis.
    pub inertia_g_mm2: f64,
    /// Largest inertial power of the stroke.
    pub largest_mw: f64,
    /// Mean power of a drive that gets nothing back while the wing slows down.
    pub mean_without_recovery_mw: f64,
    /// Lift per that power.
    pub lift_per_power_n_per_w: Option<f64>,
}

/// A wing over the reference under three conditions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WingRatios {
    /// Name of the wing.
    pub name: String,
    /// Its frequency over that of the reference.
    pub frequency_ratio: f64,
    /// Its product of frequency and amplitude over that of the reference.
    pub rate_ratio: f64,
    /// Each at its own frequency and amplitude.
    pub as_flown: RatioSet,
    /// At the same amplitude, each at its own frequency; with the twist kept.
    pub equal_amplitude: RatioSet,
    /// At the same product of frequency and amplitude; with the twist kept.
    pub equal_rate: RatioSet,
    /// What was measured, if anything was.
    pub measured: Option<MeasuredRatios>,
    /// What the measured lift says of the modelled one.
    pub effective: Option<Effective>,
}

/// Ratios to the reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RatioSet {
    /// Mean lift.
    pub lift: f64,
    /// Mean drag.
    pub drag: f64,
    /// Mean aerodynamic power.
    pub power: f64,
    /// Mean lift over mean drag.
    pub lift_to_drag: f64,
    /// Local lift over drag, mean along the span: the paper's efficiency.
    pub local_lift_to_drag: f64,
    /// Lift per power.
    pub lift_per_power: f64,
    /// Lift with the stroke changed until both take the same power.
    pub lift_at_equal_power: f64,
    /// Lift per power with the stroke changed until both lift the same.
    pub lift_per_power_at_equal_lift: f64,
}

/// Measured ratios to the reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredRatios {
    /// Mean lift, with its standard deviation.
    pub lift: Option<[f64; 2]>,
    /// Aerodynamic efficiency, with its standard deviation.
    pub efficiency: Option<[f64; 2]>,
    /// Effective lift coefficient as the source gives it, with its standard deviation.
    pub effective_lift: Option<[f64; 2]>,
}

/// What a measured lift says of the modelled one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Effective {
    /// Effective lift coefficient over that of the reference, each at its own frequency and both at the same amplitude.
    pub lift_at_equal_amplitude: f64,
    /// The same with the amplitudes of the designs.
    pub lift_as_flown: f64,
    /// Effective drag coefficient over that of the reference, if the measured efficiency is lift per power in that condition.
    pub drag_at_equal_amplitude: Option<f64>,
    /// Amplitude over that of the reference which the source's own effective coefficient implies.
    pub implied_amplitude_ratio: Option<f64>,
}

/// Means over the stroke along the span of one wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpanCurve {
    /// Name of the wing.
    pub wing: String,
    /// Span position.
    pub r_mm: Vec<f64>,
    /// Twist at mid-stroke.
    pub twist_deg: Vec<f64>,
    /// Mean lift.
    pub lift_mn_per_mm: Vec<f64>,
    /// Mean drag.
    pub drag_mn_per_mm: Vec<f64>,
    /// Local lift over drag, over the mean of the reference along its span.
    pub lift_to_drag: Vec<Option<f64>>,
}

/// Forces of one wing over one half-stroke.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StrokeCurve {
    /// Name of the wing.
    pub wing: String,
    /// Stroke phase, 0 at mid-stroke.
    pub phase_deg: Vec<f64>,
    /// Lift.
    pub lift_mn: Vec<f64>,
    /// Drag.
    pub drag_mn: Vec<f64>,
    /// Aerodynamic power.
    pub power_mw: Vec<f64>,
}

/// Means of one wing for rising amplitudes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SweepCurve {
    /// Name of the wing.
    pub wing: String,
    /// Half of the peak-to-peak stroke angle.
    pub half_amplitude_deg: Vec<f64>,
    /// Mean lift.
    pub lift_mn: Vec<f64>,
    /// Mean drag.
    pub drag_mn: Vec<f64>,
    /// Mean aerodynamic power.
    pub power_mw: Vec<f64>,
}

/// How the ratios of a wing move with one thing that is not known, changed alike on both wings, the twist kept.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Sensitivity {
    /// Name of the wing.
    pub wing: String,
    /// What is changed: a key of the design, or words.
    pub what: String,
    /// To what.
    pub value: String,
    /// Lift over drag over that of the reference.
    pub lift_to_drag: f64,
    /// Lift at equal frequency × amplitude.
    pub lift_at_equal_rate: f64,
    /// Lift per power at equal frequency × amplitude.
    pub lift_per_power_at_equal_rate: f64,
    /// Lift per power at the same amplitude, each at its own frequency.
    pub lift_per_power_at_equal_amplitude: f64,
}

impl From<&Ratios> for RatioSet {
    fn from(ratios: &Ratios) -> Self {
        RatioSet {
            lift: ratios.lift,
            drag: ratios.drag,
            power: ratios.power,
            lift_to_drag: ratios.lift_to_drag,
            local_lift_to_drag: ratios.local_lift_to_drag,
            lift_per_power: ratios.lift_per_power,
            lift_at_equal_power: ratios.lift_at_equal_power,
            lift_per_power_at_equal_lift: ratios.lift_per_power_at_equal_lift,
        }
    }
}

impl RatioSet {
    /// The ratios with their names.
    pub fn named(&self) -> [(&'static str, f64); 8] {
        [
            ("lift", self.lift),
            ("drag", self.drag),
            ("power", self.power),
            ("lift over drag", self.lift_to_drag),
            ("local lift over drag along the span", self.local_lift_to_drag),
            ("lift per power", self.lift_per_power),
            ("lift at equal power", self.lift_at_equal_power),
            ("lift per power at equal lift", self.lift_per_power_at_equal_lift),
        ]
    }
}
