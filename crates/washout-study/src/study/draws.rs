//! Random numbers by counting: any of them can be had without the others, so threads do not matter.

use statrs::distribution::{ContinuousCDF, Normal};

/// A sequence of streams of random numbers.
#[derive(Debug, Clone, Copy)]
pub struct Draws {
    seed: u64,
}

impl Draws {
    /// Streams of `seed`.
    pub fn new(seed: u64) -> Draws {
        Draws { seed: mix(seed) }
    }

    /// Number `index` of stream `stream`, even in (0, 1).
    pub fn uniform(&self, stream: u64, index: u64) -> f64 {
        let bits = mix(self.seed ^ mix(mix(stream).wrapping_add(index)));
        ((bits >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    /// Number `index` of stream `stream`, from the normal distribution of mean 0 and variance 1.
    pub fn normal(&self, stream: u64, index: u64) -> f64 {
        Normal::standard().inverse_cdf(self.uniform(stream, index))
    }

    /// Sum of the squares of `freedom` normal numbers of the stream, from `first` on.
    pub fn chi_squared(&self, stream: u64, first: u64, freedom: usize) -> f64 {
        (0..freedom as u64)
            .map(|index| self.normal(stream, first + index).powi(2))
            .sum()
    }
}

/// Finalizer of SplitMix64 (Steele, Lea & Flood, OOPSLA 2014), after its increment.
fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_normal_distribution_within_and_across_streams() {
        let draws = Draws::new(3);
        for across in [false, true] {
            let sample: Vec<f64> = (0..20_000)
                .map(|i| {
                    if across {
                        draws.normal(i, 5)
                    } else {
                        draws.normal(5, i)
                    }
                })
                .collect();
            let moment = |power: i32| sample.iter().map(|x| x.powi(power)).sum::<f64>() / 20_000.0;
            assert!(
                moment(1).abs() < 0.02 && (moment(2) - 1.0).abs() < 0.04,
                "{across}"
            );
            assert!(
                moment(3).abs() < 0.1 && (moment(4) - 3.0).abs() < 0.25,
                "{across}"
            );
            let lagged: f64 = sample.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>() / 20_000.0;
            assert!(lagged.abs() < 0.02, "{across}");
        }
        let mean = (0..2000).map(|i| draws.chi_squared(i, 0, 5)).sum::<f64>() / 2000.0;
        assert!((mean - 5.0).abs() < 0.25, "{mean}");
    }
}
