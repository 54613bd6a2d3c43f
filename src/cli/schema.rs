//! `washout schema`: the JSON schema of a file or of an output, generated from the types.

use std::path::{Path, PathBuf};

use clap::{Args, Command};

use crate::export::ExportError;
use crate::export::file::write_page;
use crate::export::studies::studies_page;

use super::documents::Output;
use super::reference::reference_pages;
use super::{Console, Failure};

/// Arguments of `washout schema`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # of design files, for editors
  washout schema > design.schema.json
  # of `washout solve --json` and summary.json
  washout schema --output
  # of study files
  washout schema --study
  # of video files
  washout schema --video
  # of `washout diff --json`
  washout schema --output diff")]
pub struct Schema {
    /// Of the JSON document that a verb prints, instead of design files
    #[arg(long, value_name = "VERB", num_args = 0..=1, default_missing_value = "solve")]
    pub output: Option<Output>,
    /// Of study files, instead of design files
    #[arg(long, conflicts_with = "output")]
    pub study: bool,
    /// Of video files for `washout measure`, instead of design files
    #[arg(long, conflicts_with_all = ["output", "study"])]
    pub video: bool,
    /// Write the page of documentation on study files
    #[arg(long, value_name = "FILE", requires = "study")]
    pub page: Option<PathBuf>,
    /// Write the reference pages of the documentation into this folder: design, measurement, video, outputs, commands
    #[arg(long, value_name = "DIR", conflicts_with_all = ["output", "study", "video"])]
    pub pages: Option<PathBuf>,
}

impl Schema {
    /// Prints the schema; the reference pages are those of the whole command line.
    pub fn run(&self, whole: Command, console: &Console) -> Result<(), Failure> {
        if let Some(path) = &self.page {
            write_page(path, &studies_page())?;
        }
        if let Some(folder) = &self.pages {
            return self.write_pages(folder, whole, console);
        }
        let schema = match self.output {
            None if self.study => crate::input::schema::study_schema(),
            None if self.video => crate::input::schema::video_schema(),
            None => crate::input::schema::design_schema(),
            Some(output) => output.schema(),
        };
        console.document(&schema)
    }

    fn write_pages(&self, folder: &Path, whole: Command, console: &Console) -> Result<(), Failure> {
        std::fs::create_dir_all(folder).map_err(ExportError::file("create", folder))?;
        let mut written = Vec::new();
        for (name, page) in reference_pages(whole) {
            let path = folder.join(name);
            write_page(&path, &page)?;
            written.push(path.display().to_string());
        }
        console.names(&(written.join("\n") + "\n"), &written)
    }
}
