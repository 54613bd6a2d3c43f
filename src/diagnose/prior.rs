//! What is known of a strength before the data: its sign, and the sizes that its card calls plausible.

use statrs::distribution::{ContinuousCDF, Normal};

use crate::study::{Unknown, UnknownKind};

/// Probability before the data that an effect is stronger than its card calls plausible.
const BEYOND: f64 = 0.02;

/// A strength within this many standard errors of zero is as good as nothing.
pub const NOTHING: f64 = 2.0;

/// A plausible size this near to the end of what is accepted, over the largest plausible one, is as large as it can be.
const NEAR: f64 = 0.1;

/// All strengths.
const ANYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// From so many standard errors below none on, what is left above it is exponential.
const FAR: f64 = -8.0;

/// Prior of the strength of an effect, in the standard deviations by which it is fitted: what a fit weighs it by is normal about none, of
/// one sign if it has one; of that, all but one part in fifty lies within what is plausible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrengthPrior {
    /// Plausible strengths.
    pub plausible: [f64; 2],
    /// Whether it can have one sign only.
    pub is_one_sided: bool,
}

impl StrengthPrior {
    /// Of an unknown; none if it is not the strength of an effect.
    pub fn of(unknown: &Unknown) -> Option<StrengthPrior> {
        match unknown.kind {
            UnknownKind::Effect {
                plausible: [least, most],
                one_sided,
                scale,
                ..
            } => {
                // what saturates has its largest size wherever the range ends
                let [low, high] = unknown.range;
                let open = |end: f64, range: f64| match (end - range).abs() <= NEAR * scale {
                    true => range.signum() * f64::INFINITY,
                    false => end / unknown.sigma,
                };
                let least = if one_sided { 0.0 } else { open(least, low) };
                Some(StrengthPrior {
                    plausible: [least, open(most, high)],
                    is_one_sided: one_sided,
                })
            }
            _ => None,
        }
    }

    /// The same along a step in one direction, which is taken as a sign.
    pub fn toward(self, step: f64) -> StrengthPrior {
        let [low, high] = self.plausible;
        StrengthPrior {
            plausible: if step < 0.0 { [-high, -low] } else { [low, high] },
            is_one_sided: true,
        }
    }

    /// Share of what the prior and the data leave of a strength, `estimate` ± `error`, that is not as good as nothing.
    pub fn share_told(&self, estimate: f64, error: f64) -> f64 {
        if self.is_one_sided && estimate < FAR * error {
            return 0.0;
        }
        let none = NOTHING * error;
        let told = 1.0 - self.mass([-none, none], estimate, error) / self.mass(ANYWHERE, estimate, error);
        told.clamp(0.0, 1.0)
    }

    /// Integral of the prior over the normal one of both signs, times what the data leave, over the strengths between two ends.
    fn mass(&self, [from, to]: [f64; 2], estimate: f64, error: f64) -> f64 {
        let normal = Normal::standard();
        let none = if self.is_one_sided { 0.0 } else { f64::NEG_INFINITY };
        let below = |end: f64| normal.cdf((end - estimate) / error);
        let between = |low: f64, high: f64| {
            let (low, high) = (low.max(from).max(none), high.min(to));
            if high > low { below(high) - below(low) } else { 0.0 }
        };
        let signs = if self.is_one_sided { 2.0 } else { 1.0 };
        let [low, high] = self.plausible;
        BEYOND * signs * between(f64::NEG_INFINITY, f64::INFINITY) + self.density() * between(low, high)
    }

    /// Prior of plausible strengths over the normal one of both signs; none where nothing is plausible.
    fn density(&self) -> f64 {
        let normal = Normal::standard();
        let [low, high] = self.inside();
        let before = normal.cdf(high) - normal.cdf(low);
        if before > 0.0 {
            (1.0 - BEYOND) / before
        } else {
            0.0
        }
    }

    /// Plausible strengths of the sign that it can have.
    fn inside(&self) -> [f64; 2] {
        let [low, high] = self.plausible;
        [if self.is_one_sided { low.max(0.0) } else { low }, high]
    }

