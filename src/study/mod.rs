//! Predictions of whole studies; uncertainty of assumed inputs.

pub mod band;

pub mod error;

pub mod output;

pub mod quantile;

pub mod sample;

pub mod shares;

pub mod surrogate;

pub mod uncertainty;

pub use band::{OutputBand, SurrogateQuality};
pub use error::StudyError;
pub use output::{Output, ProfileOutputs};
pub use shares::Share;
pub use uncertainty::{Uncertainty, UncertaintySettings, propagate};
