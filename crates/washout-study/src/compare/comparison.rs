//! What a wing against its measurement gives.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::design::{CameraAxis, Instrument};

use super::row::{ComparedRow, NotCompared};
use super::span::SpanComparison;
use super::stages::ModelledStages;

/// A measurement against a solved wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Comparison {
    /// Name of the wing.
    pub wing: String,
    /// Case of the measurement.
    pub case: String,
    /// Measurement file as the user named it.
    pub file: String,
    /// Instrument by which the model was read.
    pub instrument: Instrument,
    /// Axis of the camera, if it was one.
    pub camera_axis: Option<CameraAxis>,
    /// Every row that could be compared.
    pub rows: Vec<ComparedRow>,
    /// Every other row, and why not.
    pub not_compared: Vec<NotCompared>,
    /// Twist in degrees along the span, for each run that gives it.
    pub span: Vec<SpanComparison>,
    /// Stages of the modelled profile by its own fit; absent where it does not carry one.
    pub modelled_stages: Option<ModelledStages>,
    /// What a reader must know besides: other instruments, clipped intervals, assumed errors.
    pub notes: Vec<String>,
    /// Where the model fails, in words made from the numbers.
    pub verdict: String,
}