    /// What it adds to the logarithm of the evidence of a fit that took a normal prior of both signs, if the data and that leave the
    /// strength at `estimate` ± `error`.
    pub fn ln_factor(&self, estimate: f64, error: f64) -> f64 {
        let t = estimate / error;
        if self.is_one_sided && t < FAR {
            // Φ(t) ≈ φ(t)/|t|, and beyond none it falls like exp(−|t| ψ/error)
            let sign = -0.5 * t * t - (-t).ln() - 0.5 * (2.0 * std::f64::consts::PI).ln();
            let [low, high] = self.inside();
            let share = (t * low / error).exp() - (t * high / error).exp();
            return sign + (2.0 * BEYOND + self.density() * share).ln();
        }
        self.mass(ANYWHERE, estimate, error).ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same by adding up over the strength.
    fn by_sum(prior: StrengthPrior, estimate: f64, error: f64) -> f64 {
        let normal = |x: f64| (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt();
        let [low, high] = prior.plausible;
        let is_inside = |x: f64| x >= low && x <= high && (!prior.is_one_sided || x >= 0.0);
        let step = 1e-4;
        let all: Vec<f64> = (-100_000..100_000).map(|k| (f64::from(k) + 0.5) * step).collect();
        let before: f64 = all
            .iter()
            .filter(|x| is_inside(**x))
            .map(|x| normal(*x) * step)
            .sum();
        let factor = |x: f64| {
            let anywhere = match (prior.is_one_sided, x > 0.0) {
                (true, true) => 2.0,
                (true, false) => 0.0,
                (false, _) => 1.0,
            };
            BEYOND * anywhere
                + if is_inside(x) {
                    (1.0 - BEYOND) / before
                } else {
                    0.0
                }
        };
        let sum: f64 = all
            .iter()
            .map(|&x| factor(x) * normal((x - estimate) / error) / error * step)
            .sum();
        sum.ln()
    }

    #[test]
    fn the_factor_is_the_mean_of_the_prior_over_the_normal_one_under_what_the_data_leave() {
        let two = StrengthPrior {
            plausible: [-0.4, 0.667],
            is_one_sided: false,
        };
        let one = StrengthPrior {
            plausible: [0.0, 0.667],
            is_one_sided: true,
        };
        for (prior, estimate, error) in [
            (two, 0.3, 0.1),
            (two, 0.8, 0.1),
            (two, -1.5, 0.3),
            (one, 0.5, 0.2),
            (one, 1.4, 0.1),
            (one, -0.6, 0.1),
            (one, -0.5, 0.2),
            (one, -0.9, 0.1),
        ] {
            let (found, sum) = (prior.ln_factor(estimate, error), by_sum(prior, estimate, error));
            let tolerance = if estimate / error < FAR { 0.03 } else { 1e-3 };
            assert!(
                (found - sum).abs() < tolerance,
                "{prior:?} {estimate} {error}: {found} {sum}"
            );
        }
    }

    #[test]
    fn a_strength_is_told_by_as_much_as_lies_beyond_two_errors_from_none() {
        let of = |is_one_sided| StrengthPrior {
            plausible: [-5.0, 5.0],
            is_one_sided,
        };
        // Φ(−2) = 0.02275 on either side; at three errors Φ(1) = 0.8413
        for is_one_sided in [true, false] {
            let told = of(is_one_sided).share_told(0.0, 0.1);
            assert!((told - 0.0455).abs() < 1e-4, "{told}");
            let told = of(is_one_sided).share_told(0.3, 0.1);
            assert!((told - 0.8413).abs() < 2e-3, "{told}");
        }
        assert!(of(true).share_told(-0.5, 0.1) < 1e-3 && of(true).share_told(-2.0, 0.1) == 0.0);
        assert!(of(false).share_told(-0.5, 0.1) > 0.99);
        // what is implausible beyond two errors is not told by the tail that it has there
        let small = StrengthPrior {
            plausible: [0.0, 0.15],
            is_one_sided: true,
        };
        assert!(
            small.share_told(0.1, 0.1) < 0.02,
            "{}",
            small.share_told(0.1, 0.1)
        );
    }

    #[test]
    fn what_the_data_leave_open_keeps_its_evidence() {
        for is_one_sided in [true, false] {
            let prior = StrengthPrior {
                plausible: [0.0, 0.667],
                is_one_sided,
            };
            assert!(prior.ln_factor(0.0, 1.0).abs() < 1e-9, "{prior:?}");
        }
    }

    #[test]
    fn what_cannot_be_larger_is_as_plausible_at_its_end_as_anywhere() {
        let prior = StrengthPrior {
            plausible: [0.0, f64::INFINITY],
            is_one_sided: true,
        };
        for strength in [0.5, 3.0] {
            assert!((prior.ln_factor(strength, 0.01) - 2.0f64.ln()).abs() < 1e-9);
        }
        assert!(prior.ln_factor(-0.9, 0.1).is_finite());
    }

    #[test]
    fn a_strength_beyond_what_is_plausible_costs_as_much_as_that_is_rare() {
        let prior = StrengthPrior {
            plausible: [-0.667, 0.667],
            is_one_sided: false,
        };
        assert!((prior.ln_factor(2.0, 0.1) - BEYOND.ln()).abs() < 1e-6);
        assert!(prior.ln_factor(0.3, 0.1) > 0.6);
        let never = StrengthPrior {
            plausible: [0.0, 0.667],
            ..prior
        }
        .toward(-1.0);
        assert!((never.ln_factor(0.5, 0.1) - (2.0 * BEYOND).ln()).abs() < 1e-6);
    }
}
