//! What the wing is built of, and how it is held: rod, spars, film, root.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::section::Section;
use super::zero;
use crate::input::quantity::Quantity;

/// One piece of the leading-edge rod.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RodSegment {
    /// Where the piece starts, measured from the wing base; the first one at 0.
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [0.0]))]
    pub from_mm: Quantity,
    /// Where the piece ends, measured from the wing base.
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [70.0]))]
    pub to_mm: Quantity,
    /// The name of its material, as in `[material.NAME]`; not needed with plies or given stiffnesses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["carbon-rod"]))]
    pub material: Option<String>,
    /// The cross-section.
    #[schemars(extend("examples" = [{"shape": "round", "diameter_mm": 1.0}]))]
    pub section: Section,
}

/// A spar from the leading edge to the trailing edge, straight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spar {
    /// The span position of its end at the leading edge.
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [35.0]))]
    pub at_mm: Quantity,
    /// The span position of its end at the trailing edge; same as `at_mm` where absent (straight across).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [35.0]))]
    pub trailing_edge_at_mm: Option<Quantity>,
    /// The name of its material, as in `[material.NAME]`; not needed with plies or given stiffnesses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["m60j-prepreg"]))]
    pub material: Option<String>,
    /// The cross-section.
    #[schemars(extend("examples" = [{"shape": "rectangle", "width_mm": 1.0, "thickness_mm": 0.086}]))]
    pub section: Section,
}

/// Stiff ribs of a wing that is a beam: they hang leading and trailing edge on the rod, without film or spars.
///
/// They carry the air to the rod and the edges to the instrument; they weigh nothing and hardly bend.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ribs {
    /// The number of bays between ribs at `mesh.refine` 1; there is a rib at either end of the wing and rod piece.
    #[schemars(extend("minimum" = 1, "maximum" = 1000, "examples" = [16]))]
    pub bays: usize,
    /// The place of the rod behind the leading edge, as a fraction of the chord.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 0.95, "examples" = [0.5]))]
    pub rod_chord_fraction: Quantity,
    /// The stiffness of a rib over the largest torsional or flapwise stiffness of the rod; results must not depend on it.
    #[serde(default = "stiffness_ratio")]
    #[schemars(extend("minimum" = 100.0, "maximum" = 1e7, "examples" = [1e4]))]
    pub stiffness_ratio: f64,
}

/// The membrane or plate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Film {
    /// The name of its material, as in `[material.NAME]`.
    #[schemars(extend("examples" = ["kapton"]))]
    pub material: String,
    /// The thickness of the film.
    #[schemars(extend("minimum" = 0.0001, "maximum" = 100.0, "examples" = [0.006]))]
    pub thickness_mm: Quantity,
    /// How it answers to compression.
    #[serde(default)]
    #[schemars(extend("examples" = ["tension-field"]))]
    pub compression: FilmCompression,
    /// The residual share of the stiffness in compression, for `tension-field`.
    #[serde(default = "residual_compression")]
    #[schemars(extend("minimum" = 1e-8, "maximum" = 1.0, "examples" = [1e-4]))]
    pub residual_compression: Quantity,
    /// The isotropic tension before any load.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [0.0]))]
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
    /// How the root chord of the film is held.
    #[schemars(extend("examples" = ["free"]))]
    pub chord: RootChord,
    /// The pitch stiffness of a flexure between rod and stop; rigid where absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1e-12, "maximum" = 1e9, "examples" = [0.01]))]
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

fn stiffness_ratio() -> f64 {
    1e4
}

fn residual_compression() -> Quantity {
    Quantity::Stated(1e-4)
}

impl Default for Root {
    fn default() -> Self {
        Root {
            chord: RootChord::Free,
            pitch_stiffness_n_m_per_rad: None,
        }
    }
}
