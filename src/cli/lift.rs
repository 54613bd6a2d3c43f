//! `washout lift`: what a twist profile buys in lift, power and efficiency.

use std::path::PathBuf;

use clap::Args;

use crate::export::lift::{LiftAsked, LiftSummary};
use crate::export::pictures;
use crate::export::run::RunFolder;
use crate::wing::TwistSource;
use crate::wing::flights::{Amplitudes, Flights};

use super::finished::finished;
use super::twist_source::TwistFrom;
use super::{Console, Failure};

/// Arguments of `washout lift`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout lift designs/rigid.toml designs/twist-v1.toml designs/twist-v2.toml
  washout lift designs/rigid.toml designs/twist-v1.toml designs/twist-v2.toml \\
    --twist measured --sensitivity
  # a profile (r_mm, twist_deg) on the stroke of the first design
  washout lift designs/rigid.toml my-profile.csv
  # lift against power over the amplitude
  washout lift designs/twist-v2.toml --sweep 8
  washout lift designs/twist-v2.toml --twist ramp --with rotational-lift \\
    --inertial-power
  washout lift designs/*.toml --json | jq '.ratios[].equal_rate'

Ratios refer to the first wing, or to --reference. Writes output/lift/ (or output/NAME-lift/ for one wing): lift.csv, ratios.csv, span, stroke and sweep as pictures (SVG) with the numbers behind each (CSV), summary.json.")]
pub struct Lift {
    /// Designs, and twist profiles as CSV (r_mm, twist_deg, and phase_deg where there are several)
    #[arg(required = true, value_name = "DESIGN|PROFILE")]
    pub wings: Vec<PathBuf>,
    /// Wing that ratios refer to [default: the first]
    #[arg(long, value_name = "DESIGN|PROFILE")]
    pub reference: Option<PathBuf>,
    /// Design whose outline, air and stroke the profiles fly with [default: the first design]
    #[arg(long, value_name = "DESIGN")]
    pub on: Option<PathBuf>,
    /// Where the twist of the designs comes from
    #[arg(long, value_enum, default_value_t = TwistFrom(TwistSource::Phases))]
    pub twist: TwistFrom,
    /// Phases of the stroke that are solved, from mid-stroke to the reversal, for --twist phases
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u16).range(2..=99))]
    pub phases: u16,
    /// Flap at N amplitudes besides, from 70 % to 130 % of each wing's own, or over --amplitudes
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=99))]
    pub sweep: Option<u16>,
    /// Half amplitudes of the sweep, deg
    #[arg(long, value_name = "FROM,TO", value_delimiter = ',', requires = "sweep")]
    pub amplitudes: Option<Vec<f64>>,
    /// Add an effect with strength 1, e.g. rotational-lift or added-mass; can be given many times
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Power against the wing's own inertia besides
    #[arg(long)]
    pub inertial_power: bool,
    /// How the ratios move with what is not known, the twist kept
    #[arg(long)]
    pub sensitivity: bool,
    /// Set a key of every design, e.g. flapping.half_amplitude_deg=30; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Refine the mesh by this factor in both directions
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    pub refine: Option<f64>,
    /// Folder to write into [default: output/lift, or output/NAME-lift for one wing]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
}

impl Lift {
    /// Flies the wings.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let flights = self.flights();
        let ready = flights.ready()?;
        let mut folder = RunFolder::create(&self.target(), "lift")?;
        let flew = flights.fly(ready, console.progress())?;
        let asked = LiftAsked {
            inertial_power: self.inertial_power,
            sensitivity: self.sensitivity,
            has_added_mass: self.with.iter().any(|name| name == "added-mass"),
        };
        let mut summary = LiftSummary::new(&flights, &flew, &asked)?;
        pictures::lift::add(&mut folder, &summary)?;
        summary.files = folder.listed_with(self.report);
        let page = summary.page();
        let written = finished(folder, self.report.then_some(&page), &summary, console)?;
        console.answer(&page, &console.listed(&written, &summary.files), &summary)
    }

    fn flights(&self) -> Flights {
        let with = self.with.iter();
        let with = with.map(|name| format!("effects.{name}.strength=1.0"));
        let refine = self.refine.map(|factor| format!("mesh.refine={factor}"));
        Flights {
            files: self.wings.clone(),
            reference: self.reference.clone(),
            on: self.on.clone(),
            sets: self.set.iter().cloned().chain(with).chain(refine).collect(),
            source: self.twist.0,
            phases: self.phases,
            sweep: self.sweep.map(|count| Amplitudes {
                count,
                from_to_deg: self.amplitudes.as_deref().map(|given| match given {
                    [from, to] => [*from, *to],
                    _ => [0.0, 0.0],
                }),
            }),
        }
    }

    fn target(&self) -> PathBuf {
        let name = match self.wings.as_slice() {
            [only] if self.reference.is_none() => {
                let stem = only.file_stem().map(|stem| stem.to_string_lossy().into_owned());
                format!("{}-lift", stem.unwrap_or_default())
            }
            _ => "lift".to_string(),
        };
        self.output
            .clone()
            .unwrap_or_else(|| PathBuf::from("output").join(name))
    }
}
