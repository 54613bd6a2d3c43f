//! How it is solved: kinematics, mesh density, coupling.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::quantity::Quantity;

/// Structural model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Structure {
    /// The kinematics.
    #[schemars(extend("examples" = ["large-rotation"]))]
    pub kinematics: Kinematics,
    /// The factor on the drilling stiffness of the film; results must not depend on it.
    #[schemars(extend("minimum" = 1e-6, "maximum" = 1e6, "examples" = [1.0]))]
    pub drilling_factor: f64,
    /// The factor on the flapwise bending stiffness of the rod, all its pieces; couplings grow with its square root.
    #[schemars(extend("minimum" = 0.01, "maximum" = 100.0, "examples" = [1.0]))]
    pub rod_bending_factor: Quantity,
    /// The factor on the torsional stiffness of the rod, all its pieces; couplings grow with its square root.
    #[schemars(extend("minimum" = 0.01, "maximum" = 100.0, "examples" = [1.0]))]
    pub rod_torsion_factor: Quantity,
    /// The number of load increments to start with; results do not depend on it.
    #[schemars(extend("minimum" = 1, "maximum" = 10000, "examples" = [1]))]
    pub load_increments: usize,
    /// How the stiffness matrix is factorized.
    #[schemars(extend("examples" = ["one-thread"]))]
    pub factorization: Factorization,
}

/// How the stiffness matrix is factorized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Factorization {
    /// By one thread: the same bit for bit everywhere.
    #[default]
    OneThread,
    /// By all threads: for a single large wing on many cores (on two it does not pay); the same to rounding only.
    Parallel,
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
    /// The number of elements across the mean chord at refinement 1.
    #[schemars(extend("minimum" = 2, "maximum" = 1000, "examples" = [12]))]
    pub chordwise: usize,
    /// The factor on the number of elements in both directions.
    #[schemars(extend("minimum" = 0.1, "maximum" = 100.0, "examples" = [1.0]))]
    pub refine: f64,
    /// The mesh file to use instead of the generator, relative to the design file.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["wing.msh"]))]
    pub file: Option<String>,
}

/// How air and structure meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Coupling {
    /// The way air and structure meet: Newton's method on both, or a fixed point with or without acceleration.
    #[schemars(extend("examples" = ["newton"]))]
    pub accelerator: Accelerator,
    /// The largest change of twist between two iterations at convergence.
    #[schemars(extend("minimum" = 1e-12, "maximum" = 1.0, "examples" = [1e-6]))]
    pub twist_tolerance_deg: f64,
    /// The coupled residual at convergence, relative to the air load.
    #[schemars(extend("minimum" = 1e-14, "maximum" = 0.01, "examples" = [1e-8]))]
    pub residual_tolerance: f64,
    /// The number of iterations (Newton steps, then of the fixed point) after which it gives up.
    #[schemars(extend("minimum" = 1, "maximum" = 100000, "examples" = [60]))]
    pub max_iterations: usize,
}

/// Way in which air and structure meet; results do not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Accelerator {
    /// Newton's method on air and structure together; with load increments, linear kinematics or where it does not
    /// settle, the fixed point with Anderson acceleration.
    #[default]
    Newton,
    /// Plain fixed point.
    None,
    /// Aitken's dynamic relaxation.
    Aitken,
    /// Anderson acceleration.
    Anderson,
}

impl Default for Structure {
    fn default() -> Self {
        Structure {
            kinematics: Kinematics::LargeRotation,
            drilling_factor: 1.0,
            rod_bending_factor: Quantity::Stated(1.0),
            rod_torsion_factor: Quantity::Stated(1.0),
            load_increments: 1,
            factorization: Factorization::OneThread,
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
            accelerator: Accelerator::Newton,
            twist_tolerance_deg: 1e-6,
            residual_tolerance: 1e-7,
            max_iterations: 60,
        }
    }
}
