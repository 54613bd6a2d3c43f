//! Video files: marks on both edges of a wing, clicked in frames of a video, and how the camera stood.
//!
//! As for designs, these types are the only statement of the format.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mod load;

mod marks;

pub use load::{LoadedVideo, VideoFrame, VideoStation};
pub use marks::{Click, Mark, Which};

/// Frames of a video and how they were taken. Unknown keys are refused.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Video {
    /// The version of the file format.
    #[schemars(extend("examples" = [1]))]
    pub format: u32,
    /// The name (letters, digits, `-`, `_`); it names the measurement file that is written.
    #[schemars(extend("examples" = ["my-wing"]))]
    pub name: String,
    /// The wing, and who filmed it when and with what, for the head of the measurement file.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(extend("examples" = ["my bench, 3 May, 1000 frames/s"]))]
    pub source: String,
    /// The file of the marks, relative to this one: CSV with the columns frame, r_mm, mark, x_px, y_px, and if wanted repeat, chord_mm.
    #[schemars(extend("examples" = ["my-wing-marks.csv"]))]
    pub marks: String,
    /// The frame that shows the wing untwisted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["rest"]))]
    pub rest: Option<String>,
    /// The standard deviation of a clicked coordinate; told from repeats where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.001, "maximum" = 1000.0, "examples" = [0.5]))]
    pub sigma_px: Option<f64>,
    /// The way the camera looks.
    pub view: View,
    /// The two reference points, if the frames show them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub references: Option<References>,
}

/// The way a camera looks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct View {
    /// The line along which the camera looks.
    #[schemars(extend("examples" = ["span"]))]
    pub along: Along,
    /// The direction in which washout turns the line from leading to trailing edge in the frame, for `span`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["counterclockwise"]))]
    pub washout: Option<Turn>,
    /// The standard deviation of the zero of the angle (the camera rolls between frames, or the references lie askew), for
    /// `span`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 45.0, "examples" = [0.3]))]
    pub zero_sigma_deg: Option<f64>,
    /// The angle of attack of the untwisted chord, for `stroke` and `flapping-axis`: the design's angle at the stop.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 90.0, "examples" = [45.0]))]
    pub root_angle_deg: Option<f64>,
    /// Its standard deviation, with that of the camera's own direction about the span axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 45.0, "examples" = [1.0]))]
    pub root_angle_sigma_deg: Option<f64>,
}

/// Line along which a camera looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Along {
    /// Along the span: the frame shows the chord at its angle.
    Span,
    /// Along the stroke, or the stream: the frame shows the chord times sin α.
    Stroke,
    /// Along the flapping axis, or across the stream: the frame shows the chord times cos α.
    FlappingAxis,
}

/// Sense of a turn as seen in the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Turn {
    /// As the hands of a clock.
    Clockwise,
    /// Against them.
    Counterclockwise,
}

/// Two points that do not move: in the frames the marks `reference_a` and `reference_b`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct References {
    /// The distance between them, which gives the scale where no frame shows the wing untwisted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.001, "maximum" = 100000.0, "examples" = [50.0]))]
    pub distance_mm: Option<f64>,
    /// The standard deviation of that distance, a difference of depth to the wing included.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 1000.0, "examples" = [0.1]))]
    pub sigma_mm: Option<f64>,
}
