//! Acceleration of a fixed point x = g(x): none, Aitken's dynamic relaxation, Anderson mixing.
//!
//! Aitken: Irons & Tuck, Int. J. Numer. Methods Eng. 1 (1969) 275-277. Anderson: Walker & Ni, SIAM J. Numer. Anal. 49
//! (2011) 1715-1735 (type II, least squares by QR).

use std::collections::VecDeque;

use nalgebra::{DMatrix, DVector};

use crate::input::design;
use crate::structure::largest;

/// How many earlier iterates Anderson mixing remembers.
const DEPTH: usize = 6;

/// The memory of an accelerated fixed point.
#[derive(Debug, Clone)]
pub enum Accelerator {
    /// The next x is g(x).
    None,
    /// One relaxation factor, from the last two residuals.
    Aitken {
        /// Factor of the last step.
        factor: f64,
        /// Last residual.
        last: Option<DVector<f64>>,
    },
    /// Least squares over the last steps.
    Anderson {
        /// Earlier pairs of residual and g(x), newest last.
        history: VecDeque<(DVector<f64>, DVector<f64>)>,
    },
}

impl Accelerator {
    /// Without memory yet.
    pub fn new(kind: design::Accelerator) -> Self {
        match kind {
            design::Accelerator::None => Accelerator::None,
            design::Accelerator::Aitken => Accelerator::Aitken {
                factor: 1.0,
                last: None,
            },
            // where Newton's method gives up, the fixed point goes on
            design::Accelerator::Anderson | design::Accelerator::Newton => Accelerator::Anderson {
                history: VecDeque::new(),
            },
        }
    }

    /// The next x after `mapped` = g(`x`).
    pub fn next(&mut self, x: &[f64], mapped: &[f64]) -> Vec<f64> {
        let (at, mapped) = (DVector::from_column_slice(x), DVector::from_column_slice(mapped));
        let residual = &mapped - &at;
        let next = match self {
            Accelerator::None => mapped,
            Accelerator::Aitken { factor, last } => {
                if let Some(last) = last {
                    let change = &residual - &*last;
                    let size = change.norm_squared();
                    if size > 0.0 {
                        *factor *= -last.dot(&change) / size;
                    }
                    // A factor of zero would stop the iteration for good.
                    let sign = if *factor < 0.0 { -1.0 } else { 1.0 };
                    *factor = sign * factor.abs().clamp(1e-3, 20.0);
                }
                *last = Some(residual.clone());
                at + residual * *factor
            }
            Accelerator::Anderson { history } => {
                let next = mix(history, &residual, &mapped);
                history.push_back((residual, mapped));
                if history.len() > DEPTH {
                    history.pop_front();
                }
                next
            }
        };
        next.data.into()
    }
}

/// g − ΔG γ with γ the least-squares solution of ΔR γ = r.
fn mix(
    history: &VecDeque<(DVector<f64>, DVector<f64>)>,
    residual: &DVector<f64>,
    mapped: &DVector<f64>,
) -> DVector<f64> {
    let changes: Vec<_> = history.iter().map(|(r, g)| (residual - r, mapped - g)).collect();
    if changes.is_empty() || residual.is_empty() {
        return mapped.clone();
    }
    let columns: Vec<_> = changes.iter().map(|(r, _)| r.clone()).collect();
    let matrix = DMatrix::from_columns(&columns);
    let most = largest(matrix.column_iter().map(|c| c.norm()));
    // the decomposition goes round for ever on what is not a number
    if !most.is_finite() {
        return mapped.clone();
    }
    let Ok(gamma) = matrix.svd(true, true).solve(residual, 1e-12 * most) else {
        return mapped.clone();
    };
    let mut next = mapped.clone();
    for ((_, change), weight) in changes.iter().zip(gamma.iter()) {
        next -= change * *weight;
    }
    next
}

#[cfg(test)]
mod tests {
    use super::*;

    /// g(x) = M x + b with eigenvalues −1.5, 0.5, 0.2 and a fixed point that is known.
    fn map(x: &[f64]) -> Vec<f64> {
        let m = [[-1.5, 0.3, 0.0], [0.0, 0.5, 0.1], [0.0, 0.0, 0.2]];
        let fixed = [1.0, -2.0, 0.5];
        (0..3)
            .map(|i| fixed[i] + (0..3).map(|j| m[i][j] * (x[j] - fixed[j])).sum::<f64>())
            .collect()
    }

    #[test]
    fn without_strips_there_is_nothing_to_mix_and_no_panic() {
        for kind in [
            design::Accelerator::None,
            design::Accelerator::Aitken,
            design::Accelerator::Anderson,
        ] {
            let mut accelerator = Accelerator::new(kind);
            for _ in 0..3 {
                assert!(accelerator.next(&[], &[]).is_empty());
            }
        }
    }

    fn iterations(kind: design::Accelerator) -> Option<usize> {
        let mut accelerator = Accelerator::new(kind);
        let mut x = vec![0.0; 3];
        for iteration in 0..200 {
            let mapped = map(&x);
            let error: f64 = x.iter().zip(&mapped).map(|(a, b)| (a - b).abs()).sum();
            if error < 1e-10 {
                assert!((x[0] - 1.0).abs() < 1e-9 && (x[1] + 2.0).abs() < 1e-9 && (x[2] - 0.5).abs() < 1e-9);
                return Some(iteration);
            }
            if !error.is_finite() {
                return None;
            }
            x = accelerator.next(&x, &mapped);
        }
        None
    }

    #[test]
    fn anderson_ends_a_linear_map_of_three_in_four_steps_and_plain_iteration_diverges() {
        assert!(iterations(design::Accelerator::Anderson).unwrap() <= 5);
        assert_eq!(iterations(design::Accelerator::None), None);
        assert!(iterations(design::Accelerator::Aitken).unwrap() < 60);
    }

    #[test]
    fn aitken_finds_the_optimum_factor_of_a_scalar_map_at_once() {
        // g(x) = m x + 1, factor 1/(1 − m): exact after two evaluations
        for m in [-3.0, 0.5, 0.9] {
            let mut accelerator = Accelerator::new(design::Accelerator::Aitken);
            let g = |x: f64| m * x + 1.0;
            let x1 = accelerator.next(&[0.0], &[g(0.0)])[0];
            let x2 = accelerator.next(&[x1], &[g(x1)])[0];
            assert!((x2 - 1.0 / (1.0 - m)).abs() < 1e-12, "{m} {x2}");
            let Accelerator::Aitken { factor, .. } = accelerator else {
                unreachable!()
            };
            assert!((factor - 1.0 / (1.0 - m)).abs() < 1e-12);
        }
    }
}
