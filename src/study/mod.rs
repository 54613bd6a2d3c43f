//! Predictions of whole studies; uncertainty of assumed inputs.

pub mod error;

pub mod output;

pub mod quantile;

pub mod sample;

pub mod shares;

pub mod surrogate;

pub mod uncertainty;

pub use error::StudyError;
pub use output::{Output, ProfileOutputs};
pub use shares::Share;
pub use uncertainty::{OutputBand, Uncertainty, UncertaintySettings, propagate};
