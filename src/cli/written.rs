//! Where a verb writes, and what it wrote.

use std::path::{Path, PathBuf};

use crate::page::text::hanging;

/// The folder that a verb writes into.
pub fn target(output: Option<&PathBuf>, name: &str, verb: &str) -> PathBuf {
    output
        .cloned()
        .unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-{verb}")))
}

/// Which files were written, as the last line of a page.
pub fn listed(folder: &Path, files: &[String]) -> String {
    hanging(
        "",
        &format!("Files in {}: {}", folder.display(), files.join(" ")),
        2,
    )
}
