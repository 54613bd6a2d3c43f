//! `washout lift`: what a twist profile buys in lift, power and efficiency.

use std::path::PathBuf;

use clap::Args;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::export::lift::{LiftSummary, SpanCurve, StrokeCurve, SweepCurve, WingLift};
use crate::export::pictures;
use crate::export::run::RunFolder;
use crate::input::measurement::{Bound, Channel, Row};
use crate::lift::{InertialPower, LiftError, Ratios, StrokeMeans, TwistHistory};
use crate::origin::MadeOf;

use super::design_arguments::DesignArguments;
use super::finished::finished;
use super::{Console, Failure};
use crate::wing::flown::{can_fly, is_profile, of_design, of_profile};
use crate::wing::lift_ratios::{WingRatios, measured, sensitivity, wing_ratios};
use crate::wing::{Flown, TwistSource, WingError, WingModel};

/// Part of the span at either end that a profile may leave to its end points without a word.
const SHORT: f64 = 0.1;

/// Points of a half-stroke at which forces are written.
const INSTANTS: usize = 181;

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
    #[arg(long, value_enum, default_value_t = TwistSource::Phases)]
    pub twist: TwistSource,
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
        let parts = self.parts()?;
        let (ready, reference) = self.ready()?;
        let mut folder = RunFolder::create(&self.target(), "lift")?;
        let flown = self.flown(ready, &parts, console)?;
        let means: Vec<StrokeMeans> = flown.iter().map(means).collect::<Result<_, Failure>>()?;
        let mut summary = LiftSummary {
            twist: self.words(&flown),
            reference: flown[reference].name.clone(),
            wings: Vec::new(),
            ratios: Vec::new(),
            span: Vec::new(),
            stroke: Vec::new(),
            sweep: Vec::new(),
            sensitivity: Vec::new(),
            warnings: Vec::new(),
            made_of: MadeOf::files(flown.iter().flat_map(|wing| &wing.files)),
            files: Vec::new(),
        };
        for (index, (wing, mean)) in flown.iter().zip(&means).enumerate() {
            self.add_wing(&mut summary, wing, mean, &means[reference])?;
            if index != reference {
                let against = (&flown[reference], &means[reference]);
                self.add_ratios(&mut summary, (wing, mean), against)?;
            }
            self.add_sweep(&mut summary, wing, &parts)?;
        }
        summary.warnings.extend(flown.iter().filter_map(held));
        summary
            .warnings
            .extend(flown.iter().filter_map(|wing| self.only_bound(wing)));
        summary.warnings.extend(self.warnings(&summary));
        pictures::lift::add(&mut folder, &summary)?;
        summary.files = folder.listed_with(self.report);
        let page = summary.page(&folder.target().display().to_string());
        let words = self.report.then_some(page.as_str());
        finished(folder, words, ("summary", &summary), console)?;
        console.result(&page, &summary)
    }

    fn add_wing(
        &self,
        summary: &mut LiftSummary,
        wing: &Flown,
        mean: &StrokeMeans,
        reference: &StrokeMeans,
    ) -> Result<(), Failure> {
        let instants = wing.flight.instants(INSTANTS);
        let instants = instants.map_err(|error| WingError::design(&wing.file, error))?;
        summary.stroke.push(StrokeCurve {
            wing: wing.name.clone(),
            phase_deg: instants.iter().map(|i| i.phase_rad.to_degrees()).collect(),
            lift_mn: instants.iter().map(|i| i.lift_n * 1e3).collect(),
            drag_mn: instants.iter().map(|i| i.drag_n * 1e3).collect(),
            power_mw: instants.iter().map(|i| i.power_w * 1e3).collect(),
        });
        summary.span.push(SpanCurve::of(wing, mean, reference));
        let inertia = if self.inertial_power {
            wing.inertia_kg_m2()?
        } else {
            None
        };
        let inertial = inertia.map(|inertia| InertialPower::of(&wing.flight, inertia, &instants));
        summary.wings.push(WingLift::of(wing, mean, inertial));
        Ok(())
    }

    fn add_ratios(
        &self,
        summary: &mut LiftSummary,
        (wing, mean): (&Flown, &StrokeMeans),
        (reference, reference_mean): (&Flown, &StrokeMeans),
    ) -> Result<(), Failure> {
        let fault = |error: LiftError| WingError::design(&wing.file, error);
        let ratios = Ratios::between(mean, reference_mean).map_err(fault)?;
        let frequency = wing.flight.stroke.frequency_hz / reference.flight.stroke.frequency_hz;
        let found: WingRatios = wing_ratios(&wing.name, &ratios, frequency, measured(wing)).map_err(fault)?;
        summary.ratios.push(found);
        if self.sensitivity {
            summary.sensitivity.extend(sensitivity(wing, reference)?);
        }
        Ok(())
    }

    fn add_sweep(&self, summary: &mut LiftSummary, wing: &Flown, parts: &[f64]) -> Result<(), Failure> {
        if let Some(sweep) = self.swept(wing, parts)? {
            summary.sweep.push(sweep);
        } else if !parts.is_empty() {
            summary.warnings.push(format!(
                "{} is left out of the sweep: an effect on it knows the phase or the motion, so its twist does not follow \
                 the speed alone.",
                wing.name
            ));
        }
        Ok(())
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

    /// The wings as far as they can be had without solving, and which of them is the reference.
    fn ready(&self) -> Result<(Vec<Ready>, usize), Failure> {
        let mut files = self.wings.clone();
        let reference = match &self.reference {
            None => 0,
            Some(file) => files.iter().position(|known| known == file).unwrap_or_else(|| {
                files.insert(0, file.clone());
                0
            }),
        };
        let mut sets = self.set.clone();
        sets.extend(
            self.with
                .iter()
                .map(|name| format!("effects.{name}.strength=1.0")),
        );
        let case = |file: &PathBuf| -> Result<WingModel, Failure> {
            let case = WingModel::new(DesignArguments::of_file(file, &sets, self.refine).load(&[])?)?;
            can_fly(&case)?;
            Ok(case)
        };
        let designs: Vec<Option<WingModel>> = files
            .iter()
            .map(|file| (!is_profile(file)).then(|| case(file)).transpose())
            .collect::<Result<_, Failure>>()?;
        let on = match &self.on {
            Some(file) => Some(case(file)?),
            None => designs.iter().flatten().next().cloned(),
        };
        let ready = files
            .iter()
            .zip(designs)
            .map(|(file, design)| match (design, &on) {
                (Some(case), _) => Ok(Ready::Design(Box::new(case))),
                (None, Some(on)) => Ok(Ready::Profile(Box::new(of_profile(file, on)?))),
                (None, None) => Err(Failure::Option {
                    option: "--on",
                    reason: "a profile has no outline, air and stroke; name a design that gives them"
                        .to_string(),
                }),
            });
        let ready = ready.collect::<Result<Vec<Ready>, Failure>>()?;
        let name = |ready: &Ready| match ready {
            Ready::Design(case) => case.loaded.design.name.clone(),
            Ready::Profile(flown) => flown.name.clone(),
        };
        let names: Vec<String> = ready.iter().map(name).collect();
        if let Some(twice) = (1..names.len()).find(|&i| names[..i].contains(&names[i])) {
            let reason = format!(
                "two wings are called '{}'; give one of them another name",
                names[twice]
            );
            let option = "DESIGN|PROFILE";
            return Err(Failure::Option { option, reason });
        }
        Ok((ready, reference))
    }

    /// The wings with their twist.
    fn flown(&self, ready: Vec<Ready>, parts: &[f64], console: &Console) -> Result<Vec<Flown>, Failure> {
        console.progress().say("solving");
        let (source, phases) = (self.twist, self.phases);
        let unseen = console.progress().unseen();
        let fly = |ready: Ready| match ready {
            Ready::Design(case) => {
                let own = self.own_parts(&case, parts);
                of_design(*case, source, phases, &own, &unseen)
            }
            Ready::Profile(flown) => Ok(*flown),
        };
        let flown: Vec<Result<Flown, WingError>> = ready.into_par_iter().map(fly).collect();
        Ok(flown.into_iter().collect::<Result<_, WingError>>()?)
    }

    /// Amplitudes of the sweep: parts of each wing's own, or degrees where --amplitudes is given.
    fn parts(&self) -> Result<Vec<f64>, Failure> {
        let Some(count) = self.sweep else {
            return Ok(Vec::new());
        };
        let [from, to] = match self.amplitudes.as_deref() {
            Some([from, to]) => [*from, *to],
            Some(_) => [0.0, 0.0],
            None => [0.7, 1.3],
        };
        let is_range = from > 0.0 && to > from && to <= 180.0;
        if !is_range {
            return Err(Failure::Option {
                option: "--amplitudes",
                reason: "this is no range; give a smaller and a larger half amplitude in degrees, e.g. 24,45"
                    .to_string(),
            });
        }
        let step = (to - from) / f64::from(count - 1);
        Ok((0..count).map(|k| from + f64::from(k) * step).collect())
    }

    /// The same as parts of the amplitude of a design.
    fn own_parts(&self, case: &WingModel, parts: &[f64]) -> Vec<f64> {
        let own_deg = case
            .loaded
            .design
            .flapping
            .as_ref()
            .map(|f| f.half_amplitude_deg.value());
        match (&self.amplitudes, own_deg) {
            (Some(_), Some(own)) if own > 0.0 => parts.iter().map(|deg| deg / own).collect(),
            _ => parts.to_vec(),
        }
    }

    fn swept(&self, wing: &Flown, parts: &[f64]) -> Result<Option<SweepCurve>, Failure> {
        if parts.is_empty() {
            return Ok(None);
        }
        let mut curve = SweepCurve {
            wing: wing.name.clone(),
            half_amplitude_deg: Vec::new(),
            lift_mn: Vec::new(),
            drag_mn: Vec::new(),
            power_mw: Vec::new(),
        };
        for part in self.own_parts(&wing.model, parts) {
            let Some(flight) = wing.at_amplitude(part, self.twist) else {
                return Ok(None);
            };
            let fault = |error: LiftError| WingError::design(&wing.file, error);
            let flight = flight.map_err(fault)?;
            let mean = flight.means().map_err(fault)?;
            curve
                .half_amplitude_deg
                .push(flight.stroke.half_amplitude_rad.to_degrees());
            curve.lift_mn.push(mean.lift_n * 1e3);
            curve.drag_mn.push(mean.drag_n * 1e3);
            curve.power_mw.push(mean.power_w * 1e3);
        }
        Ok(Some(curve))
    }

    fn words(&self, flown: &[Flown]) -> String {
        let designs = match self.twist {
            TwistSource::Phases => format!("twist solved at {} phases of the stroke", self.phases),
            TwistSource::Ramp => "twist solved at mid-stroke, on the 20/60/20 ramp".to_string(),
            TwistSource::Measured => "measured twist on the 20/60/20 ramp".to_string(),
            TwistSource::Flat => "no twist".to_string(),
        };
        match flown.iter().filter(|wing| is_profile(&wing.file)).count() {
            0 => designs,
            count if count == flown.len() => "twist as given".to_string(),
            _ => format!("{designs}; twist of profiles as given"),
        }
    }

    /// That no twist but a bound of it was measured.
    fn only_bound(&self, wing: &Flown) -> Option<String> {
        let is_measured = self.twist == TwistSource::Measured && !is_profile(&wing.file);
        let measurement = wing.model.loaded.measurement.as_ref().filter(|_| is_measured)?;
        let twists = |row: &&Row| matches!(row.channel, Channel::Twist | Channel::TwistRate);
        let all_bounds = measurement
            .rows
            .iter()
            .filter(twists)
            .all(|row| row.bound != Bound::None);
        all_bounds.then(|| {
            format!(
                "{}: of its twist a bound is measured and no number; it is flown without twist.",
                wing.name
            )
        })
    }

    fn warnings(&self, summary: &LiftSummary) -> Vec<String> {
        let mut warnings = Vec::new();
        let assumed: Vec<&WingLift> = summary
            .wings
            .iter()
            .filter(|wing| wing.half_amplitude_is_assumed)
            .collect();
        if !assumed.is_empty() {
            warnings.push(
                "The amplitude is assumed: lift goes with its square and power with its cube. Ratios at equal frequency × \
                 amplitude do not depend on it while the twist is kept."
                    .to_string(),
            );
        }
        if self.with.iter().any(|name| name == "added-mass") {
            warnings.push(
                "Added mass moves the force within the stroke; over a whole stroke with the same twist on both sides of \
                 mid-stroke it gives no mean lift and takes no mean power."
                    .to_string(),
            );
        }
        warnings
    }
}

/// That a profile leaves a part of the wing to its first or last point.
fn held(wing: &Flown) -> Option<String> {
    let points = match &wing.flight.twist {
        TwistHistory::Ramp { full, .. } => full.points(),
        TwistHistory::Solved(phases) => phases.first()?.1.points(),
    };
    let (first_m, last_m) = (points.first()?[0], points.last()?[0]);
    let tip_m = wing.flight.planform.tip_m();
    let is_short = first_m > SHORT * tip_m || last_m < (1.0 - SHORT) * tip_m;
    (is_profile(&wing.file) && is_short).then(|| {
        format!(
            "{}: its profile covers {:.1} to {:.1} mm; beyond, the twist of its first and last point is held (the wing ends at \
             {:.1} mm).",
            wing.name,
            first_m * 1e3,
            last_m * 1e3,
            tip_m * 1e3
        )
    })
}

/// A wing before its twist is known.
enum Ready {
    Design(Box<WingModel>),
    Profile(Box<Flown>),
}

fn means(wing: &Flown) -> Result<StrokeMeans, Failure> {
    wing.flight
        .means()
        .map_err(|error| WingError::design(&wing.file, error).into())
}
