//! Where and how twist is read, and the measurement that belongs to a wing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where and how twist is read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Observation {
    /// The instrument.
    #[schemars(extend("examples" = ["chord_rotation"]))]
    pub instrument: Instrument,
    /// The axis along which the camera looks, for `camera`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["flapping-axis"]))]
    pub camera_axis: Option<CameraAxis>,
    /// The error of a distance read from the video, for `camera`; 0.2 mm is assumed where absent.
    #[schemars(extend("minimum" = 0.0, "maximum" = 100.0, "examples" = [0.2]))]
    pub camera_error_mm: f64,
    /// The stations to read besides the spar ends.
    #[schemars(extend("minimum" = 0.0, "maximum" = 100000.0, "examples" = [[10.0, 30.0]]))]
    pub stations_mm: Vec<f64>,
    /// The share of the mean chord that the chord must exceed for an angle to be read.
    #[schemars(extend("minimum" = 0.0, "maximum" = 1.0, "examples" = [0.2]))]
    pub smallest_chord: f64,
    /// The nose-up pitch of the wing's root against the frame in which displacements are read (0: the wing frame).
    ///
    /// A ruler that stands on the bench, or in the stream, reads a pitched wing in its own frame. Twist is not touched, nor
    /// the leading edge in profiles, which stays in the wing frame.
    #[schemars(extend("minimum" = -180.0, "maximum" = 180.0, "examples" = [0.0]))]
    pub frame_pitch_deg: f64,
    /// The fraction of the length that "tip" means.
    #[schemars(extend("minimum" = 0.1, "maximum" = 1.0, "examples" = [0.97]))]
    pub tip_station: f64,
}

/// Instrument that reads twist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Instrument {
    /// Angle of the deformed chord line about the span axis.
    #[default]
    ChordRotation,
    /// Projected distance between the edges in a video frame.
    Camera,
}

impl Instrument {
    /// All of them.
    pub const ALL: [Instrument; 2] = [Instrument::ChordRotation, Instrument::Camera];

    /// The word for it in files.
    pub fn name(self) -> &'static str {
        match self {
            Instrument::ChordRotation => "chord_rotation",
            Instrument::Camera => "camera",
        }
    }

    /// What reads, in a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Instrument::ChordRotation => "the rotation of the chord",
            Instrument::Camera => "a camera",
        }
    }
}

/// Axis along which the camera looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CameraAxis {
    /// Along the flapping axis: d/d0 = cos α / cos α_root.
    FlappingAxis,
    /// Along the stroke: d/d0 = sin α / sin α_root.
    Stroke,
}

/// The measurement that belongs to a design.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// The CSV file of the measurement, relative to the design file.
    #[schemars(extend("examples" = ["../measurements/my-wing.csv"]))]
    pub file: String,
    /// The name of the case in that file.
    #[schemars(extend("examples" = ["my-wing"]))]
    pub case: String,
}

impl Default for Observation {
    fn default() -> Self {
        Observation {
            instrument: Instrument::ChordRotation,
            camera_axis: None,
            camera_error_mm: 0.2,
            stations_mm: Vec::new(),
            smallest_chord: 0.2,
            frame_pitch_deg: 0.0,
            tip_station: 0.97,
        }
    }
}
