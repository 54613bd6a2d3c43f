//! Evidence: how probable the data are under a hypothesis, its strengths integrated over their priors.
//!
//! With all unknowns in prior standard deviations and whitened slopes J, ln Z = −½ ln|I + JᵀJ| − ½ Q (Laplace). If the
//! scale of the noise is not known but trusted like ν₀ numbers, −½ Q becomes −½ (n + ν₀) ln(1 + Q/ν₀). What is known of a
//! strength besides, its sign and its plausible sizes, comes on top ([`super::prior`]).

use nalgebra::{DMatrix, DVector};

use super::prior::StrengthPrior;
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

/// One or two strengths in the linear model: what they add to the evidence of the fit that they join.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearEvidence {
    /// ln Z minus that of the fit without them.
    pub ln_gain: f64,
    /// Least Q with them.
    pub q: f64,
    /// Estimates in prior standard deviations.
    pub estimate: [f64; 2],
    /// Their standard errors.
    pub error: [f64; 2],
}

/// Evidence of one more direction `a` (length per prior standard deviation, free of the fit) with `dot` = a·e; `prior` of its strength, if
/// more than that is known.
pub fn of_one(
    likelihood: Likelihood,
    q0: f64,
    length_squared: f64,
    dot: f64,
    prior: Option<StrengthPrior>,
) -> LinearEvidence {
    let curvature = 1.0 + length_squared;
    let estimate = dot / curvature;
    let q = q0 - dot * estimate;
    let mut ln_gain = -0.5 * curvature.ln() + likelihood.ln(q) - likelihood.ln(q0);
    let error = (likelihood.variance(q) / curvature).sqrt();
    if let Some(prior) = prior {
        ln_gain += prior.ln_factor(estimate, error);
    }
    LinearEvidence {
        ln_gain,
        q,
        estimate: [estimate, 0.0],
        error: [error, 0.0],
    }
}

/// Evidence of two more directions: their Gram matrix, their products with the residual, and what is known of their strengths.
pub fn of_two(
    likelihood: Likelihood,
    q0: f64,
    gram: [f64; 3],
    dot: [f64; 2],
    priors: [Option<StrengthPrior>; 2],
) -> LinearEvidence {
    let (a, b, c) = (1.0 + gram[0], 1.0 + gram[2], gram[1]);
    let determinant = (a * b - c * c).max(f64::MIN_POSITIVE);
    let estimate = [
        (b * dot[0] - c * dot[1]) / determinant,
        (a * dot[1] - c * dot[0]) / determinant,
    ];
    let q = (q0 - dot[0] * estimate[0] - dot[1] * estimate[1]).max(0.0);
    let mut ln_gain = -0.5 * determinant.ln() + likelihood.ln(q) - likelihood.ln(q0);
    let variance = likelihood.variance(q);
    let error = [b, a].map(|other| (variance * other / determinant).sqrt());
    for k in 0..2 {
        if let Some(prior) = priors[k] {
            ln_gain += prior.ln_factor(estimate[k], error[k]);
        }
    }
    LinearEvidence {
        ln_gain,
        q,
        estimate,
        error,
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
        let first = columns.column(0).into_owned();
        let one = of_one(KNOWN, q0, first.norm_squared(), first.dot(&residual), None);
        let exact = gaussian(&residual, &columns.columns(0, 1).into_owned()) - none;
        assert!((one.ln_gain - exact).abs() < 1e-12);
        let gram = columns.transpose() * &columns;
        let dots = columns.transpose() * &residual;
        let two = of_two(
            KNOWN,
            q0,
            [gram[(0, 0)], gram[(0, 1)], gram[(1, 1)]],
            [dots[0], dots[1]],
            [None; 2],
        );
        let exact = gaussian(&residual, &columns) - none;
        assert!((two.ln_gain - exact).abs() < 1e-12);
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
