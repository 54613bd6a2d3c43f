//! `washout solve`: a design in; twist, forces, stresses and files out.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::Args;

use crate::compare::Reading;
use crate::coupling::Engineering;
use crate::export::ExportError;
use crate::export::collect::{Solved, summarize, write_files};
use crate::export::pictures::profile::twist;
use crate::export::report::page;
use crate::export::run::{RunFolder, read_summary};
use crate::export::summary::RunSummary;
use crate::export::warnings::of_stroke;
use crate::input::Design;
use crate::observation::TwistProfile;
use crate::progress::Progress;
use crate::study::uncertainty::FEWEST_SAMPLES;
use crate::study::{ProfileOutputs, StudyError, Uncertainty, UncertaintySettings, propagate};
use crate::wing::{DiscretizationError, Meshes, SolvedWing, WingError, WingModel};

use super::design_arguments::DesignArguments;
use super::stroke::{self, StrokeRun};
use super::written::listed;
use super::{Console, Failure};

/// Phases of the periodic motion that can be asked for.
const STROKE_PHASES: RangeInclusive<u16> = 2..=720;
/// Phases that stand still that can be asked for.
const STANDING_PHASES: RangeInclusive<u16> = 2..=99;

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
    pub asked: Asked,
    /// Write report.html besides: the wing in 3D, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
}

/// What is wanted besides the loaded shape.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct Asked {
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
        self.asked.check()?;
        let wing = self.design.wing(console)?;
        let output = self.output.clone();
        let target = output.unwrap_or_else(|| PathBuf::from("output").join(&wing.design().name));
        let mut folder = RunFolder::create(&target, "solve")?;
        let run = Run::new(&wing, &self.asked, progress)?;
        let summary = run.add_files(&mut folder, self.report)?;
        progress.check()?;
        let earlier = read_summary(&target).ok();
        let path = folder.commit()?;
        let mut after = listed(&path, &summary.files);
        if earlier.is_some_and(|earlier| earlier.design != summary.design) {
            after += "They replace an earlier run with other inputs; --output DIR keeps both\n";
        }
        after += &console.sketch(&twist(&summary));
        console.answer(&page(&summary, &[]), &after, &summary)
    }
}

impl Asked {
    /// Refuses before any solving what would be refused after it.
    fn check(&self) -> Result<(), Failure> {
        refuse_outside("--stroke", self.stroke, STROKE_PHASES)?;
        refuse_outside("--stroke-quasi-static", self.stroke_quasi_static, STANDING_PHASES)?;
        if self.stroke.is_some() && self.stroke_quasi_static.is_some() {
            return Err(Failure::Option {
                option: "--stroke-quasi-static",
                reason: "does not go together with --stroke; leave one out".to_string(),
            });
        }
        match self.uncertainty {
            Some(asked) if asked < FEWEST_SAMPLES => Err(Failure::Study(StudyError::TooFewSamples {
                asked,
                fewest: FEWEST_SAMPLES,
            })),
            _ => Ok(()),
        }
    }
}

fn refuse_outside(
    option: &'static str,
    phases: Option<u16>,
    range: RangeInclusive<u16>,
) -> Result<(), Failure> {
    match phases {
        Some(phases) if !range.contains(&phases) => Err(Failure::Option {
            option,
            reason: format!(
                "the number of phases must lie in {} … {}",
                range.start(),
                range.end()
            ),
        }),
        _ => Ok(()),
    }
}

/// A wing solved, with all that was asked for besides; nothing of it is written yet.
#[derive(Debug)]
pub struct Run {
    /// The wing.
    pub wing: SolvedWing,
    /// Profile, lift, and how far it is from the measurement.
    pub reading: Reading,
    mesh_error: DiscretizationError,
    uncertainty: Option<Uncertainty>,
    stroke: Option<StrokeRun>,
    engineering: Engineering,
}

