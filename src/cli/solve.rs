//! `washout solve`: a design in; twist, forces, stresses and files out.

use std::path::PathBuf;

use clap::Args;

use crate::export::pictures::profile::twist;
use crate::export::report::page;
use crate::export::run::{RunFolder, read_summary};
use crate::export::solved_run::SolvedRun;
use crate::solve::{Asked, OverStroke};

use super::design_arguments::DesignArguments;
use super::{Console, Failure};

/// Arguments of `washout solve`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout solve designs/twist-v2.toml
  washout solve designs/twist-v2.toml --set flapping.frequency_hz=25 \\
    --output output/v2-25hz
  # on a mesh that leaves no more than 1 % of the tip's twist
  washout solve designs/twist-v2.toml --accuracy 1%
  # a band instead of a line, and what it comes from
  washout solve designs/twist-v2.toml --uncertainty
  # the wing in motion over its stroke, for ParaView: stroke.pvd
  washout solve designs/twist-v2.toml --stroke 36
  # the same as if each phase stood still
  washout solve designs/twist-v2.toml --stroke-quasi-static 9
  # report.html besides: the wing in 3D, pictures, tables
  washout solve designs/twist-v2.toml --report
  washout solve designs/twist-v2.toml --json | jq .tip

Writes output/NAME/: wing.vtu, wing-rest.vtu and wing.pvd for ParaView, profile.csv, strips.csv, summary.json; with --stroke also stroke.pvd and its shapes, stroke.csv (twist, lift, what the stop carries), stroke-twist.csv. An earlier run there is replaced only when all of that is complete.")]
pub struct Solve {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Folder to write into [default: output/NAME]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// What is wanted besides the loaded shape
    #[command(flatten)]
    pub besides: Besides,
    /// Write report.html besides: the wing in 3D, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
}

/// What is wanted besides the loaded shape.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct Besides {
    /// Propagate the assumed ranges to a band by N solves, 16 or more [default N: 64]
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "64")]
    pub uncertainty: Option<usize>,
    /// Refine the mesh until it leaves no more than this share of the tip's twist, %; each mesh is twice as fine as the one before
    #[arg(long, value_name = "PERCENT", value_parser = percent)]
    pub accuracy: Option<f64>,
    /// The whole stroke besides, at N phases: its periodic motion, with the inertia of wing and air, with damping, and with
    /// pitch that flips between the stops
    #[arg(long, value_name = "N")]
    pub stroke: Option<u16>,
    /// N phases from mid-stroke to the reversal instead, each solved as if it stood still: no inertia, no flip
    #[arg(long, value_name = "N", conflicts_with = "stroke")]
    pub stroke_quasi_static: Option<u16>,
}

impl Solve {
    /// Solves and writes; nothing is written unless everything converged.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let progress = console.progress();
        let asked = self.besides.asked();
        asked.check()?;
        let wing = self.design.wing(console)?;
        let output = self.output.clone();
        let target = output.unwrap_or_else(|| PathBuf::from("output").join(&wing.design().name));
        let mut folder = RunFolder::create(&target, "solve")?;
        let run = SolvedRun::new::<Failure>(&wing, &asked, progress)?;
        let summary = run.add_files(&mut folder, self.report)?;
        progress.check()?;
        let earlier = read_summary(&target).ok();
        let path = folder.commit()?;
        let files = console.listed(&path, &summary.files);
        if earlier.is_some_and(|earlier| earlier.design != summary.design) {
            console.note(format_args!(
                "{} replaces an earlier run with other inputs; --output DIR keeps both",
                path.display()
            ));
        }
        let sketch = console.sketch(&twist(&summary));
        console.answer_with(&page(&summary, &[]), &files, &sketch, &summary)
    }
}

impl Besides {
    fn asked(&self) -> Asked {
        let periodic = self.stroke.map(OverStroke::Periodic);
        let standing = self.stroke_quasi_static.map(OverStroke::QuasiStatic);
        Asked {
            uncertainty: self.uncertainty,
            accuracy: self.accuracy.map(|percent| 0.01 * percent),
            stroke: periodic.or(standing),
        }
    }
}

/// A share in percent, with or without its sign.
fn percent(text: &str) -> Result<f64, String> {
    let value: Result<f64, _> = text.trim_end_matches('%').trim().parse();
    let is_sound = |percent: &f64| (0.01..=100.0).contains(percent);
    let value = value.ok().filter(is_sound);
    value.ok_or_else(|| "a percentage from 0.01 to 100 is expected, such as 1%".to_string())
}
