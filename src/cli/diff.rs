//! `washout diff`: two runs side by side.

use std::path::PathBuf;

use clap::Args;

use crate::export::difference::difference;
use crate::export::run::read_summary;

use super::{Console, Failure};

/// Arguments of `washout diff`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout solve designs/twist-v2.toml --output output/v2
  washout solve designs/twist-v2.toml --set flapping.frequency_hz=25 \\
    --output output/v2-25hz
  washout diff output/v2 output/v2-25hz")]
pub struct Diff {
    /// Folder of the first run
    pub first: PathBuf,
    /// Folder of the second run
    pub second: PathBuf,
}

impl Diff {
    /// Reads both runs and prints what differs.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let runs = [read_summary(&self.first)?, read_summary(&self.second)?];
        let difference = difference(&runs[0], &runs[1])?;
        console.result(&difference.page(), &difference)
    }
}
