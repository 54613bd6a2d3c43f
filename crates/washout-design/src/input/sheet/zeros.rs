//! How well the zero of readings is known.

use crate::input::measurement::{Channel, Measurement};

/// The standard deviation of the zero of each channel that has one: that of a reading, the middle one of all.
///
/// A twist and a displacement are differences to the unloaded wing, which is read in the same way.
pub fn zeros(table: &Measurement) -> Vec<(Channel, f64)> {
    let mut zeros: Vec<(Channel, f64)> = Vec::new();
    for row in &table.rows {
        let has_zero = row.channel == Channel::Twist || row.channel.is_displacement();
        if !has_zero || zeros.iter().any(|(known, _)| *known == row.channel) {
            continue;
        }
        let own = table.rows.iter().filter(|other| other.channel == row.channel);
        let mut sigmas: Vec<f64> = own.map(|other| other.sigma).collect();
        sigmas.sort_by(f64::total_cmp);
        zeros.push((row.channel, sigmas[sigmas.len() / 2]));
    }
    zeros
}
