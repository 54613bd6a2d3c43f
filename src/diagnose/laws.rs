//! How a missing load grows with the motion: by powers of frequency and amplitude, or from an onset on; and what of that the data tell.
//!
//! More laws than [`super::fields`] weighs against the known effects: they are asked only once something without a name is there.
//! Powers and onsets are weighed jointly, so that a frequency and an amplitude that rise together in a campaign share their doubt.

use nalgebra::{DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::study::{Condition, Forward};

use super::data::Data;
use super::evidence::ln_sum;
use super::fields::{Driver, Field, Law, Places, power, smooth_root};

/// Largest power of frequency and of amplitude.
const HIGHEST: i32 = 4;
/// A power is told if its standard deviation is below this.
const TOLD: f64 = 0.7;
/// Prior share of the onsets among all laws of a load.
const ONSETS: f64 = 0.25;
/// Share of an alternative from which on it is worth a word.
const WORTH_A_WORD: f64 = 0.1;

/// Powers by which a missing load scales, or the onset from which on it grows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Scaling {
    /// Power of the frequency, with standard deviation.
    pub frequency: [f64; 2],
    /// Power of the amplitude, with standard deviation.
    pub amplitude: [f64; 2],
    /// Whether the data tell the power of the frequency.
    pub frequency_is_told: bool,
    /// Whether the data tell the power of the amplitude.
    pub amplitude_is_told: bool,
    /// An onset instead; none where the conditions have no two frequencies or amplitudes.
    pub onset: Option<Onset>,
}

/// A load that is nought up to an onset and grows in proportion beyond.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Onset {
    /// Probability of an onset rather than of powers.
    pub probability: f64,
    /// If so, that it is one in frequency.
    pub in_frequency: f64,
    /// Frequency of the onset with standard deviation, Hz.
    pub frequency_hz: Option<[f64; 2]>,
    /// Amplitude of the onset with standard deviation, deg.
    pub amplitude_deg: Option<[f64; 2]>,
}

/// A field for every law of a load that the conditions tell from the others.
pub fn load_laws(
    forward: &dyn Forward,
    data: &Data,
    moment: &DMatrix<f64>,
    value: &DVector<f64>,
) -> Vec<Field> {
    let conditions = forward.conditions();
    let root = smooth_root(moment.ncols());
    let places = Places::new(forward, data, value, moment.ncols());
    let response = moment.select_rows(data.rows.iter());
    let of_row = |row: usize| &conditions[forward.observables()[row].condition];
    let largest = |driver: Driver| {
        let values = data.rows.iter().filter_map(|&row| driver.of(of_row(row)));
        values.fold(f64::MIN_POSITIVE, f64::max)
    };
    let mut laws: Vec<Law> = (0..=HIGHEST)
        .flat_map(|a| (0..=HIGHEST).map(move |b| (a, b)))
        .map(|(a, b)| Law::Load {
            frequency_power: f64::from(a),
            amplitude_power: f64::from(b),
        })
        .collect();
    for driver in [Driver::Frequency, Driver::Amplitude] {
        let onsets = onsets(data.rows.iter().filter_map(|&row| driver.of(of_row(row))));
        laws.extend(onsets.into_iter().map(|from| Law::Onset { of: driver, from }));
    }
    let (f1, a1) = (largest(Driver::Frequency), largest(Driver::Amplitude));
    let factor = |law: Law, condition: &Condition| match law {
        Law::Load {
            frequency_power,
            amplitude_power,
        } => {
            power(condition.frequency_hz, f1, frequency_power as i32)
                * power(condition.half_amplitude_deg, a1, amplitude_power as i32)
        }
        Law::Onset { of, from } => {
            let over = of.of(condition).map_or(0.0, |value| (value - from).max(0.0));
            over / (largest(of) - from)
        }
        _ => 1.0,
    };
    let mut known: Vec<DVector<f64>> = Vec::new();
    let mut found = Vec::new();
    for law in laws {
        let factors = data.rows.iter().map(|&row| factor(law, of_row(row)));
        let factors = DVector::from_iterator(data.rows.len(), factors);
        if factors.amax() == 0.0 || known.iter().any(|other| (other - &factors).amax() < 1e-9) {
            continue;
        }
        let columns = DMatrix::from_diagonal(&factors) * &response * &root;
        found.extend(places.scaled(law, &columns, &root));
        known.push(factors);
    }
    found
}

/// Where a growth with these values may set in: at each but the largest, and half way to the next.
fn onsets(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * b.abs());
    let steps = values.windows(2);
    steps.flat_map(|w| [w[0], 0.5 * (w[0] + w[1])]).collect()
}

