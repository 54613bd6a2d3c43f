//! What the model gives for one measured number: the same station or interval, channel and unit.

use std::collections::BTreeMap;

use super::observer::Observer;
use super::profile::TwistProfile;
use super::rate::mean_rate;
use super::stages::DEG_PER_MM;
use crate::input::measurement::{Bound, Channel, Row};

/// What the model gives for a measured number, in the unit of the channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelReading {
    /// The value.
    pub value: f64,
    /// Whether it is only a bound, as a camera reads a feathered section.
    pub bound: Bound,
    /// Where the model could be read last, mm, if that is short of the outer end of the interval.
    pub read_to_mm: Option<f64>,
}

/// Reads the model as a measured row says; `whole_wing` holds the modelled channels of the whole wing in their units.
///
/// # Errors
/// A sentence that says why the model cannot be read there.
pub fn read_channel(
    row: &Row,
    observer: &Observer,
    profile: &TwistProfile,
    whole_wing: &BTreeMap<Channel, f64>,
) -> Result<ChannelReading, String> {
    let reading = match row.channel {
        Channel::Twist => twist(row, observer),
        Channel::TwistRate => twist_rate(row, profile),
        Channel::Deflection => displacement(row, observer, 2),
        Channel::ChordwiseDisplacement => displacement(row, observer, 1),
        Channel::SpanwiseDisplacement => displacement(row, observer, 0),
        channel => whole(channel, whole_wing),
    }?;
    match reading.value.is_finite() {
        true => Ok(reading),
        false => Err("the model gives no finite value for it".to_string()),
    }
}

fn twist(row: &Row, observer: &Observer) -> Result<ChannelReading, String> {
    let reading = observer
        .twist(station_m(row)?)
        .map_err(|reason| reason.to_string())?;
    Ok(ChannelReading {
        value: reading.twist_rad.to_degrees(),
        bound: reading.bound,
        read_to_mm: None,
    })
}

fn twist_rate(row: &Row, profile: &TwistProfile) -> Result<ChannelReading, String> {
    let to_mm = row.r_to_mm.ok_or("the row has no outer end r_to_mm")?;
    let Some(rate) = mean_rate(profile, station_m(row)?, to_mm / 1e3) else {
        return Err("the model cannot be read over any of this interval".to_string());
    };
    Ok(ChannelReading {
        value: rate.rate_rad_per_m * DEG_PER_MM,
        bound: rate.bound,
        read_to_mm: rate.is_clipped.then_some(rate.to_m * 1e3),
    })
}

fn displacement(row: &Row, observer: &Observer, axis: usize) -> Result<ChannelReading, String> {
    let Some(moved_m) = observer.displacement(station_m(row)?, row.chord_fraction.unwrap_or(0.0)) else {
        return Err("the station lies off the leading edge of the mesh; nothing is extrapolated".to_string());
    };
    Ok(value(moved_m[axis] * 1e3))
}

fn whole(channel: Channel, whole_wing: &BTreeMap<Channel, f64>) -> Result<ChannelReading, String> {
    match whole_wing.get(&channel) {
        Some(modelled) => Ok(value(*modelled)),
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

fn value(value: f64) -> ChannelReading {
    ChannelReading {
        value,
        bound: Bound::None,
        read_to_mm: None,
    }
}

fn station_m(row: &Row) -> Result<f64, String> {
    Ok(row.r_mm.ok_or("the row has no station r_mm")? / 1e3)
}
