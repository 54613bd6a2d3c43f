//! Wings on their stroke, from designs and profiles, with the twist that is asked for.

use std::f64::consts::FRAC_PI_2;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;

use crate::aero::Flow;
use crate::coupling::build::built;
use crate::effects::{Need, bind};
use crate::input::TwistTable;
use crate::lift::{Flight, LiftError, Stroke, TwistAlongSpan, TwistHistory};
use crate::origin::InputFile;
use crate::progress::Progress;
use crate::structure::MassProperties;
use crate::structure::state::State;

use super::error::WingError;
use super::model::WingModel;
use super::solved::SolvedWing;

/// A profile may go on beyond the tip by this factor on the length.
const BEYOND: f64 = 1.2;

/// Where the twist of a design comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TwistSource {
    /// Solved at phases of the stroke, each as if it stood still
    Phases,
    /// Solved at mid-stroke, and ramped up and down over each half-stroke (20/60/20)
    Ramp,
    /// The measured profile that the design names, on the same ramp
    Measured,
    /// None
    Flat,
}

/// A wing on its stroke, and what it was made from.
#[derive(Debug, Clone)]
pub struct Flown {
    /// Name of the wing.
    pub name: String,
    /// File that it came from.
    pub file: PathBuf,
    /// Every file that it was read from.
    pub files: Vec<InputFile>,
    /// The design that gives outline, air and stroke.
    pub model: WingModel,
    /// The wing on its stroke.
    pub flight: Flight,
    /// Solutions at parts of the full speed, for other amplitudes: (part, twist), falling; empty where twist does not follow
    /// the speed alone.
    pub by_speed: Vec<(f64, TwistAlongSpan)>,
}

/// Whether a file holds a profile rather than a design.
pub fn is_profile(file: &Path) -> bool {
    file.extension().is_some_and(|extension| extension == "csv")
}

/// Refuses a profile that goes on far beyond the wing: it is of another wing, or in another unit.
fn covers(file: &Path, table: &TwistTable, on: &WingModel) -> Result<(), WingError> {
    let length_mm = on.planform.length_m() * 1e3;
    let points = table.profiles.iter().flat_map(|(_, points)| points);
    let last_mm = points.map(|point| point[0]).fold(0.0, f64::max);
    if last_mm > BEYOND * length_mm {
        return Err(WingError::Question {
            question: "PROFILE",
            reason: format!(
                "{}: r_mm goes up to {last_mm}, and the wing ({}) is {length_mm} mm long; give millimetres from the wing base",
                file.display(),
                on.loaded.design.name
            ),
        });
    }
    Ok(())
}

/// A profile on the stroke of a design.
pub fn of_profile(file: &Path, on: &WingModel) -> Result<Flown, WingError> {
    let table = TwistTable::load(file)?;
    let stroke = on.stroke()?;
    covers(file, &table, on)?;
    let refuse = |error: LiftError| WingError::design(file, error);
    let along = |points: &Vec<[f64; 2]>| {
        let points = points.iter().map(|[r_mm, deg]| [r_mm * 1e-3, deg.to_radians()]);
        TwistAlongSpan::from_points(points.collect()).map_err(refuse)
    };
    let twist = match table.profiles.as_slice() {
        [(None, points)] => TwistHistory::paper_ramp(along(points)?),
        profiles => {
            let phases = profiles
                .iter()
                .map(|(phase_deg, points)| Ok((phase_deg.unwrap_or(0.0).to_radians(), along(points)?)));
            TwistHistory::solved(phases.collect::<Result<_, WingError>>()?).map_err(refuse)?
        }
    };
    Ok(Flown {
        name: file
            .file_stem()
            .map_or("profile".into(), |stem| stem.to_string_lossy().into_owned()),
        file: file.to_path_buf(),
        files: on.loaded.files.iter().chain(&table.input).cloned().collect(),
        flight: Flight {
            planform: on.planform.clone(),
            air: on.air()?,
            stroke,
            twist,
        },
        model: on.clone(),
        by_speed: Vec::new(),
    })
}

