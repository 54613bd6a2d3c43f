//! Materials.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::zero;
use crate::input::quantity::Quantity;

/// Elastic material, isotropic or orthotropic in its plane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// The modulus of elasticity along the length or fibre.
    #[schemars(extend("minimum" = 1e-6, "maximum" = 2000.0, "examples" = [2.5]))]
    pub e_gpa: Quantity,
    /// The modulus across the fibre; the material is isotropic where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1e-6, "maximum" = 2000.0, "examples" = [6.5]))]
    pub e2_gpa: Option<Quantity>,
    /// The shear modulus; E/(2(1+ν)) where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1e-6, "maximum" = 2000.0, "examples" = [4.0]))]
    pub g_gpa: Option<Quantity>,
    /// The Poisson ratio (strain across per strain along the fibre).
    #[serde(default = "zero")]
    #[schemars(extend("exclusiveMinimum" = -1.0, "exclusiveMaximum" = 0.5, "examples" = [0.34]))]
    pub poisson: Quantity,
    /// The density.
    #[schemars(extend("minimum" = 0.0, "maximum" = 25000.0, "examples" = [1420.0]))]
    pub density_kg_m3: Quantity,
    /// The stress at which it yields or breaks, for margins.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.001, "maximum" = 100000.0, "examples" = [69.0]))]
    pub strength_mpa: Option<Quantity>,
    /// Where the numbers come from.
    #[serde(default)]
    #[schemars(extend("examples" = ["maker's data sheet"]))]
    pub source: String,
}
