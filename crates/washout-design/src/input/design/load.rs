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
    ///
    /// It counts from the leading edge also where `ribs.rod_chord_fraction` puts the rod behind it.
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
    /// The acceleration vector in the wing frame at no pitch (9.80665 m/s² in length on Earth).
    #[schemars(extend("minimum" = -1e5, "maximum" = 1e5, "examples" = [[0.0, 0.0, -9.80665]]))]
    pub acceleration_m_s2: [f64; 3],
    /// The nose-up pitch of the wing's root on its bench, by which the wing turns under the acceleration.
    ///
    /// At 90 deg an acceleration along -z points to the trailing edge. The air does not feel this angle: see
    /// `steady.root_angle_deg`.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = -180.0, "maximum" = 180.0, "examples" = [45.0]))]
    pub root_pitch_deg: Quantity,
}

impl Gravity {
    /// The acceleration in the wing frame, pitch included, m/s².
    pub fn in_wing_frame_m_s2(&self) -> [f64; 3] {
        let [x, y, z] = self.acceleration_m_s2;
        let (sin, cos) = self.root_pitch_deg.value().to_radians().sin_cos();
        [x, y * cos - z * sin, y * sin + z * cos]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nose_up_by_a_right_angle_gravity_pulls_to_the_trailing_edge() {
        let gravity = Gravity {
            acceleration_m_s2: [0.0, 0.0, -10.0],
            root_pitch_deg: Quantity::Stated(90.0),
        };
        let [x, y, z] = gravity.in_wing_frame_m_s2();
        assert!(
            x == 0.0 && (y - 10.0).abs() < 1e-12 && z.abs() < 1e-12,
            "{x} {y} {z}"
        );
    }
}