/// A design with the twist that is asked for; `amplitudes`: besides its own, others over it at which it will flap.
pub fn of_design(
    wing: WingModel,
    source: TwistSource,
    phases: u16,
    amplitudes: &[f64],
    progress: &Progress,
) -> Result<Flown, WingError> {
    let stroke = wing.stroke()?;
    let mut by_speed = Vec::new();
    let twist = match source {
        TwistSource::Flat => TwistHistory::paper_ramp(TwistAlongSpan::flat()),
        TwistSource::Measured => {
            let measurement = wing.loaded.measurement.as_ref();
            let measurement = measurement.ok_or_else(|| wing.no_measurement())?;
            let full = TwistAlongSpan::from_measurement(measurement);
            TwistHistory::paper_ramp(full.map_err(|error| wing.fault(error))?)
        }
        TwistSource::Ramp => {
            by_speed = at_speeds(&wing, &[&[1.0], amplitudes].concat(), progress)?;
            TwistHistory::paper_ramp(at_full_speed(&by_speed))
        }
        TwistSource::Phases => {
            has_no_rates(&wing)?;
            let own = (0..phases).map(|k| (FRAC_PI_2 * f64::from(k) / f64::from(phases)).cos());
            let own: Vec<f64> = own.collect();
            if follows_speed(&wing)? {
                by_speed = at_speeds(&wing, &[&own, amplitudes].concat(), progress)?;
                // those of other amplitudes are not of this stroke: it is the same with and without them
                let is_own = |speed: f64| own.iter().any(|known| (known - speed).abs() < 1e-9);
                let known: Vec<_> = by_speed
                    .iter()
                    .filter(|(speed, _)| is_own(*speed))
                    .cloned()
                    .collect();
                over_stroke(&known, 1.0).map_err(|error| wing.fault(error))?
            } else {
                at_phases(&wing, phases, progress)?
            }
        }
    };
    Ok(Flown {
        name: wing.design().name.clone(),
        file: wing.loaded.path.clone(),
        files: wing.loaded.files.clone(),
        flight: Flight {
            planform: wing.planform.clone(),
            air: wing.air()?,
            stroke,
            twist,
        },
        model: wing,
        by_speed,
    })
}

impl Flown {
    /// The same wing at another amplitude, `part` times its own; none where its twist there is not known.
    pub fn at_amplitude(&self, part: f64, source: TwistSource) -> Option<Result<Flight, LiftError>> {
        let twist = match (source, self.by_speed.as_slice()) {
            (TwistSource::Measured | TwistSource::Flat, _) => Ok(self.flight.twist.clone()),
            _ if is_profile(&self.file) => Ok(self.flight.twist.clone()),
            (_, []) => return None,
            (TwistSource::Ramp, known) => {
                let near = known.iter().find(|(speed, _)| (speed - part).abs() < 1e-9)?;
                Ok(TwistHistory::paper_ramp(near.1.clone()))
            }
            (TwistSource::Phases, known) => over_stroke(known, part),
        };
        let half_amplitude_rad = self.flight.stroke.half_amplitude_rad * part;
        Some(twist.map(|twist| Flight {
            stroke: Stroke {
                half_amplitude_rad,
                ..self.flight.stroke
            },
            twist,
            ..self.flight.clone()
        }))
    }

    /// Inertia about the stroke axis, kg·m², at rest; none for a profile, which has no mass.
    pub fn inertia_kg_m2(&self) -> Result<Option<f64>, WingError> {
        if is_profile(&self.file) {
            return Ok(None);
        }
        let design = self.model.design();
        let unsolved = |source| self.model.unsolved(source);
        let effects = bind(design).map_err(|error| unsolved(error.into()))?;
        let (model, _) = built(design, &self.model.mesh, &effects, None, None).map_err(unsolved)?;
        let properties = MassProperties::of(&model, &State::at_rest(model.nodes.len()));
        let axis = Vector3::new(-self.flight.planform.root_offset_m(), 0.0, 0.0);
        let direction = Flow::from_design(design).map(|flow| flow.lift_direction());
        Ok(direction.map(|direction| properties.about_kg_m2(&axis, &direction)))
    }
}

/// Refuses a design without stroke, or with air that cannot be set up, before anything is solved.
pub fn can_fly(wing: &WingModel) -> Result<(), WingError> {
    wing.stroke()?;
    wing.air().map(|_| ())
}

