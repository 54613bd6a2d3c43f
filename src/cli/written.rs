//! Where a verb writes, and what it wrote.

use std::path::{Path, PathBuf};

use crate::page::text::hanging;

/// The folder that a verb writes into.
pub fn target(output: Option<&PathBuf>, name: &str, verb: &str) -> PathBuf {
    output
        .cloned()
        .unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-{verb}")))
}

/// Files that are named; of more, how many they are.
const NAMED: usize = 7;

/// Which files were written, as the last line of a page.
pub fn listed(folder: &Path, files: &[String]) -> String {
    let folder = folder.display();
    let line = match files.len() {
        0..=NAMED => format!("Files in {folder}: {}", files.join(" ")),
        count => format!("{count} files in {folder}"),
    };
    hanging("", &line, 2)
}
