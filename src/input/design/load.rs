//! Bench loads and gravity.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::zero;
use crate::input::quantity::Quantity;

/// A bench load at one place of the wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BenchLoad {
    /// The place along the span.
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [70.0]))]
    pub at_mm: Quantity,
    /// The offset along the chord from the leading edge, positive toward the trailing edge; rigid arm.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = -100000.0, "maximum" = 100000.0, "examples" = [0.0]))]
    pub chord_offset_mm: Quantity,
    /// The offset across the wing plane, positive toward +z; rigid arm.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = -100000.0, "maximum" = 100000.0, "examples" = [0.0]))]
    pub normal_offset_mm: Quantity,
    /// The dead force along x, y, z of the wing frame.
    #[serde(default)]
    #[schemars(extend("minimum" = -1e6, "maximum" = 1e6, "examples" = [[0.0, 0.0, 0.01]]))]
    pub force_n: [f64; 3],
    /// The dead moment about x, y, z of the wing frame.
    #[serde(default)]
    #[schemars(extend("minimum" = -1e6, "maximum" = 1e6, "examples" = [[0.001, 0.0, 0.0]]))]
    pub moment_n_m: [f64; 3],
    /// The mass, which weighs under gravity and enters modes.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 10000.0, "examples" = [0.005]))]
    pub mass_kg: Quantity,
    /// The moments of inertia of the mass about its own centre, frame axes.
    #[serde(default)]
    #[schemars(extend("minimum" = 0.0, "maximum" = 1e6, "examples" = [[0.0, 0.0, 0.0]]))]
    pub inertia_kg_m2: [f64; 3],
}

/// Uniform acceleration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gravity {
    /// The acceleration vector in the wing frame (9.80665 m/s² in length on Earth).
    #[schemars(extend("minimum" = -1e5, "maximum" = 1e5, "examples" = [[0.0, 0.0, -9.80665]]))]
    pub acceleration_m_s2: [f64; 3],
}
