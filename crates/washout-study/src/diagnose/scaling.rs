//! What the data tell of how a missing load grows: its powers of frequency and amplitude, or where it sets in, and what of that they do not tell.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::evidence::ln_sum;
use super::fields::{Driver, Law};
use super::laws::{HIGHEST, LoadLaw};

/// A power is told if its standard deviation is below this.
const TOLD: f64 = 0.7;
/// Share of an alternative from which on it is worth a word.
const WORTH_A_WORD: f64 = 0.1;

/// Powers by which a missing load scales, if it does by powers, and the onset from which on it grows, if it has one.
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

/// Powers and onset by the probability of each law, with its logarithm; none if the campaign has but one law.
pub fn scaling(weights: &[(LoadLaw, f64)]) -> Option<Scaling> {
    let mut powers: Vec<(f64, [f64; 2])> = Vec::new();
    let mut onsets: Vec<(f64, Driver, LoadLaw, f64)> = Vec::new();
    for &(own, weight) in weights {
        match own.law {
            Law::Load {
                frequency_power,
                amplitude_power,
            } => powers.push((weight, [frequency_power, amplitude_power])),
            Law::Onset { of, from } => onsets.push((weight, of, own, from)),
            Law::Free | Law::Spring | Law::Compliance | Law::Sensor => {}
        }
    }
    if powers.len() < 2 {
        return None;
    }
    let of_powers = ln_sum(powers.iter().map(|law| law.0));
    let [frequency, amplitude] = [0, 1].map(|k| {
        let shares = powers.iter().map(|law| {
            let share = (law.0 - of_powers).exp();
            (share, law.1[k], 1.0)
        });
        mean_and_deviation(shares)
    });
    let of_onsets = ln_sum(onsets.iter().map(|law| law.0));
    let at = |driver: Driver| {
        let own = onsets.iter().filter(|law| law.1 == driver);
        let own: Vec<(f64, f64, f64)> = own
            .map(|law| ((law.0 - of_onsets).exp(), law.3, law.2.width))
            .collect();
        let share: f64 = own.iter().map(|law| law.0).sum();
        let shares = own.iter().map(|law| (law.0 / share, law.1, law.2));
        (share, (share > 0.0).then(|| mean_and_deviation(shares)))
    };
    let (in_frequency, frequency_hz) = at(Driver::Frequency);
    let (_, amplitude_deg) = at(Driver::Amplitude);
    let onset = (!onsets.is_empty()).then(|| Onset {
        probability: 1.0 / (1.0 + (of_powers - of_onsets).exp()),
        in_frequency,
        frequency_hz,
        amplitude_deg,
    });
    Some(Scaling {
        onset,
        ..Scaling::of_powers(frequency, amplitude)
    })
}

/// Of values with shares that sum to one, each evenly over a width.
fn mean_and_deviation(shares: impl Iterator<Item = (f64, f64, f64)> + Clone) -> [f64; 2] {
    let mean: f64 = shares.clone().map(|(share, value, _)| share * value).sum();
    let variance: f64 = shares
        .map(|(share, value, width)| share * ((value - mean).powi(2) + width * width / 12.0))
        .sum();
    [mean, variance.sqrt()]
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

    /// Whether an onset is more probable than powers.
    pub fn is_onset(&self) -> bool {
        self.onset.is_some_and(|onset| onset.probability > 0.5)
    }

    /// How it grows, in words; `law`: the best of the more probable kind.
    pub fn words(&self, law: Law) -> String {
        match (law, self.onset) {
            (Law::Onset { .. }, Some(onset)) => {
                let rest = match 1.0 - onset.probability > WORTH_A_WORD {
                    true => format!("; or it grows {}", self.words_of_powers()),
                    false => String::new(),
                };
                format!("which {}{rest}", onset.words())
            }
            (_, Some(onset)) if onset.probability > WORTH_A_WORD => {
                format!("{}; or it {}", self.words_of_powers(), onset.words())
            }
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
                "as the motion, but whether as frequency (to the power {a:.1} ± {da:.1}) or as amplitude (to the power {b:.1} ± {db:.1}) \
                 cannot be told"
            ),
        }
    }
}

impl Onset {
    /// In which it is more probable.
    pub fn likelier(&self) -> Driver {
        match self.in_frequency >= 0.5 {
            true => Driver::Frequency,
            false => Driver::Amplitude,
        }
    }

    /// The law with it in that.
    pub fn law(&self) -> Law {
        let of = self.likelier();
        let from = self.at(of).map_or(0.0, |[mean, _]| mean);
        Law::Onset { of, from }
    }

    /// Where it sets in, with standard deviation, Hz or deg.
    pub fn at(&self, of: Driver) -> Option<[f64; 2]> {
        match of {
            Driver::Frequency => self.frequency_hz,
            Driver::Amplitude => self.amplitude_deg,
        }
    }

    /// The less probable of both, and where it would set in there, if that explains the data nearly as well.
    pub fn rival(&self) -> Option<(Driver, [f64; 2])> {
        let (share, other) = match self.likelier() {
            Driver::Frequency => (1.0 - self.in_frequency, Driver::Amplitude),
            Driver::Amplitude => (self.in_frequency, Driver::Frequency),
        };
        self.at(other)
            .filter(|_| share > WORTH_A_WORD)
            .map(|at| (other, at))
    }

