//! Ratios of a flown wing to its reference beside what was measured, and how they move with what is not known.

use crate::export::lift::{Effective, MeasuredRatios, RatioSet, Sensitivity, WingRatios};
use crate::input::design::Coefficients;
use crate::input::measurement::{Bound, Channel};
use crate::lift::{EffectiveCoefficients, Flight, LiftError, Ratios, TwistHistory, implied_amplitude_ratio};

use super::Failure;
use super::flights::Flown;
use super::reading::air_law;

/// What was measured of a wing as ratios to its reference.
pub fn measured(wing: &Flown) -> Option<MeasuredRatios> {
    let measurement = wing.case.loaded.measurement.as_ref()?;
    if super::flights::is_profile(&wing.file) {
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
        as_flown: RatioSet::from(ratios),
        equal_amplitude: RatioSet::from(&equal_amplitude),
        equal_rate: RatioSet::at(ratios, 1.0)?,
        measured,
        effective: effective.transpose()?,
    })
}

/// Keys of a design that move ratios while the twist is kept.
const KEYS: [&str; 3] = ["planform.", "air.", "flapping."];

/// How the ratios move with what is assumed, with the ramp, and with the law of the coefficients; alike on both wings.
pub fn sensitivity(wing: &Flown, reference: &Flown) -> Result<Vec<Sensitivity>, Failure> {
    let fault = |error: LiftError| Failure::design(&wing.file, error);
    let row = |what: &str, value: String, pair: [&Flight; 2]| -> Result<Sensitivity, Failure> {
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
    };
    let mut rows = vec![row("nothing", "–".into(), [&wing.flight, &reference.flight])?];
    for assumption in wing.case.loaded.design.assumptions() {
        if !KEYS.iter().any(|key| assumption.key.starts_with(key)) {
            continue;
        }
        for value in assumption.range {
            let changed = |flown: &Flown| {
                changed(flown, |design| {
                    design.set(&assumption.key, value).map_err(Failure::from)
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
    if wing.case.loaded.design.air.coefficients != Coefficients::WhitneyWood {
        let pair = [whitney(wing)?, whitney(reference)?];
        rows.push(row(
            "air.coefficients",
            "whitney-wood".into(),
            [&pair[0], &pair[1]],
        )?);
    }
    for share in [1e-6, 0.1, 0.3, 0.5] {
        let ramped = |flown: &Flown| {
            let mut flight = flown.flight.clone();
            if let TwistHistory::Ramp { share: own, .. } = &mut flight.twist {
                *own = share;
            }
            flight
        };
        if !matches!(wing.flight.twist, TwistHistory::Ramp { .. }) {
            break;
        }
        let percent = (100.0 * share).round();
        let words = format!("{percent:.0}/{:.0}/{percent:.0}", 100.0 - 2.0 * percent);
        rows.push(row(
            "ramp of the twist",
            words,
            [&ramped(wing), &ramped(reference)],
        )?);
    }
    Ok(rows)
}

/// The flight of a wing whose design is changed, with the twist that it has.
fn changed(
    flown: &Flown,
    change: impl Fn(&mut crate::input::Design) -> Result<(), Failure>,
) -> Result<Flight, Failure> {
    let mut design = flown.case.loaded.design.clone();
    change(&mut design)?;
    let mut case = flown.case.clone();
    case.planform =
        crate::geometry::Planform::from_design(&design).map_err(|error| flown.case.fault(error))?;
    case.loaded.design = design;
    let flow = crate::aero::Flow::from_design(&case.loaded.design);
    let flow = flow.ok_or_else(|| case.fault(LiftError::NotFlapping))?;
    Ok(Flight {
        air: air_law(&case)?,
        stroke: crate::lift::Stroke::from_flow(&flow).map_err(|error| case.fault(error))?,
        planform: case.planform,
        twist: flown.flight.twist.clone(),
    })
}
