//! One measured number against what the model gives for it.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::design::Instrument;
use crate::input::measurement::{Bound, Channel, Row, SigmaKind};
use crate::observation::{Observer, TwistProfile, mean_rate, stages::DEG_PER_MM};

/// A measured number and the modelled one, both in the unit of the channel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedRow {
    /// Line of the measurement file.
    pub line: usize,
    /// Name of the run; may be empty.
    pub run: String,
    /// What was measured.
    pub channel: Channel,
    /// Unit of all values of this row; `1` for ratios.
    pub unit: String,
    /// Instrument that measured a twist.
    pub instrument: Option<Instrument>,
    /// Station, or inner end of the interval.
    pub r_mm: Option<f64>,
    /// Outer end of the interval.
    pub r_to_mm: Option<f64>,
    /// Chord fraction behind the leading edge at which a displacement is read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chord_fraction: Option<f64>,
    /// Where the model could be read last, if that is short of the outer end.
    pub read_to_mm: Option<f64>,
    /// Measured value.
    pub measured: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Where the standard deviation comes from.
    pub sigma_kind: SigmaKind,
    /// Whether the measured value is only a bound.
    pub bound: Bound,
    /// Modelled value.
    pub modelled: f64,
    /// Whether the modelled value is only a bound, as a camera reads a feathered section.
    pub modelled_bound: Bound,
    /// Measured minus modelled.
    pub error: f64,
    /// The part of the error that no bound allows.
    pub misfit: f64,
    /// That part in standard deviations of the measurement.
    pub misfit_sigma: f64,
}

/// A measured number that was not compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NotCompared {
    /// Line of the measurement file.
    pub line: usize,
    /// What was measured.
    pub channel: Channel,
    /// Station, or inner end of the interval.
    pub r_mm: Option<f64>,
    /// Why it was not compared.
    pub reason: String,
}

/// What the model says about a row.
struct Modelled {
    value: f64,
    bound: Bound,
    read_to_mm: Option<f64>,
}

/// Compares one row; `whole_wing` holds the modelled channels of the whole wing in their units.
pub fn compare_row(
    row: &Row,
    observer: &Observer,
    profile: &TwistProfile,
    whole_wing: &BTreeMap<Channel, f64>,
) -> Result<ComparedRow, NotCompared> {
    let modelled = match row.channel {
        Channel::Twist => twist(row, observer),
        Channel::TwistRate => twist_rate(row, profile),
        Channel::Deflection => displacement(row, observer, 2),
        Channel::ChordwiseDisplacement => displacement(row, observer, 1),
        Channel::SpanwiseDisplacement => displacement(row, observer, 0),
        channel => whole(channel, whole_wing),
    };
    let modelled = modelled.map_err(|reason| NotCompared {
        line: row.line,
        channel: row.channel,
        r_mm: row.r_mm,
        reason,
    })?;
    let error = row.value - modelled.value;
    let misfit = misfit(error, row.bound, modelled.bound);
    Ok(ComparedRow {
        line: row.line,
        run: row.run.clone(),
        channel: row.channel,
        unit: row.channel.unit().to_string(),
        instrument: row.instrument,
        r_mm: row.r_mm,
        r_to_mm: row.r_to_mm,
        chord_fraction: row.chord_fraction,
        read_to_mm: modelled.read_to_mm,
        measured: row.value,
        sigma: row.sigma,
        sigma_kind: row.sigma_kind,
        bound: row.bound,
        modelled: modelled.value,
        modelled_bound: modelled.bound,
        error,
        misfit,
        misfit_sigma: misfit / row.sigma,
    })
}

/// The part of `error` = measured − modelled that stays when either value may lie anywhere beyond its bound.
///
/// If the wing does at most the measured value, or the model at least the modelled one, then the true error is at
/// most `error`, and only a negative one is a misfit; and the other way round.
pub fn misfit(error: f64, measured: Bound, modelled: Bound) -> f64 {
    let is_at_most = measured == Bound::Upper || modelled == Bound::Lower;
    let is_at_least = measured == Bound::Lower || modelled == Bound::Upper;
    match (is_at_most, is_at_least) {
        (false, false) => error,
        (true, false) => error.min(0.0),
        (false, true) => error.max(0.0),
        (true, true) => 0.0,
    }
}

fn twist(row: &Row, observer: &Observer) -> Result<Modelled, String> {
    let reading = observer
        .twist(station_m(row)?)
        .map_err(|reason| reason.to_string())?;
    Ok(Modelled {
        value: reading.twist_rad.to_degrees(),
        bound: reading.bound,
        read_to_mm: None,
    })
}

fn twist_rate(row: &Row, profile: &TwistProfile) -> Result<Modelled, String> {
    let to_mm = row.r_to_mm.ok_or("the row has no outer end r_to_mm")?;
    let Some(rate) = mean_rate(profile, station_m(row)?, to_mm / 1e3) else {
        return Err("the model cannot be read over any of this interval".to_string());
    };
    Ok(Modelled {
        value: rate.rate_rad_per_m * DEG_PER_MM,
        bound: rate.bound,
        read_to_mm: rate.is_clipped.then_some(rate.to_m * 1e3),
    })
}

fn displacement(row: &Row, observer: &Observer, axis: usize) -> Result<Modelled, String> {
    let Some(moved_m) = observer.displacement(station_m(row)?, row.chord_fraction.unwrap_or(0.0)) else {
        return Err("the station lies off the leading edge of the mesh; nothing is extrapolated".to_string());
    };
    Ok(value(moved_m[axis] * 1e3))
}

fn whole(channel: Channel, whole_wing: &BTreeMap<Channel, f64>) -> Result<Modelled, String> {
    match whole_wing.get(&channel) {
        Some(modelled) if modelled.is_finite() => Ok(value(*modelled)),
        Some(_) => Err("the model gives no finite value for it".to_string()),
        None => Err(why_missing(channel).to_string()),
    }
}

fn why_missing(channel: Channel) -> &'static str {
    match channel {
        Channel::LiftRatio | Channel::DragRatio | Channel::EfficiencyRatio => {
            "a ratio to the rigid wing needs that wing's solution beside this one"
        }
        Channel::EffectiveLiftRatio => {
            "it is a measured ratio over a modelled one, so it is no measurement that a model could miss"
        }
        Channel::Frequency => "natural frequencies were not computed for this comparison",
        _ => "this run computed no mean over the stroke",
    }
}

fn value(value: f64) -> Modelled {
    Modelled {
        value,
        bound: Bound::None,
        read_to_mm: None,
    }
}

fn station_m(row: &Row) -> Result<f64, String> {
    Ok(row.r_mm.ok_or("the row has no station r_mm")? / 1e3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_counts_only_beyond_itself() {
        for (error, measured, modelled, expected) in [
            (2.0, Bound::None, Bound::None, 2.0),
            (2.0, Bound::Upper, Bound::None, 0.0),
            (-2.0, Bound::Upper, Bound::None, -2.0),
            (2.0, Bound::Lower, Bound::None, 2.0),
            (-2.0, Bound::Lower, Bound::None, 0.0),
            (2.0, Bound::None, Bound::Lower, 0.0),
            (-2.0, Bound::None, Bound::Lower, -2.0),
            (2.0, Bound::None, Bound::Upper, 2.0),
            (-2.0, Bound::Lower, Bound::Lower, 0.0),
        ] {
            assert_eq!(
                misfit(error, measured, modelled),
                expected,
                "{error} {measured:?} {modelled:?}"
            );
        }
    }
}
