//! The design of a wing, as its file states it: planform, flow, rod, spars, film, root, loads, numerics.
//!
//! Units are in the names (mm, deg, Hz at the border); the rooms that compute convert to SI once.
//! These types are the only statement of the file format: allowed keys, ranges, examples and the words of
//! error messages are read from their schema (`minimum`, `maximum`, `examples`, doc comments).
//! The first sentence of each doc comment must read on after "Give ".

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mod flow;

mod layout;

mod load;

mod material;

mod numerics;

mod observation;

mod planform;

mod section;

/// The commented design that `washout init` starts from, with `NAME` where its name stands.
pub const INIT: &str = include_str!("init.toml");

pub use flow::{Air, CentreOfPressure, Coefficients, Flapping, Steady};
pub use layout::{Film, FilmCompression, Ribs, RodSegment, Root, RootChord, Spar};
pub use load::{BenchLoad, Gravity};
pub use material::Material;
pub use numerics::{Accelerator, Coupling, Factorization, Kinematics, MeshSettings, Structure};
pub use observation::{CameraAxis, Instrument, Measured, Observation};
pub use planform::Planform;
pub use section::{CouplingTerm, Flat, Ply, Section, SectionStrain};

/// One wing design. Unknown keys are refused.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Design {
    /// The version of the file format.
    #[schemars(extend("examples" = [1]))]
    pub format: u32,
    /// The name of the wing (letters, digits, `-`, `_`); it names the run folder.
    #[schemars(extend("examples" = ["my-wing"]))]
    pub name: String,
    /// The file with materials, relative to the design file; its tables join those under `material`.
    ///
    /// Where both define a name, the design's own table counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["materials.toml"]))]
    pub materials: Option<String>,
    /// The outline of the wing.
    pub planform: Planform,
    /// The flapping motion; `flapping` or `steady` may stand, or neither for bench loads only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flapping: Option<Flapping>,
    /// The steady wind-tunnel stream.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steady: Option<Steady>,
    /// The air: density, coefficients, centre of pressure.
    #[serde(default)]
    pub air: Air,
    /// The leading-edge rod, one `[[rod]]` table per segment from the base outward.
    pub rod: Vec<RodSegment>,
    /// The spars from the leading to the trailing edge, one `[[spar]]` table each.
    #[serde(default)]
    pub spar: Vec<Spar>,
    /// The stiff ribs of a wing without film, which hang its edges on the rod.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ribs: Option<Ribs>,
    /// The membrane or plate between rod and spars.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub film: Option<Film>,
    /// How the wing is held at its base.
    #[serde(default)]
    pub root: Root,
    /// The bench loads besides air, one `[[load]]` table each.
    #[serde(default)]
    pub load: Vec<BenchLoad>,
    /// The uniform acceleration, if gravity acts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity: Option<Gravity>,
    /// The structural model.
    #[serde(default)]
    pub structure: Structure,
    /// The mesh density.
    #[serde(default)]
    pub mesh: MeshSettings,
    /// The settings of the iteration between air and structure.
    #[serde(default)]
    pub coupling: Coupling,
    /// Where and how twist is read.
    #[serde(default)]
    pub observation: Observation,
    /// The measurement that belongs to this wing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured: Option<Measured>,
    /// The materials by name, one `[material.NAME]` table each.
    #[serde(default)]
    pub material: BTreeMap<String, Material>,
    /// The choices (words, not numbers) that are assumed, so that every output can say so.
    #[serde(default)]
    pub assumed_choice: Vec<AssumedChoice>,
    /// The effects that are on, one `[effects.NAME]` table each.
    ///
    /// The tables stay raw here; the `effects` room binds them to their cards.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, BTreeMap<String, serde_json::Value>>")]
    pub effects: BTreeMap<String, toml::Table>,
}

/// A choice among words that is assumed: its key, and why.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AssumedChoice {
    /// The dotted key whose value is assumed.
    #[schemars(extend("examples" = ["root.chord"]))]
    pub key: String,
    /// Why it is assumed, in a few words.
    #[schemars(extend("examples" = ["not stated in the paper"]))]
    pub why: String,
}

pub(in crate::input) fn zero() -> super::quantity::Quantity {
    super::quantity::Quantity::Stated(0.0)
}
