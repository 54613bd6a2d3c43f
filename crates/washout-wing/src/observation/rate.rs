//! Mean twist rate over a stretch of the span, read from a profile.

use super::profile::TwistProfile;
use crate::input::measurement::Bound;

/// Mean twist rate over a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanRate {
    /// (θ(to) − θ(from))/(to − from), rad/m.
    pub rate_rad_per_m: f64,
    /// Where the stretch that was read starts, m.
    pub from_m: f64,
    /// Where it ends, m: the end asked for, or the last readable station before it.
    pub to_m: f64,
    /// Whether the end asked for lies beyond the last readable station.
    pub is_clipped: bool,
    /// Whether a reading at either end makes the rate a bound.
    pub bound: Bound,
}

/// Mean rate between `from_m` and `to_m`, straight between neighbouring stations of the profile.
///
/// An end beyond the last station is moved there and reported; nothing is extrapolated. None where the stretch
/// starts before the first station, holds no length that can be read, or has mere bounds at both ends.
pub fn mean_rate(profile: &TwistProfile, from_m: f64, to_m: f64) -> Option<MeanRate> {
    let last_m = profile.readings.last()?.r_m;
    let end_m = to_m.min(last_m);
    if end_m - from_m <= 1e-6 {
        return None;
    }
    let (start, end) = (interpolated(profile, from_m)?, interpolated(profile, end_m)?);
    Some(MeanRate {
        rate_rad_per_m: (end.0 - start.0) / (end_m - from_m),
        from_m,
        to_m: end_m,
        is_clipped: to_m > last_m + 1e-9,
        bound: difference_bound(end.1, start.1)?,
    })
}

/// Twist at `r_m`, straight between stations, and whether it rests on a bound; none outside the stations.
pub fn interpolated(profile: &TwistProfile, r_m: f64) -> Option<(f64, Bound)> {
    let readings = &profile.readings;
    if let Some(reading) = readings.iter().find(|reading| (reading.r_m - r_m).abs() <= 1e-9) {
        return Some((reading.twist_rad, reading.bound));
    }
    let pair = readings
        .windows(2)
        .find(|pair| pair[0].r_m < r_m && r_m < pair[1].r_m)?;
    let share = (r_m - pair[0].r_m) / (pair[1].r_m - pair[0].r_m);
    let twist_rad = pair[0].twist_rad + share * (pair[1].twist_rad - pair[0].twist_rad);
    let bound = if pair[0].bound == Bound::None {
        pair[1].bound
    } else {
        pair[0].bound
    };
    Some((twist_rad, bound))
}

/// The bound of a difference: its minuend's, or the subtrahend's turned round; none if both are bounds.
fn difference_bound(minuend: Bound, subtrahend: Bound) -> Option<Bound> {
    match (minuend, subtrahend) {
        (bound, Bound::None) => Some(bound),
        (Bound::None, Bound::Lower) => Some(Bound::Upper),
        (Bound::None, Bound::Upper) => Some(Bound::Lower),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::design::Instrument;
    use crate::observation::{Place, TwistReading};

    fn profile(points: &[(f64, f64, Bound)]) -> TwistProfile {
        let reading = |&(r_m, twist_rad, bound): &(f64, f64, Bound)| TwistReading {
            place: Place::OnRequest,
            r_m,
            chord_m: 0.02,
            twist_rad,
            sigma_rad: None,
            bound,
            alpha_rad: None,
            le_deflection_m: 0.0,
            le_sweep_m: 0.0,
        };
        TwistProfile {
            readings: points.iter().map(reading).collect(),
            skipped: Vec::new(),
            instrument: Instrument::ChordRotation,
            camera_axis: None,
            root_angle_rad: None,
        }
    }

    #[test]
    fn the_rate_is_read_straight_between_stations() {
        let profile = profile(&[
            (0.0, 0.0, Bound::None),
            (0.02, 0.1, Bound::None),
            (0.06, 0.5, Bound::None),
        ]);
        let rate = mean_rate(&profile, 0.01, 0.04).unwrap();
        assert!((rate.rate_rad_per_m - (0.3 - 0.05) / 0.03).abs() < 1e-12);
        assert!(!rate.is_clipped);
    }

    #[test]
    fn an_end_beyond_the_last_station_is_clipped_and_says_so() {
        let profile = profile(&[(0.0, 0.0, Bound::None), (0.05, 0.5, Bound::None)]);
        let rate = mean_rate(&profile, 0.0, 0.07).unwrap();
        assert_eq!((rate.to_m, rate.is_clipped), (0.05, true));
        assert!((rate.rate_rad_per_m - 10.0).abs() < 1e-12);
        assert_eq!(mean_rate(&profile, 0.05, 0.07), None);
        assert_eq!(mean_rate(&profile, -0.01, 0.04), None);
    }

    #[test]
    fn a_bound_at_one_end_bounds_the_rate_and_bounds_at_both_ends_give_none() {
        let feathered = [
            (0.0, 0.0, Bound::None),
            (0.04, 0.6, Bound::Lower),
            (0.05, 0.7, Bound::Lower),
        ];
        let profile = profile(&feathered);
        assert_eq!(mean_rate(&profile, 0.0, 0.05).unwrap().bound, Bound::Lower);
        assert_eq!(mean_rate(&profile, 0.04, 0.05), None);
    }
}
