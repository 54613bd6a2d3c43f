//! What twist buys in lift, power and efficiency: the document of `washout lift`.

#[cfg(feature = "cli")]
pub mod page;

mod summary;

pub mod tables;

pub use summary::LiftAsked;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::lift::{
    Forces, InertialPower, StrokeMeans, departure_from_ellipse, mean_local_lift_to_drag, span_distribution,
};
use crate::program::MadeOf;
use crate::wing::Flown;
use crate::wing::lift_ratios::{Sensitivity, WingRatios};

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

impl WingLift {
    /// The row of a wing that flew.
    pub fn of(wing: &Flown, mean: &StrokeMeans, inertial: Option<InertialPower>) -> WingLift {
        let (flight, design) = (&wing.flight, &wing.model.loaded.design);
        let amplitude = design
            .flapping
            .as_ref()
            .map(|flapping| &flapping.half_amplitude_deg);
        let tip_m = flight.planform.tip_m();
        let positive = |power_w: f64| (power_w > 0.0).then(|| mean.lift_n / power_w);
        WingLift {
            name: wing.name.clone(),
            file: wing.file.display().to_string(),
            frequency_hz: flight.stroke.frequency_hz,
            half_amplitude_deg: flight.stroke.half_amplitude_rad.to_degrees(),
            half_amplitude_is_assumed: amplitude.is_some_and(|amplitude| amplitude.assumption().is_some()),
            stop_angle_deg: flight.stroke.stop_angle_rad.to_degrees(),
            tip_twist_deg: flight.twist.twist_rad(tip_m, 0.0).to_degrees(),
            effects: design.effects.keys().cloned().collect(),
            mean: Forces::of_means("mean over the stroke", mean),
            local_lift_to_drag: mean_local_lift_to_drag(mean),
            departure_from_ellipse: departure_from_ellipse(mean),
            inertial: inertial.map(|inertial| Inertial {
                inertia_g_mm2: inertial.inertia_kg_m2 * 1e9,
                largest_mw: inertial.largest_w * 1e3,
                mean_without_recovery_mw: inertial.mean_without_recovery_w * 1e3,
                lift_per_power_n_per_w: positive(inertial.mean_without_recovery_w),
            }),
        }
    }
}

impl SpanCurve {
    /// The curve of a wing that flew; the lift of the reference gives what is the ideal along the span.
    pub fn of(wing: &Flown, mean: &StrokeMeans, reference: &StrokeMeans) -> SpanCurve {
        let points = span_distribution(mean, reference);
        SpanCurve {
            wing: wing.name.clone(),
            r_mm: points.iter().map(|p| p.r_m * 1e3).collect(),
            twist_deg: mean.stations.iter().map(|s| s.twist_rad.to_degrees()).collect(),
            // N/m is mN/mm
            lift_mn_per_mm: points.iter().map(|p| p.lift_n_per_m).collect(),
            drag_mn_per_mm: points.iter().map(|p| p.drag_n_per_m).collect(),
            lift_to_drag: points.iter().map(|p| p.lift_to_drag).collect(),
        }
    }
}