    fn words(&self) -> String {
        let place = |driver: Driver, [mean, error]: [f64; 2]| match driver {
            Driver::Frequency => format!("at {mean:.1} ± {error:.1} Hz"),
            Driver::Amplitude => format!("at an amplitude of {mean:.1} ± {error:.1}°"),
        };
        let of = self.likelier();
        let first = self
            .at(of)
            .map_or_else(|| "somewhere".to_string(), |at| place(of, at));
        let rest = self.rival().map_or_else(String::new, |(other, at)| {
            format!(
                " (or {}: which of both, these data cannot tell)",
                place(other, at)
            )
        });
        format!("sets in {first} and grows in proportion beyond{rest}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::fields::distinct;
    use crate::diagnose::laws::laws;
    use crate::study::Condition;

    fn load(frequency_power: f64, amplitude_power: f64) -> LoadLaw {
        LoadLaw {
            law: Law::Load {
                frequency_power,
                amplitude_power,
            },
            share: 0.1,
            width: 1.0,
        }
    }

    #[test]
    fn powers_that_stand_for_each_other_are_not_told() {
        let alike: Vec<(LoadLaw, f64)> = (0..=4)
            .map(|a| (load(f64::from(a), f64::from(4 - a)), 0.0))
            .collect();
        let found = scaling(&alike).unwrap();
        assert!(!found.frequency_is_told && !found.amplitude_is_told, "{found:?}");
        assert!(found.words(load(2.0, 2.0).law).contains("cannot be told"));
        let clear = [(load(1.0, 0.0), 0.0), (load(0.0, 1.0), -9.0)];
        let found = scaling(&clear).unwrap();
        assert!(found.frequency_is_told && found.amplitude_is_told, "{found:?}");
        assert_eq!(
            found.words(load(1.0, 0.0).law),
            "as frequency to the power 1.0 ± 0.3 and amplitude to the power 0.0 ± 0.3"
        );
        let at_the_end = [(load(4.0, 0.0), 0.0), (load(0.0, 0.0), -9.0)];
        let words = scaling(&at_the_end).unwrap().words(load(4.0, 0.0).law);
        assert!(words.contains("4.0 ± 0.3 or more"), "{words}");
    }

    #[test]
    fn the_less_probable_kind_of_growth_is_told_where_it_is_worth_a_word() {
        let onset = LoadLaw {
            law: Law::Onset {
                of: Driver::Frequency,
                from: 20.0,
            },
            share: 0.1,
            width: 1.0,
        };
        let words = |of_onset: f64| {
            let laws = [
                (load(2.0, 0.0), (1.0 - of_onset).ln()),
                (load(0.0, 0.0), -50.0),
                (onset, of_onset.ln()),
            ];
            let found = scaling(&laws).unwrap();
            let best = if found.is_onset() {
                onset.law
            } else {
                load(2.0, 0.0).law
            };
            found.words(best)
        };
        assert!(words(0.05).starts_with("as frequency to the power 2.0") && !words(0.05).contains("sets in"));
        assert!(
            words(0.3).starts_with("as frequency") && words(0.3).contains("; or it sets in at 20.0 ± 0.3 Hz")
        );
        assert!(
            words(0.7).starts_with("which sets in at 20.0")
                && words(0.7).contains("; or it grows as frequency")
        );
        assert!(!words(0.95).contains("; or"), "{}", words(0.95));
    }

    /// All laws with the weights that they have where only the largest of three motions shows the load.
    fn told(f: &[f64], phi: &[f64], seen: [f64; 3]) -> Scaling {
        let last = |values: &[f64]| values[values.len() - 1];
        let factor = |law: Law, k: usize| {
            let at = |values: &[f64]| Some(values[k.min(values.len() - 1)]);
            let condition = Condition {
                name: String::new(),
                wing: String::new(),
                is_held_out: false,
                frequency_hz: at(f),
                half_amplitude_deg: at(phi),
                dynamic_pressure_pa: 1.0,
                length_m: 0.07,
            };
            law.factor(&condition, last(f), last(phi))
        };
        let weight = |own: &LoadLaw| {
            let misfit: f64 = (0..3)
                .map(|k| ((factor(own.law, k) - seen[k]) / 0.02).powi(2))
                .sum();
            own.share.ln() - 0.5 * misfit
        };
        let all = laws(&distinct(f.iter().copied()), &distinct(phi.iter().copied()));
        let weights: Vec<(LoadLaw, f64)> = all.iter().map(|own| (*own, weight(own))).collect();
        scaling(&weights).unwrap()
    }

    #[test]
    fn an_onset_between_the_two_hardest_flights_is_told_as_lying_there_in_either() {
        let found = told(&[18.0, 23.0, 26.0], &[30.0, 34.5, 40.0], [0.0, 0.0, 1.0]);
        let onset = found.onset.unwrap();
        assert!(
            onset.probability > 0.99 && (onset.in_frequency - 0.5).abs() < 0.2,
            "{onset:?}"
        );
        let [[f, df], [phi, dphi]] = [onset.frequency_hz.unwrap(), onset.amplitude_deg.unwrap()];
        assert!(
            (f - 24.5).abs() < 0.1 && (df - 3.0 / 12f64.sqrt()).abs() < 0.1,
            "{f} {df}"
        );
        assert!(
            (phi - 37.25).abs() < 0.1 && (dphi - 5.5 / 12f64.sqrt()).abs() < 0.1,
            "{phi} {dphi}"
        );
        let words = found.words(Law::Onset {
            of: Driver::Frequency,
            from: 24.5,
        });
        assert!(
            words.contains("24.5 ± 0.9 Hz") && words.contains("which of both, these data cannot tell"),
            "{words}"
        );
    }

    #[test]
    fn the_power_of_an_amplitude_that_never_changes_is_not_told() {
        let seen = [18.0, 23.0, 26.0].map(|f: f64| (f / 26.0).powi(2));
        let found = told(&[18.0, 23.0, 26.0], &[30.0], seen);
        assert!(found.frequency_is_told && !found.amplitude_is_told, "{found:?}");
        assert!((found.frequency[0] - 2.0).abs() < 0.2 && (found.amplitude[0] - 2.0).abs() < 0.1);
    }
}
