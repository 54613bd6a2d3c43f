//! The state as the page reads it.

use serde::Serialize;

use super::effects::Strength;
use super::inputs::Input;
use super::ladder::ErrorStep;
use super::opened::Case;

/// What there is to be moved, and where it stands.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct State {
    /// `live`.
    pub kind: &'static str,
    /// Version of its form.
    pub format: u32,
    /// Name of the design or the study.
    pub name: String,
    /// `design` or `study`.
    pub of: &'static str,
    /// The file that was opened.
    pub file: String,
    /// Rises with every change.
    pub revision: u64,
    /// The case that is shown.
    pub case: usize,
    /// The cases.
    pub cases: Vec<Case>,
    /// Inputs that can be moved, in the order of their groups.
    pub inputs: Vec<Input>,
    /// Effects that can act.
    pub effects: Vec<Strength>,
    /// What undo takes back, in words.
    pub undo: Option<String>,
    /// What redo does again, in words.
    pub redo: Option<String>,
    /// The error falling, as far as it is known.
    pub ladder: Vec<ErrorStep>,
    /// Root mean square of the stated standard deviations of twist, deg: the floor that the error can fall to.
    pub noise_deg: Option<f64>,
    /// Whether anything was measured.
    pub measured: bool,
    /// Whether something was changed since it was opened or saved.
    pub dirty: bool,
    /// How it would be saved.
    pub save: Saving,
}

/// How it would be saved.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Saving {
    /// The commands that do the same.
    pub commands: Vec<String>,
}