/// Prior share of `law` among those of `laws` that are loads.
pub fn share(law: Law, laws: &[Field]) -> f64 {
    let is_onset = |law: Law| matches!(law, Law::Onset { .. });
    let own = laws
        .iter()
        .filter(|field| is_onset(field.law) == is_onset(law))
        .count();
    let has_onsets = laws.iter().any(|field| is_onset(field.law));
    let group = match (is_onset(law), has_onsets) {
        (true, _) => ONSETS,
        (false, true) => 1.0 - ONSETS,
        (false, false) => 1.0,
    };
    group / own.max(1) as f64
}

/// Powers and onset by the probability of each law, `weights` its logarithm; none if the campaign has but one law.
pub fn scaling(weights: &[(Law, f64)]) -> Option<Scaling> {
    let mut powers: Vec<(f64, [f64; 2])> = Vec::new();
    let mut onsets: Vec<(f64, Driver, f64)> = Vec::new();
    for &(law, weight) in weights {
        match law {
            Law::Load {
                frequency_power,
                amplitude_power,
            } => powers.push((weight, [frequency_power, amplitude_power])),
            Law::Onset { of, from } => onsets.push((weight, of, from)),
            _ => {}
        }
    }
    if powers.len() + onsets.len() < 2 || powers.is_empty() {
        return None;
    }
    let of_powers = ln_sum(powers.iter().map(|law| law.0));
    // two powers a step of 1 apart: half a step is not told
    let [frequency, amplitude] = [0, 1].map(|k| {
        let shares = powers.iter().map(|law| ((law.0 - of_powers).exp(), law.1[k]));
        mean_and_deviation(shares, 1.0)
    });
    Some(Scaling {
        onset: onset(of_powers, &onsets),
        ..Scaling::of_powers(frequency, amplitude)
    })
}

fn onset(of_powers: f64, onsets: &[(f64, Driver, f64)]) -> Option<Onset> {
    let total = ln_sum(onsets.iter().map(|law| law.0));
    let of = |driver: Driver| {
        let own: Vec<(f64, f64)> = onsets
            .iter()
            .filter(|law| law.1 == driver)
            .map(|law| ((law.0 - total).exp(), law.2))
            .collect();
        let share: f64 = own.iter().map(|law| law.0).sum();
        let step = own
            .windows(2)
            .map(|w| (w[1].1 - w[0].1).abs())
            .fold(0.0, f64::max);
        let found = (share > 0.0).then(|| {
            let shares = own.iter().map(|law| (law.0 / share, law.1));
            mean_and_deviation(shares, step)
        });
        (share, found)
    };
    let (in_frequency, frequency_hz) = of(Driver::Frequency);
    let (_, amplitude_deg) = of(Driver::Amplitude);
    (!onsets.is_empty()).then(|| Onset {
        probability: 1.0 / (1.0 + (of_powers - total).exp()),
        in_frequency,
        frequency_hz,
        amplitude_deg,
    })
}

/// Of values with shares that sum to one, tried a step apart.
fn mean_and_deviation(shares: impl Iterator<Item = (f64, f64)> + Clone, step: f64) -> [f64; 2] {
    let mean: f64 = shares.clone().map(|(share, value)| share * value).sum();
    let variance: f64 = shares.map(|(share, value)| share * (value - mean).powi(2)).sum();
    [mean, (variance + step * step / 12.0).sqrt()]
}

impl Scaling {
    /// By powers, each with standard deviation.
    pub fn of_powers(frequency: [f64; 2], amplitude: [f64; 2]) -> Scaling {
        Scaling {
            frequency,
            amplitude,
            frequency_is_told: frequency[1] < TOLD,
            amplitude_is_told: amplitude[1] < TOLD,
            onset: None,
        }
    }

    /// How it grows, in words.
    pub fn words(&self, law: Law) -> String {
        match (law, self.onset) {
            (Law::Onset { of, from }, Some(onset)) => onset.words(of, from),
            _ => self.words_of_powers(),
        }
    }

