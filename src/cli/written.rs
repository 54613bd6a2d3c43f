//! Where a verb writes.

use std::path::PathBuf;

/// The folder that a verb writes into.
pub fn target(output: Option<&PathBuf>, name: &str, verb: &str) -> PathBuf {
    output
        .cloned()
        .unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-{verb}")))
}
