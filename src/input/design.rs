//! The design of a wing, as its file states it: planform, flow, rod, spars, film, root, loads, numerics.
//!
//! Units are in the names (mm, deg, Hz at the border); the rooms that compute convert to SI once.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Quantity;

/// One wing design. Unknown keys are refused.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Design {
    /// Version of the file format; 1.
    pub format: u32,
    /// Name of the wing, used for the run folder.
    pub name: String,
    /// File with materials, relative to the design file; its tables are merged below `material`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub materials: Option<String>,
    /// Outline of the wing.
    pub planform: Planform,
    /// Flapping flow; exactly one of `flapping` and `steady` may stand, or neither for bench loads only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flapping: Option<Flapping>,
    /// Steady wind-tunnel flow.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steady: Option<Steady>,
    /// Air: density, coefficients, centre of pressure.
    #[serde(default)]
    pub air: Air,
    /// Leading-edge rod, segment by segment from the base outward.
    pub rod: Vec<RodSegment>,
    /// Spars from the leading to the trailing edge.
    #[serde(default)]
    pub spar: Vec<Spar>,
    /// The membrane or plate between them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub film: Option<Film>,
    /// How the wing is held.
    #[serde(default)]
    pub root: Root,
    /// Bench loads besides air.
    #[serde(default)]
    pub load: Vec<BenchLoad>,
    /// Uniform acceleration, if gravity acts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity: Option<Gravity>,
    /// Kinematics of the structure.
    #[serde(default)]
    pub structure: Structure,
    /// Mesh density.
    #[serde(default)]
    pub mesh: MeshSettings,
    /// Fixed point between air and structure.
    #[serde(default)]
    pub coupling: Coupling,
    /// Where and how twist is read.
    #[serde(default)]
    pub observation: Observation,
    /// The measurement that belongs to this wing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured: Option<Measured>,
    /// Materials by name.
    #[serde(default)]
    pub material: BTreeMap<String, Material>,
    /// Effects that are on: raw tables, bound to their cards by the `effects` room.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, BTreeMap<String, serde_json::Value>>")]
    pub effects: BTreeMap<String, toml::Table>,
}

/// Outline of the wing. Chord from a beta distribution, or from an outline of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Planform {
    /// Length R from the wing base to the tip.
    pub length_mm: Quantity,
    /// Mean chord; not needed with `outline`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean_chord_mm: Option<Quantity>,
    /// Non-dimensional radius of the second moment of area; not needed with `outline`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub r2_hat: Option<Quantity>,
    /// Non-dimensional radius of the first moment; Ellington's regression from `r2_hat` where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub r1_hat: Option<Quantity>,
    /// Points `[r_mm, chord_mm]`, r rising; joined by a monotone spline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outline: Option<Vec<[f64; 2]>>,
    /// Distance from the flapping axis to the wing base.
    #[serde(default = "zero")]
    pub root_offset_mm: Quantity,
    /// Inboard of this fraction of the length the chord is held (closes the base).
    #[serde(default = "base_closure")]
    pub base_closure: Quantity,
    /// The wing is cut at this fraction of the length (closes the tip).
    #[serde(default = "tip_cut")]
    pub tip_cut: Quantity,
}

/// Flapping about the stroke axis with the root pitch at its stop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flapping {
    /// Flapping frequency.
    pub frequency_hz: Quantity,
    /// Half of the peak-to-peak stroke angle.
    pub half_amplitude_deg: Quantity,
    /// Angle of attack of the root at the pitch stop.
    #[serde(default = "stop_angle")]
    pub stop_angle_deg: Quantity,
    /// Phase of the stroke; 0 is mid-stroke (largest speed), 90 the reversal.
    #[serde(default = "zero")]
    pub phase_deg: Quantity,
}

/// Steady stream.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Steady {
    /// Speed of the stream.
    pub speed_m_s: Quantity,
    /// Angle of attack of the root.
    pub root_angle_deg: Quantity,
    /// Sweep of the span axis, positive aft.
    #[serde(default = "zero")]
    pub sweep_deg: Quantity,
}