    fn words_of_powers(&self) -> String {
        let ([a, da], [b, db]) = (self.frequency, self.amplitude);
        let power = |name: &str, [mean, error]: [f64; 2]| {
            let more = if mean > f64::from(HIGHEST) - 0.5 {
                " or more"
            } else {
                ""
            };
            format!("{name} to the power {mean:.1} ± {error:.1}{more}")
        };
        match (self.frequency_is_told, self.amplitude_is_told) {
            (true, true) => format!(
                "as {} and {}",
                power("frequency", self.frequency),
                power("amplitude", self.amplitude)
            ),
            (true, false) => format!(
                "as {}; how it grows with amplitude cannot be told",
                power("frequency", self.frequency)
            ),
            (false, true) => format!(
                "as {}; how it grows with frequency cannot be told",
                power("amplitude", self.amplitude)
            ),
            (false, false) => format!(
                "growing with the motion, but whether with frequency (power {a:.1} ± {da:.1}) or with amplitude (power {b:.1} ± {db:.1}) \
                 cannot be told"
            ),
        }
    }
}

impl Onset {
    /// Where it sets in, with standard deviation, Hz or deg.
    pub fn at(&self, of: Driver) -> Option<[f64; 2]> {
        match of {
            Driver::Frequency => self.frequency_hz,
            Driver::Amplitude => self.amplitude_deg,
        }
    }

    /// The other of both, and where it would set in there, if that explains the data nearly as well as an onset in `of`.
    pub fn rival(&self, of: Driver) -> Option<(Driver, [f64; 2])> {
        let (share, other) = match of {
            Driver::Frequency => (1.0 - self.in_frequency, Driver::Amplitude),
            Driver::Amplitude => (self.in_frequency, Driver::Frequency),
        };
        self.at(other)
            .filter(|_| share > WORTH_A_WORD)
            .map(|at| (other, at))
    }

    fn words(&self, of: Driver, from: f64) -> String {
        let place = |driver: Driver, [mean, error]: [f64; 2]| match driver {
            Driver::Frequency => format!("at {mean:.1} ± {error:.1} Hz"),
            Driver::Amplitude => format!("at an amplitude of {mean:.1} ± {error:.1}°"),
        };
        let first = place(of, self.at(of).unwrap_or([from, 0.0]));
        match self.rival(of) {
            Some((other, at)) => format!(
                "which sets in {first} and grows in proportion beyond (or {}: which of both, these data cannot tell)",
                place(other, at)
            ),
            None => format!("which sets in {first} and grows in proportion beyond"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn load(frequency_power: f64, amplitude_power: f64) -> Law {
        Law::Load {
            frequency_power,
            amplitude_power,
        }
    }

    #[test]
    fn powers_that_stand_for_each_other_are_not_told() {
        let alike: Vec<(Law, f64)> = (0..=4)
            .map(|a| (load(f64::from(a), f64::from(4 - a)), 0.0))
            .collect();
        let found = scaling(&alike).unwrap();
        assert!(!found.frequency_is_told && !found.amplitude_is_told, "{found:?}");
        assert!(found.words(load(2.0, 2.0)).contains("cannot be told"));
        let clear = [(load(1.0, 0.0), 0.0), (load(0.0, 1.0), -9.0)];
        let found = scaling(&clear).unwrap();
        assert!(found.frequency_is_told && found.amplitude_is_told, "{found:?}");
        assert_eq!(
            found.words(load(1.0, 0.0)),
            "as frequency to the power 1.0 ± 0.3 and amplitude to the power 0.0 ± 0.3"
        );
        let at_the_end = [(load(4.0, 0.0), 0.0), (load(0.0, 0.0), -9.0)];
        assert!(
            scaling(&at_the_end)
                .unwrap()
                .words(load(4.0, 0.0))
                .contains("4.0 ± 0.3 or more")
        );
    }

    #[test]
    fn an_onset_in_one_of_two_that_rise_together_is_told_as_either() {
        let onset = |of, from| Law::Onset { of, from };
        let laws = [
            (load(4.0, 4.0), -5.0),
            (onset(Driver::Frequency, 18.0), -3.0),
            (onset(Driver::Frequency, 20.5), 0.0),
            (onset(Driver::Amplitude, 32.25), -0.1),
        ];
        let found = scaling(&laws).unwrap();
        let found_onset = found.onset.unwrap();
        assert!(found_onset.probability > 0.9 && (found_onset.in_frequency - 0.5).abs() < 0.1);
        let words = found.words(onset(Driver::Frequency, 20.5));
        assert!(
            words.starts_with("which sets in at 20.4 ± 0.9 Hz")
                && words.contains("(or at an amplitude of 32.2"),
            "{words}"
        );
    }

    #[test]
    fn onsets_lie_at_every_value_but_the_largest_and_between() {
        assert_eq!(
            onsets([26.0, 18.0, 23.0, 18.0].into_iter()),
            [18.0, 20.5, 23.0, 24.5]
        );
        assert!(onsets([20.0].into_iter()).is_empty());
    }
}
