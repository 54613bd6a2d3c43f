//! `summary.json`: everything about a run that is a number or a name, with units in the names.
//!
//! It holds no time, no host and no thread count, so that equal inputs give equal bytes.

use crate::wing::stroke::StrokeSummary;
use crate::wing::{DiscretizationError, OtherEquilibrium};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::compare::{Comparison, ModelledStages};
use crate::coupling::Engineering;
use crate::input::design::{Design, Section};
use crate::input::measurement::Bound;
use crate::lift::LiftReport;
use crate::observation::{Place, TwistReading};
use crate::program::MadeOf;
use crate::study::Uncertainty;

/// The result of one solve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RunSummary {
    /// Name of the wing.
    pub name: String,
    /// Path of the design file as it was given.
    pub design_file: String,
    /// The design with every default, material and `--set` resolved.
    pub design: Design,
    /// Inputs that are assumed, not known.
    pub assumed: Vec<AssumedInput>,
    /// Choices among words that are assumed.
    pub assumed_choices: Vec<AssumedChoice>,
    /// The wing as built.
    pub wing: WingSummary,
    /// The air it meets; absent without flow.
    pub flow: Option<FlowSummary>,
    /// The mesh.
    pub mesh: MeshSummary,
    /// What was solved, and how well the equations are met.
    pub solve: SolveSummary,
    /// Twist at the stations of the design.
    pub profile: Vec<ProfileRow>,
    /// The same with 50 places evenly from base to tip, where it can be read; the rows of `profile.csv`.
    #[serde(default)]
    pub along_span: Vec<ProfileRow>,
    /// Stations that were not read, and why.
    pub skipped: Vec<String>,
    /// Piecewise-linear stages of the profile; absent where the profile does not carry a fit.
    pub stages: Option<ModelledStages>,
    /// Measured minus modelled; absent where the design names no measurement.
    pub measured: Option<Comparison>,
    /// The tip.
    pub tip: TipSummary,
    /// Lift, drag and power; absent without flow.
    pub lift: Option<LiftReport>,
    /// What the mesh leaves of these.
    #[serde(default)]
    pub mesh_error: DiscretizationError,
    /// Another shape in which the wing rests under the same load: that of the usual options of the solver, where the design has others
    /// and they led elsewhere. `washout check` looks for more.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other_equilibrium: Option<OtherEquilibrium>,
    /// The wing over its stroke; absent unless asked for.
    pub stroke: Option<StrokeSummary>,
    /// What a builder wants to know besides the twist.
    pub engineering: Engineering,
    /// Band from the assumed ranges; absent unless asked for.
    pub uncertainty: Option<Uncertainty>,
    /// What the numbers in the cell arrays of the `.vtu` files mean.
    pub legend: CellLegend,
    /// Things that limit how far the numbers hold.
    pub warnings: Vec<String>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of this run, this one among them.
    pub files: Vec<String>,
}

/// An assumed input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AssumedInput {
    /// Dotted path in the design, unit in its name.
    pub key: String,
    /// Value that was used.
    pub value: f64,
    /// Lower and upper end of the range thought possible.
    pub range: [f64; 2],
    /// Why it is assumed.
    pub why: String,
}

/// An assumed choice.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AssumedChoice {
    /// Dotted path in the design.
    pub key: String,
    /// Word that was used.
    pub value: String,
    /// Why it is assumed.
    pub why: String,
}

/// The wing as built, closed at both ends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WingSummary {
    /// Length R from base to tip.
    pub length_mm: f64,
    /// Where the tip is cut.
    pub tip_mm: f64,
    /// Distance from the flapping axis to the base.
    pub root_offset_mm: f64,
    /// Mean chord, area over length.
    pub mean_chord_mm: f64,
    /// Area.
    pub area_mm2: f64,
    /// Non-dimensional radius of the first moment of area.
    pub r1_hat: f64,
    /// Non-dimensional radius of the second moment of area.
    pub r2_hat: f64,
}

/// The air that the wing meets.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum FlowSummary {
    /// Flapping, at one phase of the stroke.
    Flapping {
        /// Frequency.
        frequency_hz: f64,
        /// Half of the peak-to-peak stroke angle.
        half_amplitude_deg: f64,
        /// Phase; 0 is mid-stroke.
        phase_deg: f64,
        /// Angle of attack of the root at the stop.
        root_angle_deg: f64,
        /// Speed of the tip through the air at that phase.
        tip_speed_m_s: f64,
        /// Density.
        density_kg_m3: f64,
    },
    /// Steady stream.
    Steady {
        /// Speed.
        speed_m_s: f64,
        /// Angle of attack of the root.
        root_angle_deg: f64,
        /// Density.
        density_kg_m3: f64,
    },
}

