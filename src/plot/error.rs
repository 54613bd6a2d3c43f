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
    /// The drawing library refused.
    #[error("a picture cannot be drawn: {reason}")]
    Drawing {
        /// What it said.
        reason: String,
    },
}