/// Air and its laws.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Air {
    /// Density.
    pub density_kg_m3: Quantity,
    /// Force coefficients.
    pub coefficients: Coefficients,
    /// Lift-curve slope for `thin-airfoil`, per radian.
    pub lift_slope_per_rad: Quantity,
    /// Table of coefficients for `table`: CSV with columns alpha_deg, cl, cd.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table: Option<String>,
    /// Law of the centre of pressure.
    pub centre_of_pressure: CentreOfPressure,
    /// Fraction of the chord for `fixed`.
    pub centre_of_pressure_fraction: Quantity,
    /// Number of strips along the span; 0: one per column of the mesh.
    pub strips: usize,
}

/// Force coefficients by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Coefficients {
    /// Dickinson, Lehmann & Sane 1999.
    Dickinson,
    /// Whitney & Wood 2010.
    WhitneyWood,
    /// Linear lift with a given slope, no drag.
    ThinAirfoil,
    /// Table from a file.
    Table,
}

/// Centre-of-pressure law by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CentreOfPressure {
    /// Dickson, Straw & Dickinson 2006.
    Dickson,
    /// Public code of the Purdue hummingbird robot.
    Purdue,
    /// A fixed fraction of the chord.
    Fixed,
}

/// One piece of the leading-edge rod.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RodSegment {
    /// Where the piece starts; the first one at 0.
    pub from_mm: Quantity,
    /// Where it ends.
    pub to_mm: Quantity,
    /// Name of its material; not needed with given stiffnesses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
    /// Cross-section.
    pub section: Section,
}

/// A spar from the leading edge to the trailing edge, straight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spar {
    /// Span position of its end at the leading edge.
    pub at_mm: Quantity,
    /// Span position of its end at the trailing edge; same as `at_mm` where absent (straight across).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trailing_edge_at_mm: Option<Quantity>,
    /// Name of its material; not needed with plies or given stiffnesses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
    /// Cross-section.
    pub section: Section,
}

/// Cross-section of a rod or spar.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", tag = "shape")]
pub enum Section {
    /// Full circle.
    Round {
        /// Outer diameter.
        diameter_mm: Quantity,
    },
    /// Half of a circle, split along a diameter.
    HalfRound {
        /// Diameter of the rod that was split.
        diameter_mm: Quantity,
        /// How the flat lies.
        #[serde(default)]
        flat: Flat,
    },
    /// Circular tube.
    Tube {
        /// Outer diameter.
        outer_diameter_mm: Quantity,
        /// Inner diameter.
        inner_diameter_mm: Quantity,
    },
    /// Solid rectangle.
    Rectangle {
        /// Width in the plane of the wing.
        width_mm: Quantity,
        /// Thickness across it.
        thickness_mm: Quantity,
    },
    /// Thin rectangular strip of plies; first ply at the bottom (−z).
    Laminate {
        /// Width in the plane of the wing.
        width_mm: Quantity,
        /// Plies from bottom to top.
        plies: Vec<Ply>,
    },
    /// Stiffnesses as given.
    Given {
        /// Axial stiffness EA.
        ea_n: Quantity,
        /// Torsional stiffness GJ.
        gj_n_m2: Quantity,
        /// Bending stiffness out of the plane of the wing.
        ei_flap_n_m2: Quantity,
        /// Bending stiffness in the plane of the wing.
        ei_edge_n_m2: Quantity,
        /// Shear stiffness in the plane; none (rigid in shear) where absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ga_edge_n: Option<Quantity>,
        /// Shear stiffness out of the plane; none (rigid in shear) where absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ga_flap_n: Option<Quantity>,
        /// Mass per length.
        #[serde(default = "zero")]
        mass_kg_m: Quantity,
        /// Coupling terms of the 6×6 matrix.
        #[serde(default)]
        coupling: Vec<CouplingTerm>,
    },
}

/// How the flat of a half-round lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Flat {
    /// Flat in the plane of the wing: the flapwise second moment is the one parallel to the flat.
    #[default]
    InPlane,
    /// Flat across the plane of the wing.
    Across,
}

