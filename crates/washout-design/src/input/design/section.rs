//! Cross-sections of rods and spars.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::zero;
use crate::input::quantity::Quantity;

/// Cross-section of a rod or spar.
// A wing has a dozen of these at most: plain fields are worth more than small variants.
#[allow(clippy::large_enum_variant)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", tag = "shape")]
pub enum Section {
    /// Full circle.
    Round {
        /// The outer diameter.
        #[schemars(extend("minimum" = 0.001, "maximum" = 1000.0, "examples" = [1.0]))]
        diameter_mm: Quantity,
    },
    /// Half of a circle, split along a diameter.
    HalfRound {
        /// The diameter of the rod that was split.
        #[schemars(extend("minimum" = 0.001, "maximum" = 1000.0, "examples" = [1.0]))]
        diameter_mm: Quantity,
        /// How the flat lies.
        #[serde(default)]
        #[schemars(extend("examples" = ["in-plane"]))]
        flat: Flat,
    },
    /// Circular tube.
    Tube {
        /// The outer diameter.
        #[schemars(extend("minimum" = 0.001, "maximum" = 1000.0, "examples" = [1.0]))]
        outer_diameter_mm: Quantity,
        /// The inner diameter, smaller than the outer one.
        #[schemars(extend("minimum" = 0.0, "maximum" = 1000.0, "examples" = [0.6]))]
        inner_diameter_mm: Quantity,
    },
    /// Solid rectangle.
    Rectangle {
        /// The width in the plane of the wing.
        #[schemars(extend("minimum" = 0.001, "maximum" = 10000.0, "examples" = [1.0]))]
        width_mm: Quantity,
        /// The thickness across the plane of the wing.
        #[schemars(extend("minimum" = 0.001, "maximum" = 1000.0, "examples" = [0.086]))]
        thickness_mm: Quantity,
    },
    /// Thin rectangular strip of plies; first ply at the bottom (−z).
    Laminate {
        /// The width in the plane of the wing.
        #[schemars(extend("minimum" = 0.001, "maximum" = 10000.0, "examples" = [1.0]))]
        width_mm: Quantity,
        /// The plies from bottom to top.
        #[schemars(extend("examples" = [[{"material": "m60j-prepreg", "thickness_mm": 0.04}]]))]
        plies: Vec<Ply>,
    },
    /// Stiffnesses as given.
    Given {
        /// The axial stiffness EA.
        #[schemars(extend("minimum" = 1e-9, "maximum" = 1e15, "examples" = [105000.0]))]
        ea_n: Quantity,
        /// The torsional stiffness GJ.
        #[schemars(extend("minimum" = 1e-15, "maximum" = 1e12, "examples" = [3.9e-4]))]
        gj_n_m2: Quantity,
        /// The bending stiffness out of the plane of the wing.
        #[schemars(extend("minimum" = 1e-15, "maximum" = 1e12, "examples" = [6.6e-3]))]
        ei_flap_n_m2: Quantity,
        /// The bending stiffness in the plane of the wing.
        #[schemars(extend("minimum" = 1e-15, "maximum" = 1e12, "examples" = [6.6e-3]))]
        ei_edge_n_m2: Quantity,
        /// The shear stiffness in the plane of the wing; none (rigid in shear) where absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("minimum" = 1e-9, "maximum" = 1e15, "examples" = [2600.0]))]
        ga_edge_n: Option<Quantity>,
        /// The shear stiffness out of the plane of the wing; none (rigid in shear) where absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("minimum" = 1e-9, "maximum" = 1e15, "examples" = [2600.0]))]
        ga_flap_n: Option<Quantity>,
        /// The mass per length.
        #[serde(default = "zero")]
        #[schemars(extend("minimum" = 0.0, "maximum" = 1e6, "examples" = [1.2e-3]))]
        mass_kg_m: Quantity,
        /// The moment of inertia of the mass about the axis, per length; modes feel it.
        #[serde(default = "zero")]
        #[schemars(extend("minimum" = 0.0, "maximum" = 1e6, "examples" = [2e-5]))]
        polar_inertia_kg_m2_per_m: Quantity,
        /// The coupling terms of the 6×6 stiffness matrix.
        #[serde(default)]
        #[schemars(extend("examples" = [[{"between": ["twist", "bending-flap"], "value": 1e-5}]]))]
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
    #[schemars(extend("examples" = [["twist", "bending-flap"]]))]
    pub between: [SectionStrain; 2],
    /// The term: N for two force strains, N·m for force and curvature, N·m² for two curvatures.
    #[schemars(extend("minimum" = -1e15, "maximum" = 1e15, "examples" = [1e-5]))]
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
    /// The name of the ply's material, as in `[material.NAME]`.
    #[schemars(extend("examples" = ["m60j-prepreg"]))]
    pub material: String,
    /// The thickness of the ply.
    #[schemars(extend("minimum" = 0.0001, "maximum" = 100.0, "examples" = [0.04]))]
    pub thickness_mm: Quantity,
    /// The angle of the fibres from the length of the spar.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = -90.0, "maximum" = 90.0, "examples" = [0.0]))]
    pub angle_deg: Quantity,
}
