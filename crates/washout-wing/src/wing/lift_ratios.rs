//! Ratios of a flown wing to its reference beside what was measured, and how they move with what is not known.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::design::Coefficients;
use crate::input::measurement::{Bound, Channel};
use crate::lift::{EffectiveCoefficients, Flight, LiftError, Ratios, TwistHistory, implied_amplitude_ratio};

use super::error::WingError;
use super::flown::{Flown, is_profile};

/// A wing over the reference under three conditions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WingRatios {
    /// Name of the wing.
    pub name: String,
    /// Its frequency over that of the reference.
    pub frequency_ratio: f64,
    /// Its product of frequency and amplitude over that of the reference.
    pub rate_ratio: f64,
    /// Each at its own frequency and amplitude.
    pub as_flown: Ratios,
    /// At the same amplitude, each at its own frequency; with the twist kept.
    pub equal_amplitude: Ratios,
    /// At the same product of frequency and amplitude; with the twist kept.
    pub equal_rate: Ratios,
    /// What was measured, if anything was.
    pub measured: Option<MeasuredRatios>,
    /// What the measured lift says of the modelled one.
    pub effective: Option<Effective>,
}

/// Measured ratios to the reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredRatios {
    /// Mean lift, with its standard deviation.
    pub lift: Option<[f64; 2]>,
    /// Aerodynamic efficiency, with its standard deviation.
    pub efficiency: Option<[f64; 2]>,
    /// Effective lift coefficient as the source gives it, with its standard deviation.
    pub effective_lift: Option<[f64; 2]>,
}

/// What a measured lift says of the modelled one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Effective {
    /// Effective lift coefficient over that of the reference, each at its own frequency and both at the same amplitude.
    pub lift_at_equal_amplitude: f64,
    /// The same with the amplitudes of the designs.
    pub lift_as_flown: f64,
    /// Effective drag coefficient over that of the reference, if the measured efficiency is lift per power in that condition.
    pub drag_at_equal_amplitude: Option<f64>,
    /// Amplitude over that of the reference which the source's own effective coefficient implies.
    pub implied_amplitude_ratio: Option<f64>,
}

/// How the ratios of a wing move with one thing that is not known, changed alike on both wings, the twist kept.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Sensitivity {
    /// Name of the wing.
    pub wing: String,
    /// What is changed: a key of the design, or words.
    pub what: String,
    /// To what.
    pub value: String,
    /// Lift over drag over that of the reference.
    pub lift_to_drag: f64,
    /// Lift at equal frequency × amplitude.
    pub lift_at_equal_rate: f64,
    /// Lift per power at equal frequency × amplitude.
    pub lift_per_power_at_equal_rate: f64,
    /// Lift per power at the same amplitude, each at its own frequency.
    pub lift_per_power_at_equal_amplitude: f64,
}

/// What was measured of a wing as ratios to its reference.
pub fn measured(wing: &Flown) -> Option<MeasuredRatios> {
    let measurement = wing.model.loaded.measurement.as_ref()?;
    if is_profile(&wing.file) {
        return None;
    }
    let of = |channel: Channel| {
        let rows = measurement.rows.iter();
        let mut rows =
            rows.filter(|row| row.channel == channel && row.bound == Bound::None && !row.is_planned);
        rows.next().map(|row| [row.value, row.sigma])
    };
    let found = MeasuredRatios {
        lift: of(Channel::LiftRatio),
        efficiency: of(Channel::EfficiencyRatio),
        effective_lift: of(Channel::EffectiveLiftRatio),
    };
    (found.lift.is_some() || found.efficiency.is_some()).then_some(found)
}

/// The ratios of a wing under three conditions, and its effective coefficients where lift was measured.
pub fn wing_ratios(
    name: &str,
    ratios: &Ratios,
    frequency_ratio: f64,
    measured: Option<MeasuredRatios>,
) -> Result<WingRatios, LiftError> {
    let equal_amplitude = ratios.at_rate_ratio(frequency_ratio)?;
    let effective = measured.and_then(|measured| Some((measured, measured.lift?[0])));
    let effective = effective.map(|(measured, lift)| {
        let efficiency = measured.efficiency.map(|[value, _]| value);
        let here = EffectiveCoefficients::new(&equal_amplitude, lift, efficiency)?;
        let equal_rate = ratios.at_rate_ratio(1.0)?;
        let implied = measured.effective_lift.map(|[effective, _]| {
            implied_amplitude_ratio(lift / effective, equal_rate.lift, frequency_ratio)
        });
        Ok::<_, LiftError>(Effective {
            lift_at_equal_amplitude: here.lift,
            lift_as_flown: EffectiveCoefficients::new(ratios, lift, None)?.lift,
            drag_at_equal_amplitude: here.drag,
            implied_amplitude_ratio: implied.transpose()?,
        })
    });
    Ok(WingRatios {
        name: name.to_string(),
        frequency_ratio,
        rate_ratio: ratios.rate_ratio,
        as_flown: *ratios,
        equal_amplitude,
        equal_rate: ratios.at_rate_ratio(1.0)?,
        measured,
        effective: effective.transpose()?,
    })
}