/// One off-diagonal term of a section's stiffness matrix.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CouplingTerm {
    /// The two strains that are coupled.
    pub between: [SectionStrain; 2],
    /// The term: N for two force strains, N·m for force and curvature, N·m² for two curvatures.
    pub value: Quantity,
}

/// The six strains of a beam section.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SectionStrain {
    /// Axial strain.
    Axial,
    /// Shear in the plane of the wing.
    ShearEdge,
    /// Shear out of it.
    ShearFlap,
    /// Twist rate.
    Twist,
    /// Curvature of bending out of the plane of the wing.
    BendingFlap,
    /// Curvature of bending in the plane.
    BendingEdge,
}

/// One ply of a laminate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ply {
    /// Name of its material.
    pub material: String,
    /// Thickness.
    pub thickness_mm: Quantity,
    /// Angle of the fibres from the length of the spar.
    #[serde(default = "zero")]
    pub angle_deg: Quantity,
}

/// The membrane or plate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Film {
    /// Name of its material.
    pub material: String,
    /// Thickness.
    pub thickness_mm: Quantity,
    /// How it answers to compression.
    #[serde(default)]
    pub compression: FilmCompression,
    /// Residual share of the stiffness in compression, for `tension-field`.
    #[serde(default = "residual_compression")]
    pub residual_compression: Quantity,
    /// Isotropic tension before any load.
    #[serde(default = "zero")]
    pub pretension_n_per_m: Quantity,
}

/// How a film answers to compression.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FilmCompression {
    /// It wrinkles: relaxed tension field.
    #[default]
    TensionField,
    /// It carries compression like a plate.
    Carries,
}

/// How the wing is held at its base.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Root {
    /// The root chord of the film: free, or clamped along the whole root.
    pub chord: RootChord,
    /// Pitch stiffness of a flexure between rod and stop; rigid where absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_stiffness_n_m_per_rad: Option<Quantity>,
}

/// The root chord.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RootChord {
    /// Only the rod is held.
    #[default]
    Free,
    /// The whole root edge is held.
    Clamped,
}

/// A bench load at one place of the wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BenchLoad {
    /// Place along the span.
    pub at_mm: Quantity,
    /// Offset along the chord from the leading edge, positive toward the trailing edge; rigid arm.
    #[serde(default = "zero")]
    pub chord_offset_mm: Quantity,
    /// Offset across the wing plane, rigid arm.
    #[serde(default = "zero")]
    pub normal_offset_mm: Quantity,
    /// Dead force in the wing frame.
    #[serde(default)]
    pub force_n: [f64; 3],
    /// Dead moment in the wing frame.
    #[serde(default)]
    pub moment_n_m: [f64; 3],
    /// Mass: weighs under gravity, and enters modes.
    #[serde(default = "zero")]
    pub mass_kg: Quantity,
    /// Moments of inertia about its own centre, frame axes.
    #[serde(default)]
    pub inertia_kg_m2: [f64; 3],
}

/// Uniform acceleration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gravity {
    /// Acceleration vector in the wing frame (9.80665 m/s² in length on Earth).
    pub acceleration_m_s2: [f64; 3],
}

/// Structural model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Structure {
    /// Kinematics.
    pub kinematics: Kinematics,
    /// Factor on the drilling stiffness of the film; results must not depend on it.
    pub drilling_factor: f64,
    /// Number of load increments to start with; results do not depend on it.
    pub load_increments: usize,
}

/// Kinematics of the structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kinematics {
    /// Large rotations, small strains.
    #[default]
    LargeRotation,
    /// Everything linear about the undeformed wing.
    Linear,
}

/// Mesh density.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MeshSettings {
    /// Elements across the mean chord at refinement 1.
    pub chordwise: usize,
    /// Factor on the number of elements in both directions.
    pub refine: f64,
    /// Mesh file to use instead of the generator, relative to the design file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
}

