//! Wings that flew, as the document of `washout lift`.

use crate::input::measurement::{Bound, Channel, Row};
use crate::lift::{InertialPower, LiftError, Ratios, StrokeMeans, TwistHistory};
use crate::program::MadeOf;
use crate::wing::flights::{Flew, Flights};
use crate::wing::flown::is_profile;
use crate::wing::lift_ratios::{measured, sensitivity, wing_ratios};
use crate::wing::{Flown, TwistSource, WingError};

use super::{LiftSummary, SpanCurve, StrokeCurve, SweepCurve, WingLift};

/// Part of the span at either end that a profile may leave to its end points without a word.
const SHORT: f64 = 0.1;

/// Points of a half-stroke at which forces are written.
const INSTANTS: usize = 181;

/// What is wanted besides the means of each wing and its ratios.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LiftAsked {
    /// Power against the wing's own inertia.
    pub inertial_power: bool,
    /// How the ratios move with what is not known, the twist kept.
    pub sensitivity: bool,
    /// Whether added mass was put on every wing, of which a note says what it does.
    pub has_added_mass: bool,
}

impl LiftSummary {
    /// Of wings that flew.
    ///
    /// # Errors
    /// If forces, means or ratios cannot be formed.
    pub fn new(flights: &Flights, flew: &Flew, asked: &LiftAsked) -> Result<LiftSummary, WingError> {
        let flown = &flew.wings;
        let means: Vec<StrokeMeans> = flown.iter().map(means).collect::<Result<_, WingError>>()?;
        let mut summary = LiftSummary {
            twist: words(flights, flown),
            reference: flown[flew.reference].name.clone(),
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
            summary.add_wing(wing, mean, &means[flew.reference], asked)?;
            if index != flew.reference {
                let against = (&flown[flew.reference], &means[flew.reference]);
                summary.add_ratios((wing, mean), against, asked)?;
            }
            summary.add_sweep(wing, flights)?;
        }
        summary.warnings.extend(flown.iter().filter_map(held));
        let bound = flown.iter().filter_map(|wing| only_bound(flights.source, wing));
        summary.warnings.extend(bound);
        summary.warnings.extend(warnings(&summary, asked));
        Ok(summary)
    }

    fn add_wing(
        &mut self,
        wing: &Flown,
        mean: &StrokeMeans,
        reference: &StrokeMeans,
        asked: &LiftAsked,
    ) -> Result<(), WingError> {
        let instants = wing.flight.instants(INSTANTS).map_err(fault(wing))?;
        self.stroke.push(StrokeCurve {
            wing: wing.name.clone(),
            phase_deg: instants.iter().map(|i| i.phase_rad.to_degrees()).collect(),
            lift_mn: instants.iter().map(|i| i.lift_n * 1e3).collect(),
            drag_mn: instants.iter().map(|i| i.drag_n * 1e3).collect(),
            power_mw: instants.iter().map(|i| i.power_w * 1e3).collect(),
        });
        self.span.push(SpanCurve::of(wing, mean, reference));
        let inertia = match asked.inertial_power {
            true => wing.inertia_kg_m2()?,
            false => None,
        };
        let inertial = inertia.map(|inertia| InertialPower::of(&wing.flight, inertia, &instants));
        self.wings.push(WingLift::of(wing, mean, inertial));
        Ok(())
    }

    fn add_ratios(
        &mut self,
        (wing, mean): (&Flown, &StrokeMeans),
        (reference, reference_mean): (&Flown, &StrokeMeans),
        asked: &LiftAsked,
    ) -> Result<(), WingError> {
        let ratios = Ratios::between(mean, reference_mean).map_err(fault(wing))?;
        let frequency = wing.flight.stroke.frequency_hz / reference.flight.stroke.frequency_hz;
        let found = wing_ratios(&wing.name, &ratios, frequency, measured(wing));
        self.ratios.push(found.map_err(fault(wing))?);
        if asked.sensitivity {
            self.sensitivity.extend(sensitivity(wing, reference)?);
        }
        Ok(())
    }

    fn add_sweep(&mut self, wing: &Flown, flights: &Flights) -> Result<(), WingError> {
        if flights.sweep.is_none() {
            return Ok(());
        }
        let Some(swept) = flights.swept(wing) else {
            self.warnings.push(format!(
                "{} is left out of the sweep: an effect on it knows the phase or the motion, so its twist does not follow \
                 the speed alone.",
                wing.name
            ));
            return Ok(());
        };
        let mut curve = SweepCurve {
            wing: wing.name.clone(),
            half_amplitude_deg: Vec::new(),
            lift_mn: Vec::new(),
            drag_mn: Vec::new(),
            power_mw: Vec::new(),
        };
        for flight in swept.map_err(fault(wing))? {
            let mean = flight.means().map_err(fault(wing))?;
            let amplitude_deg = flight.stroke.half_amplitude_rad.to_degrees();
            curve.half_amplitude_deg.push(amplitude_deg);
            curve.lift_mn.push(mean.lift_n * 1e3);
            curve.drag_mn.push(mean.drag_n * 1e3);
            curve.power_mw.push(mean.power_w * 1e3);
        }
        self.sweep.push(curve);
        Ok(())
    }
}

/// What is wrong with the file of a wing.
fn fault(wing: &Flown) -> impl Fn(LiftError) -> WingError {
    |error| WingError::design(&wing.file, error)
}

fn means(wing: &Flown) -> Result<StrokeMeans, WingError> {
    wing.flight.means().map_err(fault(wing))
}

/// Where the twist comes from.
fn words(of: &Flights, flown: &[Flown]) -> String {
    let designs = match of.source {
        TwistSource::Phases => format!("twist solved at {} phases of the stroke", of.phases),
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
fn only_bound(source: TwistSource, wing: &Flown) -> Option<String> {
    let is_measured = source == TwistSource::Measured && !is_profile(&wing.file);
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

/// What limits the numbers.
fn warnings(summary: &LiftSummary, asked: &LiftAsked) -> Vec<String> {
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
    if asked.has_added_mass {
        warnings.push(
            "Added mass moves the force within the stroke; over a whole stroke with the same twist on both sides of \
             mid-stroke it gives no mean lift and takes no mean power."
                .to_string(),
        );
    }
    warnings
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
