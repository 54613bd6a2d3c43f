//! Why a picture cannot be drawn.

use thiserror::Error;

/// Why a picture cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PlotError {
    /// A number that has no place on an axis.
    #[error(
        "the picture '{panel}' has a number that is not finite; this is a fault of washout, please report it"
    )]
    NotFinite {
        /// Title of the panel.
        panel: String,
    },
    /// Rows of unequal length.
    #[error(
        "the heat map '{panel}' has rows of unequal length; this is a fault of washout, please report it"
    )]
    Ragged {
        /// Title of the panel.
        panel: String,
    },
    /// More pixels than readers of pictures take.
    #[error(
        "a picture of {width_px:.0} by {height_px:.0} pixels is too large (at most {most_px:.0} along a side): ask for less width or \
         a lower resolution"
    )]
    TooLarge {
        /// Width, pixels.
        width_px: f64,
        /// Height, pixels.
        height_px: f64,
        /// Largest side, pixels.
        most_px: f64,
    },
    /// The drawing library refused.
    #[error("a picture cannot be drawn: {reason}")]
    Drawing {
        /// What it said.
        reason: String,
    },
}
