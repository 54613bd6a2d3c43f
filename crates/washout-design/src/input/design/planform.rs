//! The outline of the wing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::zero;
use crate::input::quantity::Quantity;

/// Outline of the wing: chord from a beta distribution, or from an outline of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Planform {
    /// The length R from the wing base to the tip.
    #[schemars(extend("minimum" = 1.0, "maximum" = 100000.0, "examples" = [70.0]))]
    pub length_mm: Quantity,
    /// The mean chord; not needed with `outline`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.1, "maximum" = 100000.0, "examples" = [20.5]))]
    pub mean_chord_mm: Option<Quantity>,
    /// The non-dimensional radius of the second moment of area; not needed with `outline`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.4, "maximum" = 0.8, "examples" = [0.54]))]
    pub r2_hat: Option<Quantity>,
    /// The non-dimensional radius of the first moment of area.
    ///
    /// Ellington's regression r̂₂ = 0.929 r̂₁^0.732 where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.3, "maximum" = 0.8, "examples" = [0.4766]))]
    pub r1_hat: Option<Quantity>,
    /// The points `[r_mm, chord_mm]` of the outline, r rising from 0 to the length; joined by a monotone spline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [[[0.0, 12.0], [40.0, 25.0], [70.0, 8.0]]]))]
    pub outline: Option<Vec<[f64; 2]>>,
    /// The distance from the flapping axis to the wing base.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [38.0]))]
    pub root_offset_mm: Quantity,
    /// The fraction of the length inboard of which the chord is held (closes the base).
    #[serde(default = "base_closure")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 0.5, "examples" = [0.02]))]
    pub base_closure: Quantity,
    /// The fraction of the length at which the wing is cut (closes the tip).
    ///
    /// Where absent, 1 with an `outline` that has a chord at the tip, else 0.99.
    #[serde(default = "tip_cut")]
    #[schemars(extend("minimum" = 0.5, "maximum" = 1.0, "examples" = [0.99]))]
    pub tip_cut: Quantity,
}

impl Planform {
    /// Whether an outline of points has a chord at the very tip, so that nothing need be cut there.
    pub fn has_tip_chord(&self) -> bool {
        let last = self.outline.as_ref().and_then(|points| points.last());
        last.is_some_and(|[r_mm, chord_mm]| *r_mm >= self.length_mm.value() && *chord_mm > 0.0)
    }
}

fn base_closure() -> Quantity {
    Quantity::Stated(0.02)
}

fn tip_cut() -> Quantity {
    Quantity::Stated(0.99)
}