/// The mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeshSummary {
    /// Nodes.
    pub nodes: usize,
    /// Membrane triangles.
    pub triangles: usize,
    /// Beam elements.
    pub beams: usize,
    /// Mesh file, if one was given.
    pub file: Option<String>,
}

/// What was solved, and how well the equations are met. Only converged solves are ever written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SolveSummary {
    /// Always `converged`.
    pub outcome: Outcome,
    /// Degrees of freedom.
    pub dof: usize,
    /// Updates of the air load: Newton steps on air and structure together, or fixed-point iterations.
    pub iterations: usize,
    /// Newton steps of the structure in all.
    pub newton_steps: usize,
    /// Coupled residual relative to the applied load; null if there is next to no load.
    pub residual: Option<f64>,
    /// Largest change of twist in the last iteration.
    pub twist_change_deg: f64,
    /// Negative pivots of the tangent (inertia count); 0: stable branch.
    pub negative_pivots: usize,
    /// Critical dynamic pressure of divergence over that of the design, estimated from the loaded shape; absent if the
    /// air's answer to twist does not drive it on.
    pub critical_pressure_ratio: Option<f64>,
    /// Force of the support on the wing, wing frame.
    pub reaction_force_mn: [f64; 3],
    /// Moment of the support about the wing base, wing frame; its first part is what the stop carries.
    pub reaction_moment_mn_mm: [f64; 3],
    /// Largest twist of a strip after each iteration.
    pub largest_twist_deg: Vec<f64>,
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// The equations are met within the tolerances.
    Converged,
}

/// Twist at one station.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ProfileRow {
    /// What stands there: `base`, `spar[0]`, `station`, `tip`.
    pub place: String,
    /// Place along the span.
    pub r_mm: f64,
    /// Chord there at rest.
    pub chord_mm: f64,
    /// Twist as the design's instrument reads it; positive is washout.
    pub twist_deg: f64,
    /// Error of the instrument; absent where it has none.
    pub sigma_deg: Option<f64>,
    /// Whether the instrument gives a value or only a bound.
    pub bound: Bound,
    /// Angle of attack of the chord; absent without flow.
    pub alpha_deg: Option<f64>,
    /// Deflection of the leading edge across the wing plane (+z).
    pub le_deflection_mm: f64,
    /// Sweep of the leading edge in the wing plane, toward the trailing edge (+y).
    pub le_sweep_mm: f64,
}

impl ProfileRow {
    /// A reading in millimetres and degrees.
    pub fn of(reading: &TwistReading) -> ProfileRow {
        ProfileRow {
            place: place_name(reading.place),
            r_mm: reading.r_m * 1e3,
            chord_mm: reading.chord_m * 1e3,
            twist_deg: reading.twist_rad.to_degrees(),
            sigma_deg: reading.sigma_rad.map(f64::to_degrees),
            bound: reading.bound,
            alpha_deg: reading.alpha_rad.map(f64::to_degrees),
            le_deflection_mm: reading.le_deflection_m * 1e3,
            le_sweep_mm: reading.le_sweep_m * 1e3,
        }
    }
}

/// What stands at a station, in one word.
pub(super) fn place_name(place: Place) -> String {
    match place {
        Place::Base => "base".to_string(),
        Place::SparEnd(index) => format!("spar[{index}]"),
        Place::OnRequest => "station".to_string(),
        Place::Tip => "tip".to_string(),
    }
}

/// The tip.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TipSummary {
    /// Place that "tip twist" means.
    pub r_mm: f64,
    /// Twist there; absent where it cannot be read.
    pub twist_deg: Option<f64>,
    /// Angle of attack there.
    pub alpha_deg: Option<f64>,
    /// Number of the outermost node of the leading edge in the `.vtu` files.
    pub node: usize,
    /// Displacement of that node from the unloaded shape, wing frame.
    pub displacement_mm: [f64; 3],
}

/// What the numbers in the cell arrays of the `.vtu` files mean.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CellLegend {
    /// Names of `part` 0, 1, 2.
    pub part: Vec<String>,
    /// Names of `material` 0, 1, …; -1 is none.
    pub material: Vec<String>,
    /// Sections of `section` 0, 1, …; -1 is none.
    pub section: Vec<Section>,
}
