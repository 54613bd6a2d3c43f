//! Shares of the inputs in the variance of an output (Sobol indices), from a surrogate.
//!
//! With orthonormal terms and independent inputs, uniform over their ranges, the variance is the sum of the squared
//! coefficients; what the surrogate does not explain is added to it and belongs to no input.
//! Sudret, Reliab. Eng. Syst. Saf. 93, 2008, 964.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::surrogate::{Surrogate, Term};

/// Share of one input in the variance of an output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Share {
    /// Dotted key of the input in the design.
    pub key: String,
    /// Its share by itself, 0 to 1.
    pub first_order: f64,
    /// Its share with every product in which it takes part, 0 to 1.
    pub total: f64,
}

/// Shares of the inputs that the surrogate holds, largest total first.
pub fn shares(surrogate: &Surrogate, keys: &[String]) -> Vec<Share> {
    let explained: f64 = surrogate.terms.iter().map(|(_, c)| c * c).sum();
    let variance = explained + surrogate.residual_variance;
    let part = |belongs: &dyn Fn(Term) -> bool| {
        let squares = surrogate
            .terms
            .iter()
            .filter(|(term, _)| belongs(*term))
            .map(|(_, c)| c * c);
        squares.sum::<f64>() / variance
    };
    let mut shares: Vec<Share> = keys
        .iter()
        .enumerate()
        .map(|(input, key)| Share {
            key: key.clone(),
            first_order: part(&|term| term.has(input) && !matches!(term, Term::Product(..))),
            total: part(&|term| term.has(input)),
        })
        .filter(|share| share.total > 0.0)
        .collect();
    shares.sort_by(|a, b| b.total.total_cmp(&a.total));
    shares
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::sample::unit_points;

    #[test]
    fn the_shares_of_a_quadratic_are_its_known_sobol_indices() {
        let points: Vec<Vec<f64>> = unit_points(64, 3, 0)
            .into_iter()
            .map(|point| point.into_iter().map(|u| 2.0 * u - 1.0).collect())
            .collect();
        let values: Vec<f64> = points
            .iter()
            .map(|x| 2.0 * x[0] + x[1] + 1.5 * x[0] * x[1] + 0.7 * x[2] * x[2])
            .collect();
        let keys = ["a", "b", "c"].map(str::to_string);
        let shares = shares(&Surrogate::fit(&points, &values).unwrap(), &keys);
        // Var x = 1/3, Var xy = 1/9, Var x² = 4/45.
        let parts = [4.0 / 3.0, 1.0 / 3.0, 2.25 / 9.0, 0.49 * 4.0 / 45.0];
        let variance: f64 = parts.iter().sum();
        let expected = [
            ("a", parts[0], parts[0] + parts[2]),
            ("b", parts[1], parts[1] + parts[2]),
            ("c", parts[3], parts[3]),
        ];
        for (share, (key, first, total)) in shares.iter().zip(expected) {
            assert_eq!(share.key, key);
            assert!((share.first_order - first / variance).abs() < 1e-12, "{share:?}");
            assert!((share.total - total / variance).abs() < 1e-12, "{share:?}");
        }
    }
}