/// Keys of a design that move ratios while the twist is kept.
const KEYS: [&str; 3] = ["planform.", "air.", "flapping."];

/// How the ratios move with what is assumed, with the ramp, and with the law of the coefficients; alike on both wings.
pub fn sensitivity(wing: &Flown, reference: &Flown) -> Result<Vec<Sensitivity>, WingError> {
    let row = |what: &str, value: String, pair: [&Flight; 2]| sensitivity_row(wing, what, value, pair);
    let mut rows = vec![row("nothing", "–".into(), [&wing.flight, &reference.flight])?];
    for assumption in wing.model.loaded.design.assumptions() {
        if !KEYS.iter().any(|key| assumption.key.starts_with(key)) {
            continue;
        }
        for value in assumption.range {
            let changed = |flown: &Flown| {
                changed(flown, |design| {
                    design.set(&assumption.key, value).map_err(WingError::from)
                })
            };
            let pair = [changed(wing)?, changed(reference)?];
            rows.push(row(&assumption.key, format!("{value}"), [&pair[0], &pair[1]])?);
        }
    }
    let whitney = |flown: &Flown| {
        changed(flown, |design| {
            design.air.coefficients = Coefficients::WhitneyWood;
            Ok(())
        })
    };
    if wing.model.loaded.design.air.coefficients != Coefficients::WhitneyWood {
        let pair = [whitney(wing)?, whitney(reference)?];
        rows.push(row(
            "air.coefficients",
            "whitney-wood".into(),
            [&pair[0], &pair[1]],
        )?);
    }
    for share in [1e-6_f64, 0.1, 0.3, 0.5] {
        if !matches!(wing.flight.twist, TwistHistory::Ramp { .. }) {
            break;
        }
        let percent = (100.0 * share).round();
        let words = format!("{percent:.0}/{:.0}/{percent:.0}", 100.0 - 2.0 * percent);
        let pair = [wing, reference].map(|flown| ramped(flown, share));
        rows.push(row("ramp of the twist", words, [&pair[0], &pair[1]])?);
    }
    Ok(rows)
}

/// The ratios of a wing to its reference, both flown with something changed to this value.
fn sensitivity_row(
    wing: &Flown,
    what: &str,
    value: String,
    pair: [&Flight; 2],
) -> Result<Sensitivity, WingError> {
    let fault = |error: LiftError| WingError::design(&wing.file, error);
    let [means, base] = [pair[0].means().map_err(fault)?, pair[1].means().map_err(fault)?];
    let ratios = Ratios::between(&means, &base).map_err(fault)?;
    let frequency = pair[0].stroke.frequency_hz / pair[1].stroke.frequency_hz;
    let equal = ratios.at_rate_ratio(1.0).map_err(fault)?;
    Ok(Sensitivity {
        wing: wing.name.clone(),
        what: what.to_string(),
        value,
        lift_to_drag: ratios.lift_to_drag,
        lift_at_equal_rate: equal.lift,
        lift_per_power_at_equal_rate: equal.lift_per_power,
        lift_per_power_at_equal_amplitude: equal.lift_per_power / frequency,
    })
}

/// The flight of a wing whose twist takes this share of the half-stroke to rise, if it is a ramp.
fn ramped(flown: &Flown, share: f64) -> Flight {
    let mut flight = flown.flight.clone();
    if let TwistHistory::Ramp { share: own, .. } = &mut flight.twist {
        *own = share;
    }
    flight
}

/// The flight of a wing whose design is changed, with the twist that it has.
fn changed(
    flown: &Flown,
    change: impl Fn(&mut crate::input::Design) -> Result<(), WingError>,
) -> Result<Flight, WingError> {
    let mut design = flown.model.loaded.design.clone();
    change(&mut design)?;
    let mut case = flown.model.clone();
    case.planform =
        crate::geometry::Planform::from_design(&design).map_err(|error| flown.model.fault(error))?;
    case.loaded.design = design;
    Ok(Flight {
        air: case.air()?,
        stroke: case.stroke()?,
        planform: case.planform,
        twist: flown.flight.twist.clone(),
    })
}
