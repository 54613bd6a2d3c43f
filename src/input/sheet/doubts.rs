//! What looks wrong in a table: metres or centimetres for millimetres, radians for degrees, the other sign, the whole stroke for its half.
//! It is told with what to write; nothing is changed by a guess.

use super::condition::Condition;
use super::header::{Column, Role};
use crate::input::design::Design;
use crate::input::error::InputError;
use crate::input::measurement::{Channel, Measurement};

/// Stations that all lie within this share of the length from the base are in metres.
const METRES: f64 = 0.01;
/// Stations of which none lies beyond this share of the length may be in centimetres.
const CENTIMETRES: f64 = 0.15;
/// Largest twist, in the unit of the table, that may be in radians.
const RADIANS: f64 = 0.8;
/// A half amplitude so many times that of the design may be the whole stroke.
const WHOLE_STROKE: f64 = 1.6;

/// What to doubt.
///
/// # Errors
/// If no station can be meant as it stands.
pub fn doubts(
    table: &Measurement,
    columns: &[Column],
    conditions: &[Condition],
    design: &Design,
) -> Result<Vec<String>, InputError> {
    let mut doubts = Vec::new();
    doubts.extend(of_stations(table, design)?);
    doubts.extend(of_twists(table, columns));
    doubts.extend(of_amplitude(conditions, design));
    Ok(doubts)
}

fn of_stations(table: &Measurement, design: &Design) -> Result<Option<String>, InputError> {
    let length = design.planform.length_mm.value();
    let stations: Vec<f64> = table.rows.iter().filter_map(|row| row.r_mm).collect();
    let farthest = stations.iter().fold(0.0_f64, |far, r| far.max(r.abs()));
    let short = stations
        .iter()
        .filter(|r| **r > 0.0 && **r < METRES * length)
        .count();
    if farthest > 0.0 && farthest < METRES * length {
        let message = format!("has no station beyond {farthest} mm of a wing that is {length} mm long");
        let cure = format!(
            "Are they in metres? Then write r (m) above them; {} mm would be the outermost",
            farthest * 1000.0
        );
        return Err(InputError::about_file(&table.file, message, cure));
    }
    if farthest > 0.0 && farthest < CENTIMETRES * length {
        return Ok(Some(format!(
            "No station lies beyond {farthest} mm of a wing that is {length} mm long: are they in centimetres? Then write r (cm) above \
             them; {:.1} mm would be the outermost.",
            farthest * 10.0
        )));
    }
    Ok((short > 0).then(|| {
        format!(
            "{short} of {} stations lie within {} mm of the wing base: is one in metres? All stations are in one unit.",
            stations.len(),
            METRES * length
        )
    }))
}

fn of_twists(table: &Measurement, columns: &[Column]) -> Vec<String> {
    let mut doubts = Vec::new();
    let twists = table.rows.iter().filter(|row| row.channel == Channel::Twist);
    let twists: Vec<f64> = twists.map(|row| row.value).collect();
    let largest = twists
        .iter()
        .fold(0.0_f64, |largest, twist| largest.max(twist.abs()));
    let is_converted = columns
        .iter()
        .any(|column| matches!(column.role, Role::Readings { .. }) && column.factor != 1.0);
    if twists.len() > 1 && largest > 0.0 && largest < RADIANS && !is_converted {
        doubts.push(format!(
            "The largest twist is {largest:.3} deg: is it in radians ({:.1} deg)? Then write rad in its head, e.g. twist (rad).",
            largest.to_degrees()
        ));
    }
    let negative = twists.iter().filter(|twist| **twist < 0.0).count();
    if twists.len() > 2 && negative * 3 > twists.len() * 2 {
        doubts.push(format!(
            "{negative} of {} twists raise the angle of attack, where air loads lower it on most wings: is the sign the other \
             one? Positive is washout (nose down); write twist, nose up (deg) above readings of the other sign.",
            twists.len()
        ));
    }
    doubts
}

fn of_amplitude(conditions: &[Condition], design: &Design) -> Option<String> {
    let own = design.flapping.as_ref()?.half_amplitude_deg.value();
    let mut points = conditions.iter().flat_map(|condition| &condition.points);
    let point = points
        .find(|point| point.key == "flapping.half_amplitude_deg" && point.value > WHOLE_STROKE * own)?;
    Some(format!(
        "{} deg is taken for the half amplitude, {own} deg in the design: is it the whole stroke? Then write {} deg.",
        point.value,
        point.value / 2.0
    ))
}
