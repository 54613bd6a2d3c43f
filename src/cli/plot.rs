//! `washout plot`: the pictures of a run for print.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::export::ExportError;
use crate::export::pictures::folder::{Picture, pictures};
use crate::export::run::RunFolder;
use crate::plot::Print;
use crate::program::MadeOf;

use super::{Console, Failure};

/// The document that lists the pictures.
pub const PLOT: &str = "plot.json";

/// Arguments of `washout plot`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # wing, twist, air (and stroke) as SVG and PNG
  washout plot output/twist-v2
  washout plot output/twist-v2 --only twist --to png --width-mm 85 --dpi 600
                                                           a column of a journal
  # what compare drew, as PNG
  washout plot output/paper-wings-compare --to png
  # which pictures there are
  washout plot output/three-rods-diagnosis --list

A run is the folder that solve, compare, diagnose, add, lift, pareto or another verb wrote. The letters of a PNG are Latin and Greek; those of an SVG are whatever its reader has.")]
pub struct Plot {
    /// Folder of a run
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Only this picture; can be given many times
    #[arg(long, value_name = "NAME")]
    pub only: Vec<String>,
    /// Kind of files; both where it is not given
    #[arg(long)]
    pub to: Option<Kind>,
    /// Width on paper, mm [default: as drawn, at 96 pixels to the inch]
    #[arg(long, value_name = "MM")]
    pub width_mm: Option<f64>,
    /// Pixels to the inch of a PNG
    #[arg(long, default_value_t = 300.0)]
    pub dpi: f64,
    /// Name the pictures, draw none
    #[arg(long)]
    pub list: bool,
    /// Folder to write [default: RUN-plots]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// Kinds of picture files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Lines and letters
    Svg,
    /// Pixels
    Png,
}

/// What `washout plot` prints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Plotted {
    /// Folder of the run.
    pub run: String,
    /// Names of its pictures.
    pub pictures: Vec<String>,
    /// Width on paper, mm; none if as drawn.
    pub width_mm: Option<f64>,
    /// Pixels to the inch of PNG.
    pub dpi: f64,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files written; none with `--list`.
    pub files: Vec<String>,
}

impl Plot {
    /// Draws.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let print = self.print()?;
        if !self.run.is_dir() {
            return Err(self.no_run(
                "no folder; give the folder that washout solve, compare, diagnose or another verb wrote",
            ));
        }
        let (found, files) = pictures(&self.run)?;
        let names: Vec<String> = found.iter().map(|picture| picture.name.clone()).collect();
        if names.is_empty() {
            return Err(self.no_run("a folder without pictures; give one that washout solve, compare, diagnose or another verb wrote"));
        }
        if let Some(unknown) = self.only.iter().find(|name| !names.contains(name)) {
            return Err(Failure::Option {
                option: "--only",
                reason: format!(
                    "names no picture of this run: {unknown}; there are {}",
                    names.join(", ")
                ),
            });
        }
        let mut plotted = Plotted {
            run: self.run.display().to_string(),
            pictures: names,
            width_mm: self.width_mm,
            dpi: self.dpi,
            made_of: MadeOf::files(&files),
            files: Vec::new(),
        };
        if self.list {
            return console.result(&(plotted.pictures.join("\n") + "\n"), &plotted);
        }
        let mut folder = RunFolder::listed_by(&self.target(), "plot", PLOT)?;
        for picture in found.iter().filter(|picture| self.wants(picture)) {
            console.progress().check()?;
            console.progress().say(format_args!("drawing {}", picture.name));
            if self.to != Some(Kind::Png) {
                let svg = print.svg(&picture.svg).map_err(ExportError::from)?;
                folder.add(&format!("{}.svg", picture.name), svg.as_bytes())?;
            }
            if self.to != Some(Kind::Svg) {
                folder.add(
                    &format!("{}.png", picture.name),
                    &print.png(&picture.svg).map_err(ExportError::from)?,
                )?;
            }
        }
        plotted.files = folder.listed();
        folder.add_summary(&plotted)?;
        console.progress().check()?;
        let written = folder.commit()?;
        console.result(&console.listed(&written, &plotted.files), &plotted)
    }

    fn wants(&self, picture: &Picture) -> bool {
        self.only.is_empty() || self.only.contains(&picture.name)
    }

    fn print(&self) -> Result<Print, Failure> {
        for (option, value, [low, high]) in [
            ("--width-mm", self.width_mm.unwrap_or(100.0), [10.0, 2000.0]),
            ("--dpi", self.dpi, [30.0, 2400.0]),
        ] {
            if !(low..=high).contains(&value) {
                return Err(Failure::Option {
                    option,
                    reason: format!("is {value}; give {low} to {high}"),
                });
            }
        }
        Ok(Print {
            width_mm: self.width_mm,
            dpi: self.dpi,
        })
    }

    /// The folder that the pictures go into: beside the run where none is named.
    fn target(&self) -> PathBuf {
        self.output.clone().unwrap_or_else(|| {
            let name = self.run.file_name().unwrap_or_default().to_string_lossy();
            self.run.with_file_name(format!("{name}-plots"))
        })
    }

    fn no_run(&self, reason: &str) -> Failure {
        Failure::NothingToShow {
            path: self.run.clone(),
            reason: reason.to_string(),
        }
    }
}
