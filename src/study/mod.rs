//! Predictions of whole studies; uncertainty of assumed inputs.