/// Refuses effects that act by the rates of the twist where shapes are solved one by one: a line through a few of them has
/// steps for rates.
fn has_no_rates(wing: &WingModel) -> Result<(), WingError> {
    let bound = bind(wing.design()).map_err(|error| wing.fault(error))?;
    let by_rates = bound
        .iter()
        .find(|bound| bound.effect.card().needs.contains(&Need::Motion));
    match by_rates {
        Some(bound) => Err(WingError::Question {
            question: "--twist phases",
            reason: format!(
                "{} acts by the rates of the twist, and shapes that are solved one by one have none; give --twist ramp, \
                 --twist measured, or a profile with many phases (CSV: phase_deg, r_mm, twist_deg)",
                bound.effect.card().name
            ),
        }),
        None => Ok(()),
    }
}

/// Whether the shape follows the speed of the air alone, whatever the phase and the motion.
fn follows_speed(wing: &WingModel) -> Result<bool, WingError> {
    let bound = bind(wing.design()).map_err(|error| wing.fault(error))?;
    let is_free = |effect: &crate::effects::Acting| {
        let card = effect.card();
        let moves = |need: &Need| matches!(need, Need::Motion | Need::OffMidStroke);
        let own = crate::effects::named(card.name).is_none();
        !card.needs.iter().any(moves) && !effect.depends_on_stroke() && !own
    };
    Ok(bound.iter().all(|bound| is_free(&bound.effect)))
}

/// Twist as solved at mid-stroke with these parts of the amplitude, from the largest down.
fn at_speeds(
    wing: &WingModel,
    parts: &[f64],
    progress: &Progress,
) -> Result<Vec<(f64, TwistAlongSpan)>, WingError> {
    let mut parts: Vec<f64> = parts.iter().copied().filter(|part| *part > 0.0).collect();
    parts.sort_by(|a, b| b.total_cmp(a));
    parts.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let mut last: Option<SolvedWing> = None;
    let mut known = Vec::new();
    for part in parts {
        let name = &wing.design().name;
        progress.say(format_args!(
            "solving {name} at {:.0} % of its speed",
            100.0 * part
        ));
        let solved = wing.at_speed(part, last.as_ref(), progress)?;
        known.push((part, twist_of(&solved)?));
        last = Some(solved);
    }
    Ok(known)
}

fn at_phases(wing: &WingModel, count: u16, progress: &Progress) -> Result<TwistHistory, WingError> {
    let mut phases = Vec::new();
    let mut last: Option<SolvedWing> = None;
    for index in 0..count {
        let phase = FRAC_PI_2 * f64::from(index) / f64::from(count);
        let phase_deg = phase.to_degrees();
        let name = &wing.design().name;
        progress.say(format_args!("solving {name} at phase {phase_deg:.0} deg"));
        let solved = wing.at_phase(phase_deg, last.as_ref(), progress)?;
        phases.push((phase, twist_of(&solved)?));
        last = Some(solved);
    }
    TwistHistory::solved(phases).map_err(|error| wing.fault(error))
}

fn twist_of(wing: &SolvedWing) -> Result<TwistAlongSpan, WingError> {
    let stop = wing.model.design().flapping.as_ref();
    let stop_rad = stop.map_or(0.0, |flapping| flapping.stop_angle_deg.value().to_radians());
    TwistAlongSpan::from_strips(&wing.solution.strips, stop_rad).map_err(|error| wing.model.fault(error))
}

fn at_full_speed(known: &[(f64, TwistAlongSpan)]) -> TwistAlongSpan {
    let full = known.iter().find(|(part, _)| (part - 1.0).abs() < 1e-9);
    full.map_or_else(TwistAlongSpan::flat, |(_, twist)| twist.clone())
}

/// The twist over the stroke at `part` of the amplitude, where each speed has its known twist.
fn over_stroke(known: &[(f64, TwistAlongSpan)], part: f64) -> Result<TwistHistory, LiftError> {
    let reached = known.iter().filter(|(speed, _)| *speed <= part * (1.0 + 1e-9));
    let phases = reached.map(|(speed, twist)| ((speed / part).min(1.0).acos(), twist.clone()));
    TwistHistory::solved(phases.collect())
}