impl Run {
    /// Solves.
    pub fn new(wing: &WingModel, asked: &Asked, progress: &Progress) -> Result<Run, Failure> {
        asked.check()?;
        progress.say(format_args!("solving {}", wing.design().name));
        let meshes = match asked.accuracy {
            None => Meshes::solve(wing, progress)?,
            Some(percent) => Meshes::until(wing, 0.01 * percent, progress)?,
        };
        let mesh_error = meshes.error()?;
        let wing = meshes.wing;
        let reading = Reading::of(&wing, &BTreeMap::new())?;
        let uncertainty = asked
            .uncertainty
            .map(|samples| band((&wing, meshes.coarser.as_ref().ok()), &reading, samples, progress));
        let uncertainty = uncertainty.transpose()?;
        let moving = asked
            .stroke
            .map(|phases| stroke::periodic(&wing, phases, progress));
        let standing = asked
            .stroke_quasi_static
            .map(|phases| stroke::quasi_static(&wing, phases, progress));
        let stroke = moving.or(standing).transpose()?;
        let engineering = wing.engineering(progress)?;
        Ok(Run {
            wing,
            reading,
            mesh_error,
            uncertainty,
            stroke,
            engineering,
        })
    }

    /// Its summary, as `summary.json` has it, but with no files.
    pub fn summary(&self) -> RunSummary {
        let mut summary = summarize(&self.solved());
        if let Some(stroke) = &self.stroke {
            summary.warnings.extend(of_stroke(&stroke.summary));
            summary.stroke = Some(stroke.summary.clone());
        }
        summary
    }

    /// Adds all its files to a folder and gives the summary among them; `with_report`: the report too.
    pub fn add_files(&self, folder: &mut RunFolder, with_report: bool) -> Result<RunSummary, ExportError> {
        let mut summary = self.summary();
        if let Some(stroke) = &self.stroke {
            stroke.add_files(folder)?;
        }
        write_files(folder, &self.solved(), &mut summary, with_report)?;
        Ok(summary)
    }

    fn solved(&self) -> Solved<'_> {
        Solved {
            wing: &self.wing,
            reading: &self.reading,
            mesh_error: &self.mesh_error,
            uncertainty: self.uncertainty.as_ref(),
            engineering: &self.engineering,
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

fn band(
    (wing, coarser): (&SolvedWing, Option<&SolvedWing>),
    reading: &Reading,
    samples: usize,
    progress: &Progress,
) -> Result<Uncertainty, Failure> {
    let outputs = ProfileOutputs::new(&reading.profile, &stretches_mm(reading));
    let unseen = progress.unseen();
    let evaluate = |design: &Design| -> Result<Vec<f64>, String> {
        outputs.read(&profile_of(wing, design, &unseen).map_err(|error| error.to_string())?)
    };
    let settings = UncertaintySettings {
        samples,
        ..UncertaintySettings::default()
    };
    let design = wing.model.design();
    let found = propagate(design, &outputs.outputs, settings, progress, evaluate);
    let mut found = found.map_err(Failure::Study)?;
    // a station that the coarser mesh does not read says nothing of the finer one
    let on_coarser = coarser.and_then(|coarser| outputs.read(&coarser.profile().ok()?).ok());
    for (output, other) in found.outputs.iter_mut().zip(on_coarser.into_iter().flatten()) {
        output.mesh_error = Some((output.nominal - other).abs());
    }
    Ok(found)
}

/// Stretches of the measured rates; those of the fitted stages where none was measured.
fn stretches_mm(reading: &Reading) -> Vec<[f64; 2]> {
    let measured = reading.measured.iter().flat_map(|comparison| &comparison.rows);
    let measured: Vec<[f64; 2]> = measured
        .filter_map(|row| Some([row.r_mm?, row.r_to_mm?]))
        .collect();
    if !measured.is_empty() {
        return measured;
    }
    let fitted = reading.stages.iter().flat_map(|fit| &fit.stages);
    fitted.map(|stage| [stage.from_mm, stage.to_mm]).collect()
}

/// The profile of another design, solved from a wing nearby.
fn profile_of(near: &SolvedWing, design: &Design, progress: &Progress) -> Result<TwistProfile, WingError> {
    let wing = near.model.with_design(design.clone())?;
    wing.solve_from(&near.solution, progress)?.profile()
}
