//! Twist and other channels as an instrument sees them.
//!
//! Lengths in metres, angles in radians, frame and signs of [`crate::geometry`]; twist is positive as washout.

pub mod broken_line;

pub mod camera;

pub mod channel;

pub mod deflection;

pub mod edges;

pub mod error;

pub mod field;

pub mod motion;

pub mod observer;

pub mod picture;

pub mod profile;

pub mod rate;

mod split_search;

pub mod stages;

pub mod ruler_hint;

pub mod station;

pub mod video;

// for the tests of the crates above, too
#[doc(hidden)]
pub mod imposed;

pub use channel::{ChannelReading, read_channel};
pub use deflection::{LeadingEdgeReading, read_leading_edge};
pub use error::ObservationError;
pub use motion::{ModeReader, ModeReading, MotionShare};
pub use observer::{Observer, read_profile, twist_at};
pub use picture::Picture;
pub use profile::{TwistProfile, TwistReading};
pub use rate::{MeanRate, mean_rate};
pub use ruler_hint::{RulerHint, ruler_hints};
pub use stages::{PointSource, Stage, StageFit, StageSettings, fit_stages};
pub use station::{Place, SkipReason, SkippedStation, Station};
pub use video::{VideoReading, VideoTwist, twist_from_video};
