//! Evidence: how probable the data are under a hypothesis, its strengths integrated over their priors.
//!
//! With all unknowns in prior standard deviations and whitened slopes J, ln Z = −½ ln|I + JᵀJ| − ½ Q (Laplace). If the
//! scale of the noise is not known but trusted like ν₀ numbers, −½ Q becomes −½ (n + ν₀) ln(1 + Q/ν₀).

use nalgebra::{DMatrix, DVector};

use super::settings::Settings;

/// How the noise enters the evidence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Likelihood {
    /// Measured numbers.
    pub numbers: usize,
    /// Numbers that the stated noise is worth; none if its scale is known.
    pub trust: Option<f64>,
}

impl Likelihood {
    /// For so many numbers under the settings.
    pub fn of(numbers: usize, settings: &Settings) -> Likelihood {
        Likelihood {
            numbers,
            trust: settings
                .noise_scale
                .is_none()
                .then_some(settings.noise_trust as f64),
        }
    }

    /// Logarithm of the likelihood for a least Q, up to a constant.
    pub fn ln(&self, q: f64) -> f64 {
        match self.trust {
            None => -0.5 * q,
            Some(trust) => -0.5 * (self.numbers as f64 + trust) * (q / trust).ln_1p(),
        }
    }

    /// Variance of the noise, in units of what was assumed, after a fit with Q.
    pub fn variance(&self, q: f64) -> f64 {
        match self.trust {
            None => 1.0,
            Some(trust) => (trust + q) / (trust + self.numbers as f64),
        }
    }
}

/// A linear field `a` X v with v ~ N(0, I): evidence against none, by the singular value decomposition of X.
#[derive(Debug, Clone)]
pub struct Spectrum {
    /// Left singular vectors times the residual.
    projected: DVector<f64>,
    /// Squares of the singular values.
    squares: DVector<f64>,
}

impl Spectrum {
    /// Of a field with columns `x` seen in `residual`.
    pub fn new(x: &DMatrix<f64>, residual: &DVector<f64>) -> Spectrum {
        let gram = if x.ncols() <= x.nrows() {
            x.transpose() * x
        } else {
            x * x.transpose()
        };
        let eigen = gram.symmetric_eigen();
        let squares = eigen.eigenvalues.map(|value| value.max(0.0));
        let largest = squares.max().max(f64::MIN_POSITIVE);
        let projected = if x.ncols() <= x.nrows() {
            let dots = eigen.eigenvectors.transpose() * (x.transpose() * residual);
            dots.zip_map(&squares, |dot, square| {
                if square > 1e-12 * largest {
                    dot / square.sqrt()
                } else {
                    0.0
                }
            })
        } else {
            eigen.eigenvectors.transpose() * residual
        };
        Spectrum { projected, squares }
    }

    /// ln Z of the field with amplitude `a` minus that without it, and its least Q.
    pub fn ln_gain(&self, likelihood: Likelihood, q0: f64, amplitude: f64) -> (f64, f64) {
        let (mut q, mut ln_determinant) = (q0, 0.0);
        for (dot, square) in self.projected.iter().zip(self.squares.iter()) {
            let gain = amplitude * amplitude * square;
            q -= dot * dot * gain / (1.0 + gain);
            ln_determinant += gain.ln_1p();
        }
        let q = q.max(0.0);
        (-0.5 * ln_determinant + likelihood.ln(q) - likelihood.ln(q0), q)
    }
}

/// ln Σ exp(x): of nothing, −∞.
pub fn ln_sum(terms: impl Iterator<Item = f64> + Clone) -> f64 {
    let largest = terms.clone().fold(f64::NEG_INFINITY, f64::max);
    if largest == f64::NEG_INFINITY {
        return largest;
    }
    largest + terms.map(|term| (term - largest).exp()).sum::<f64>().ln()
}

/// Where the largest of some values stands; none of none.
pub fn place_of_largest(values: &[f64]) -> Option<usize> {
    (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const KNOWN: Likelihood = Likelihood {
        numbers: 3,
        trust: None,
    };

    fn gaussian(residual: &DVector<f64>, columns: &DMatrix<f64>) -> f64 {
        let covariance = DMatrix::identity(3, 3) + columns * columns.transpose();
        let q = residual.dot(&covariance.clone().cholesky().unwrap().solve(residual));
        -0.5 * covariance.determinant().ln() - 0.5 * q
    }

    #[test]
    fn closed_forms_agree_with_the_gaussian_density() {
        let residual = DVector::from_vec(vec![1.0, -2.0, 0.5]);
        let columns = DMatrix::from_row_slice(3, 2, &[0.3, 1.0, -2.0, 0.2, 0.7, 0.1]);
        let none = gaussian(&residual, &DMatrix::zeros(3, 1));
        let q0 = residual.norm_squared();
        for x in [
            columns.clone(),
            DMatrix::from_fn(3, 5, |i, j| (i as f64 - 1.2) * (j as f64 + 0.3).sin()),
        ] {
            let (field, _) = Spectrum::new(&x, &residual).ln_gain(KNOWN, q0, 0.5);
            assert!((field - (gaussian(&residual, &(&x * 0.5)) - none)).abs() < 1e-10);
        }
    }

    #[test]
    fn an_unknown_scale_of_noise_is_the_average_over_scales() {
        // Student's density: Q far beyond n costs its logarithm, not itself
        let unknown = Likelihood {
            numbers: 50,
            trust: Some(5.0),
        };
        let slope = (unknown.ln(50.5) - unknown.ln(49.5)) / 1.0;
        assert!((slope + 0.5).abs() < 0.01, "{slope}");
        assert!(unknown.ln(5000.0) > KNOWN.ln(5000.0) + 2000.0);
    }
}
