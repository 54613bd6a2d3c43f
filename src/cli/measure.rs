//! `washout measure`: marks clicked in video frames become twist with its error, as a measurement file.

use std::path::PathBuf;

use clap::Args;

use crate::export::file::{refuse_other, write_over};
use crate::export::video::{MeasureReport, is_measured};
use crate::input::video::LoadedVideo;

use super::{Console, Failure};

/// Arguments of `washout measure`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout measure examples/video.toml --output my-wing.csv
  washout compare designs/twist-v2.toml --with my-wing.csv --case mid-stroke

The file says how the camera stood and names the CSV of marks; docs/from-video-to-twist.md has both, and what a single view can tell. All keys: washout schema --video")]
pub struct Measure {
    /// The video file
    pub video: PathBuf,
    /// Write the measurement here [default: NAME.csv in this folder]
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Replace an older measurement that was written by this verb
    #[arg(long)]
    pub force: bool,
}

impl Measure {
    /// Reads, converts, writes and shows.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let loaded = LoadedVideo::load(&self.video)?;
        let output = self.output.clone();
        let path = output.unwrap_or_else(|| PathBuf::from(format!("{}.csv", loaded.video.name)));
        let is_own = |bytes: &[u8]| self.force && is_measured(bytes);
        let what = match self.force {
            true => "a measurement that washout measure wrote",
            false => "",
        };
        refuse_other(&path, what, is_own)?;
        let report = MeasureReport::new(&loaded, path.display().to_string());
        write_over(&path, report.csv(&loaded).as_bytes(), what, is_own)?;
        console.result(&report.page(&loaded), &report)
    }
}
