//! What a fit is worth where the standard deviation of the readings is not known.

use crate::input::measurement::{Channel, SigmaKind};
use crate::study::Observable;

/// Spread of ln κ, the factor on the standard deviations of one instrument: of repeats, as stated (as if from five numbers), assumed.
const SPREADS: [f64; 3] = [0.2, 0.32, 0.5];
/// Half of the values of κ on either side of 1.
const STEPS: i32 = 4;
/// Spreads to which κ goes.
const WIDE: f64 = 2.0;
/// Probability that all readings of a study lie within the distance that counts as reached, by scatter alone.
const REACHED: f64 = 0.95;

/// The scatter of the readings of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Scatter {
    groups: Vec<Group>,
}

/// Readings of one instrument.
#[derive(Debug, Clone, PartialEq)]
struct Group {
    /// Positions among the readings.
    rows: Vec<usize>,
    class: (u8, u8),
    /// Values of 1/κ² with ln(weight κ⁻ⁿ), for n readings that count.
    values: Vec<(f64, f64)>,
    /// The same sum without any misfit.
    least: f64,
}

impl Scatter {
    /// Of the fitted readings, whose standard deviations come from `kinds`.
    pub fn new(readings: &[&Observable], kinds: &[SigmaKind]) -> Scatter {
        let mut groups: Vec<Group> = Vec::new();
        for (row, (reading, &kind)) in readings.iter().zip(kinds).enumerate() {
            let class = (instrument(reading.channel), spread(kind).1);
            match groups.iter_mut().find(|group| group.class == class) {
                Some(group) => group.rows.push(row),
                None => groups.push(Group {
                    rows: vec![row],
                    class,
                    values: Vec::new(),
                    least: spread(kind).0,
                }),
            }
        }
        for group in &mut groups {
            let spread = group.least;
            let count = group.rows.len() as f64;
            let value = |step: i32| {
                let z = WIDE * f64::from(step) / f64::from(STEPS);
                let ln_factor = spread * z;
                ((-2.0 * ln_factor).exp(), -0.5 * z * z - count * ln_factor)
            };
            group.values = (-STEPS..=STEPS).map(value).collect();
            group.least = group.ln_sum(0.0);
        }
        Scatter { groups }
    }

    /// −2 ln of the probability of these misfits, over that of none; `misfits` in standard deviations, `factor` on these.
    pub fn cost(&self, misfits: &[f64], factor: f64) -> f64 {
        let of = |group: &Group| {
            let squares: f64 = group
                .rows
                .iter()
                .map(|&row| (misfits[row] / factor).powi(2))
                .sum();
            -2.0 * (group.ln_sum(squares) - group.least)
        };
        self.groups.iter().map(of).sum()
    }
}

impl Group {
    /// ln Σ w κ⁻ⁿ exp(−squares/(2κ²)).
    fn ln_sum(&self, squares: f64) -> f64 {
        let terms = || {
            self.values
                .iter()
                .map(|(inverse, ln)| ln - 0.5 * inverse * squares)
        };
        let most = terms().fold(f64::NEG_INFINITY, f64::max);
        most + terms().map(|own| (own - most).exp()).sum::<f64>().ln()
    }
}

/// The distance within which all of `count` readings lie by scatter alone in 95 of 100 campaigns, in standard deviations.
pub fn reach(count: usize) -> f64 {
    use statrs::distribution::{ContinuousCDF, Normal};
    let each = REACHED.powf((count.max(1) as f64).recip());
    Normal::standard().inverse_cdf(0.5 * (1.0 + each))
}

/// Spread of ln κ, and which it is.
fn spread(kind: SigmaKind) -> (f64, u8) {
    let place = match kind {
        SigmaKind::Repeats => 0,
        SigmaKind::Stated => 1,
        SigmaKind::Assumed => 2,
    };
    (SPREADS[place], place as u8)
}

/// Channels of one instrument share their factor.
fn instrument(channel: Channel) -> u8 {
    match channel {
        Channel::Twist | Channel::TwistRate => 0,
        Channel::Deflection | Channel::ChordwiseDisplacement | Channel::SpanwiseDisplacement => 1,
        Channel::Lift | Channel::Drag | Channel::Power => 2,
        Channel::LiftRatio | Channel::DragRatio | Channel::EfficiencyRatio | Channel::EffectiveLiftRatio => 3,
        Channel::Frequency => 4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Bound;

    fn reading(channel: Channel) -> Observable {
        Observable {
            condition: 0,
            line: 1,
            channel,
            run: String::new(),
            r_mm: None,
            r_to_mm: None,
            value: 0.0,
            sigma: 1.0,
            bound: Bound::None,
        }
    }

    #[test]
    fn a_sigma_that_is_assumed_forgives_more_than_one_from_repeats_and_no_misfit_costs_nothing() {
        let readings = vec![reading(Channel::Twist); 5];
        let readings: Vec<&Observable> = readings.iter().collect();
        let cost = |kind: SigmaKind, misfit: f64, factor: f64| {
            Scatter::new(&readings, &[kind; 5]).cost(&[misfit; 5], factor)
        };
        for kind in [SigmaKind::Repeats, SigmaKind::Stated, SigmaKind::Assumed] {
            assert_eq!(cost(kind, 0.0, 1.0), 0.0);
            assert!(cost(kind, 3.0, 2.0) < cost(kind, 3.0, 1.0));
        }
        // chi-square would be 45
        let [repeats, stated, assumed] =
            [SigmaKind::Repeats, SigmaKind::Stated, SigmaKind::Assumed].map(|kind| cost(kind, 3.0, 1.0));
        assert!(
            assumed < stated && stated < repeats && repeats < 45.0,
            "{assumed} {stated} {repeats}"
        );
        assert!(assumed > 10.0, "{assumed}");
    }

    #[test]
    fn instruments_have_factors_of_their_own() {
        let all = [
            reading(Channel::Twist),
            reading(Channel::TwistRate),
            reading(Channel::Lift),
        ];
        let all: Vec<&Observable> = all.iter().collect();
        let scatter = Scatter::new(&all, &[SigmaKind::Assumed; 3]);
        assert_eq!(scatter.groups.len(), 2);
    }

    #[test]
    fn reach_is_wider_for_more_readings() {
        assert!(
            (reach(1) - 1.96).abs() < 0.01
                && (reach(5) - 2.57).abs() < 0.01
                && (reach(9) - 2.77).abs() < 0.01
        );
    }
}
