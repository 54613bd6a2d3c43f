//! How a missing load may grow with the motion: by powers of frequency and amplitude, or from an onset on.
//!
//! More laws than [`super::fields`] weighs against the known effects: they are asked only once something without a name is there.
//! Powers and onsets are weighed jointly, so that a frequency and an amplitude that rise together in a campaign share their doubt.

use nalgebra::{DMatrix, DVector};

use crate::study::Forward;

use super::data::Data;
use super::fields::{Driver, Field, Law, distinct, load_fields, smooth_root};
use super::places::Places;

/// Largest power of frequency and of amplitude.
pub const HIGHEST: i32 = 4;
/// Prior share of the onsets among all laws of a load.
const ONSETS: f64 = 0.25;
/// Places of an onset that are tried between two neighbouring frequencies or amplitudes.
const PLACES: usize = 4;

/// A law of a load with its prior share, and how far its neighbours are from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadLaw {
    /// The law.
    pub law: Law,
    /// Its prior share among all laws of a load.
    pub share: f64,
    /// Width of the stretch of powers, frequencies or amplitudes that it stands for.
    pub width: f64,
}

/// How a missing load may grow, and all laws that are this growth in the conditions of the data.
#[derive(Debug, Clone)]
pub struct Growth {
    /// The field under the first of these laws.
    pub field: Field,
    /// The laws: the conditions do not tell them apart.
    pub laws: Vec<LoadLaw>,
}

/// Every growth of a load that the conditions tell from the others.
pub fn growths(
    forward: &dyn Forward,
    data: &Data,
    moment: &DMatrix<f64>,
    value: &DVector<f64>,
) -> Vec<Growth> {
    let root = smooth_root(moment.ncols());
    let places = Places::new(forward, data, value, moment.ncols());
    let response = moment.select_rows(data.rows.iter());
    let [f, phi] = [Driver::Frequency, Driver::Amplitude].map(|driver| {
        let conditions = data.conditions(forward).into_iter();
        distinct(conditions.filter_map(|(condition, _)| driver.of(&forward.conditions()[condition])))
    });
    let all = laws(&f, &phi);
    let plain: Vec<Law> = all.iter().map(|own| own.law).collect();
    load_fields(forward, data, &places, &response, &root, &plain)
        .into_iter()
        .map(|(field, same)| Growth {
            field,
            laws: same.into_iter().map(|index| all[index]).collect(),
        })
        .collect()
}

/// All laws of a load in conditions with these frequencies and amplitudes, powers first.
pub(super) fn laws(f: &[f64], phi: &[f64]) -> Vec<LoadLaw> {
    let mut onsets: Vec<LoadLaw> = Vec::new();
    for (of, values) in [(Driver::Frequency, f), (Driver::Amplitude, phi)] {
        let places = onsets_between(values);
        let whole: f64 = places.iter().map(|place| place.1).sum();
        onsets.extend(places.iter().map(|&(from, width)| LoadLaw {
            law: Law::Onset { of, from },
            share: width / whole,
            width,
        }));
    }
    let drivers: f64 = onsets.iter().map(|onset| onset.share).sum();
    let of_powers = if onsets.is_empty() { 1.0 } else { 1.0 - ONSETS };
    let count = f64::from((HIGHEST + 1) * (HIGHEST + 1));
    let mut all: Vec<LoadLaw> = (0..=HIGHEST)
        .flat_map(|a| (0..=HIGHEST).map(move |b| (a, b)))
        .map(|(a, b)| LoadLaw {
            law: Law::Load {
                frequency_power: f64::from(a),
                amplitude_power: f64::from(b),
            },
            share: of_powers / count,
            width: 1.0,
        })
        .collect();
    all.extend(onsets.into_iter().map(|onset| LoadLaw {
        share: ONSETS * onset.share / drivers,
        ..onset
    }));
    all
}

/// Where a growth with these values may set in, and the stretch that each place stands for: evenly between all neighbours, and as far
/// below the smallest as the next is above, but not below nought.
fn onsets_between(values: &[f64]) -> Vec<(f64, f64)> {
    let [first, second, ..] = values else {
        return Vec::new();
    };
    let ends = [(2.0 * first - second).max(0.0)];
    let ends: Vec<f64> = ends.into_iter().chain(values.iter().copied()).collect();
    let between = |w: &[f64]| {
        let (from, width) = (w[0], (w[1] - w[0]) / PLACES as f64);
        (0..PLACES).map(move |k| (from + (k as f64 + 0.5) * width, width))
    };
    ends.windows(2).flat_map(between).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_onset_below_the_slowest_flight_is_tried_too() {
        let places = onsets_between(&[18.0, 23.0, 26.0]);
        assert_eq!(places.len(), 3 * PLACES);
        assert!(places[0].0 > 13.0 && places[0].0 < 15.0 && places.last().unwrap().0 < 26.0);
        let whole: f64 = places.iter().map(|place| place.1).sum();
        assert!((whole - 13.0).abs() < 1e-12);
        assert!(onsets_between(&[20.0]).is_empty());
    }
}