/// Fixed point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Coupling {
    /// Acceleration of the fixed point.
    pub accelerator: Accelerator,
    /// Largest change of twist between two iterations.
    pub twist_tolerance_deg: f64,
    /// Coupled residual relative to the air load.
    pub residual_tolerance: f64,
    /// Iterations after which it gives up.
    pub max_iterations: usize,
}

/// Acceleration of the fixed point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Accelerator {
    /// Plain iteration.
    None,
    /// Aitken's dynamic relaxation.
    Aitken,
    /// Anderson acceleration.
    #[default]
    Anderson,
}

/// Where and how twist is read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Observation {
    /// Instrument.
    pub instrument: Instrument,
    /// Axis of the camera, for `camera`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub camera_axis: Option<CameraAxis>,
    /// Stations besides the spar ends.
    pub stations_mm: Vec<f64>,
    /// An angle is read only where the chord exceeds this share of the mean chord.
    pub smallest_chord: f64,
    /// "Tip" means this fraction of the length.
    pub tip_station: f64,
}

/// Instrument that reads twist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Instrument {
    /// Angle of the deformed chord line about the span axis.
    #[default]
    ChordRotation,
    /// Projected distance between the edges in a video frame.
    Camera,
}

/// Axis along which the camera looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CameraAxis {
    /// Along the flapping axis: d/d0 = cos α / cos α_root.
    FlappingAxis,
    /// Along the stroke: d/d0 = sin α / sin α_root.
    Stroke,
}

/// The measurement that belongs to a design.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// CSV file, relative to the design file.
    pub file: String,
    /// Name of the case in it.
    pub case: String,
}

/// Elastic material, isotropic or orthotropic in its plane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Young's modulus along the length or fibre.
    pub e_gpa: Quantity,
    /// Modulus across the fibre; isotropic where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub e2_gpa: Option<Quantity>,
    /// Shear modulus; E/(2(1+ν)) where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub g_gpa: Option<Quantity>,
    /// Poisson's ratio.
    #[serde(default = "zero")]
    pub poisson: Quantity,
    /// Density.
    pub density_kg_m3: Quantity,
    /// Stress at which it yields or breaks, for margins.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength_mpa: Option<Quantity>,
    /// Where the numbers come from.
    #[serde(default)]
    pub source: String,
}

fn zero() -> Quantity {
    Quantity::Stated(0.0)
}
fn base_closure() -> Quantity {
    Quantity::Stated(0.02)
}
fn tip_cut() -> Quantity {
    Quantity::Stated(0.99)
}
fn stop_angle() -> Quantity {
    Quantity::Stated(45.0)
}
fn residual_compression() -> Quantity {
    Quantity::Stated(1e-4)
}

impl Default for Air {
    fn default() -> Self {
        Air {
            density_kg_m3: Quantity::Stated(1.20),
            coefficients: Coefficients::Dickinson,
            lift_slope_per_rad: Quantity::Stated(std::f64::consts::TAU),
            table: None,
            centre_of_pressure: CentreOfPressure::Dickson,
            centre_of_pressure_fraction: Quantity::Stated(0.25),
            strips: 0,
        }
    }
}

impl Default for Root {
    fn default() -> Self {
        Root {
            chord: RootChord::Free,
            pitch_stiffness_n_m_per_rad: None,
        }
    }
}

impl Default for Structure {
    fn default() -> Self {
        Structure {
            kinematics: Kinematics::LargeRotation,
            drilling_factor: 1.0,
            load_increments: 1,
        }
    }
}

impl Default for MeshSettings {
    fn default() -> Self {
        MeshSettings {
            chordwise: 12,
            refine: 1.0,
            file: None,
        }
    }
}

impl Default for Coupling {
    fn default() -> Self {
        Coupling {
            accelerator: Accelerator::Anderson,
            twist_tolerance_deg: 1e-6,
            residual_tolerance: 1e-8,
            max_iterations: 60,
        }
    }
}

impl Default for Observation {
    fn default() -> Self {
        Observation {
            instrument: Instrument::ChordRotation,
            camera_axis: None,
            stations_mm: Vec::new(),
            smallest_chord: 0.2,
            tip_station: 0.97,
        }
    }
}
