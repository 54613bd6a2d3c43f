//! A sparse quadratic polynomial through sampled values, by forward selection.
//!
//! Terms are products of orthonormal Legendre polynomials up to degree two: √3 x, √5 (3x² − 1)/2 and 3 x_i x_j,
//! x in [−1, 1]. A term enters if it lowers the residual most and its partial F-test, times the number of candidates,
//! is below 5 % (Bonferroni): with more inputs than samples can hold, a term that is not seen stays out. A product
//! is a candidate once one of its two inputs stands in the polynomial.

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use crate::structure::largest;

/// A sparse quadratic polynomial.
#[derive(Debug, Clone, PartialEq)]
pub struct Surrogate {
    /// Terms besides the mean, in the order in which they entered, and their coefficients.
    pub terms: Vec<(Term, f64)>,
    /// Mean of the values under the polynomial.
    pub mean: f64,
    /// Variance of the values about the polynomial, RSS/(n − p).
    pub residual_variance: f64,
    /// Share of the variance of the samples that the polynomial explains.
    pub r_squared: f64,
    /// The same when each sample is predicted by the others; negative if worse than their mean.
    pub predictive_r_squared: f64,
}

/// A term of the polynomial.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Term {
    /// √3 x_i.
    Linear(usize),
    /// √5 (3 x_i² − 1)/2.
    Square(usize),
    /// 3 x_i x_j, i < j.
    Product(usize, usize),
}

impl Term {
    /// Value at a point of [−1, 1]ⁿ.
    pub fn value(self, x: &[f64]) -> f64 {
        match self {
            Term::Linear(i) => 3f64.sqrt() * x[i],
            Term::Square(i) => 5f64.sqrt() * (3.0 * x[i] * x[i] - 1.0) / 2.0,
            Term::Product(i, j) => 3.0 * x[i] * x[j],
        }
    }

    /// Whether the input takes part in it.
    pub fn has(self, input: usize) -> bool {
        match self {
            Term::Linear(i) | Term::Square(i) => i == input,
            Term::Product(i, j) => i == input || j == input,
        }
    }
}

impl Surrogate {
    /// Fits `values` at `points` of [−1, 1]ⁿ. None with fewer than four samples or without variance.
    pub fn fit(points: &[Vec<f64>], values: &[f64]) -> Option<Surrogate> {
        let inputs = points.first()?.len();
        let total = centred(values).norm_squared();
        let size = largest(values.iter().map(|value| value.abs()));
        let is_varied = total > (1e-12 * size).powi(2) * values.len() as f64;
        if values.len() < 4 || !is_varied {
            return None;
        }
        let mut chosen: Vec<Term> = Vec::new();
        // Columns chosen so far, made orthonormal; the first is the mean.
        let mut basis = vec![DVector::from_element(
            values.len(),
            1.0 / (values.len() as f64).sqrt(),
        )];
        let mut residual = centred(values);
        while chosen.len() + 1 < values.len() / 2 && residual.norm_squared() > 1e-24 * total {
            let candidates = candidates(inputs, &chosen);
            let Some((term, direction)) = best(&candidates, points, &basis, &residual) else {
                break;
            };
            let gain = direction.dot(&residual).powi(2);
            let free = values.len() - chosen.len() - 2;
            if chance(gain, residual.norm_squared() - gain, free) * candidates.len() as f64 > 0.05 {
                break;
            }
            residual -= &direction * direction.dot(&residual);
            basis.push(direction);
            chosen.push(term);
        }
        finish(&chosen, points, values, total)
    }
}

fn centred(values: &[f64]) -> DVector<f64> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    DVector::from_iterator(values.len(), values.iter().map(|value| value - mean))
}

fn candidates(inputs: usize, chosen: &[Term]) -> Vec<Term> {
    let stands = |input: usize| chosen.iter().any(|term| term.has(input));
    let singles = (0..inputs).flat_map(|i| [Term::Linear(i), Term::Square(i)]);
    let pairs = (0..inputs).flat_map(|i| (i + 1..inputs).map(move |j| (i, j)));
    let products = pairs
        .filter(|&(i, j)| stands(i) || stands(j))
        .map(|(i, j)| Term::Product(i, j));
    singles
        .chain(products)
        .filter(|term| !chosen.contains(term))
        .collect()
}

/// The candidate that lowers the residual most, with its column made orthonormal to the basis.
fn best(
    candidates: &[Term],
    points: &[Vec<f64>],
    basis: &[DVector<f64>],
    residual: &DVector<f64>,
) -> Option<(Term, DVector<f64>)> {
    let mut best: Option<(f64, Term, DVector<f64>)> = None;
    for &term in candidates {
        let mut column = DVector::from_iterator(points.len(), points.iter().map(|x| term.value(x)));
        let length = column.norm();
        // Twice, so that the column is orthogonal to rounding.
        for _ in 0..2 {
            for direction in basis {
                column -= direction * direction.dot(&column);
            }
        }
        if column.norm() < 1e-6 * length {
            continue;
        }
        column.normalize_mut();
        let gain = column.dot(residual).powi(2);
        if best.as_ref().is_none_or(|(most, _, _)| gain > *most) {
            best = Some((gain, term, column));
        }
    }
    best.map(|(_, term, column)| (term, column))
}

/// Chance of a gain at least this large by a term that is not there.
fn chance(gain: f64, left: f64, free: usize) -> f64 {
    if free == 0 || gain <= 0.0 {
        return 1.0;
    }
    let f = gain * free as f64 / left.max(f64::MIN_POSITIVE);
    FisherSnedecor::new(1.0, free as f64).map_or(1.0, |law| if f.is_finite() { law.sf(f) } else { 0.0 })
}

/// Coefficients of the chosen terms by least squares, and how well they explain and predict.
fn finish(chosen: &[Term], points: &[Vec<f64>], values: &[f64], total: f64) -> Option<Surrogate> {
    let count = values.len();
    let columns = chosen.len() + 1;
    let design = DMatrix::from_fn(count, columns, |row, column| match column {
        0 => 1.0,
        _ => chosen[column - 1].value(&points[row]),
    });
    let y = DVector::from_column_slice(values);
    let qr = design.clone().qr();
    let coefficients = qr.r().solve_upper_triangular(&(qr.q().transpose() * &y))?;
    let residual = &y - &design * &coefficients;
    let q = qr.q();
    let left_out: f64 = (0..count)
        .map(|row| {
            let leverage = q.row(row).norm_squared();
            (residual[row] / (1.0 - leverage).max(1e-12)).powi(2)
        })
        .sum();
    // Prediction by the mean of the others has residual n/(n − 1) times that by the mean of all.
    let total_left_out = total * (count as f64 / (count as f64 - 1.0)).powi(2);
    Some(Surrogate {
        terms: chosen
            .iter()
            .copied()
            .zip(coefficients.iter().skip(1).copied())
            .collect(),
        mean: coefficients[0],
        residual_variance: residual.norm_squared() / (count - columns).max(1) as f64,
        r_squared: 1.0 - residual.norm_squared() / total,
        predictive_r_squared: 1.0 - left_out / total_left_out,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::sample::unit_points;

    fn cube(count: usize, inputs: usize) -> Vec<Vec<f64>> {
        let points = unit_points(count, inputs, 3).into_iter();
        points
            .map(|point| point.into_iter().map(|u| 2.0 * u - 1.0).collect())
            .collect()
    }

    #[test]
    fn a_quadratic_among_twenty_inputs_is_recovered_from_64_samples() {
        let points = cube(64, 20);
        let truth = |x: &[f64]| 5.0 + 2.0 * x[3] + x[7] + 0.5 * x[3] * x[7] + 0.7 * x[11] * x[11];
        let values: Vec<f64> = points.iter().map(|x| truth(x)).collect();
        let fit = Surrogate::fit(&points, &values).unwrap();
        assert_eq!(fit.terms.len(), 4, "{fit:?}");
        let coefficient = |wanted: Term| fit.terms.iter().find(|(term, _)| *term == wanted).unwrap().1;
        assert!((coefficient(Term::Linear(3)) - 2.0 / 3f64.sqrt()).abs() < 1e-12);
        assert!((coefficient(Term::Linear(7)) - 1.0 / 3f64.sqrt()).abs() < 1e-12);
        assert!((coefficient(Term::Product(3, 7)) - 0.5 / 3.0).abs() < 1e-12);
        assert!((coefficient(Term::Square(11)) - 0.7 * 2.0 / 3.0 / 5f64.sqrt()).abs() < 1e-12);
        assert!((fit.mean - 5.0 - 0.7 / 3.0).abs() < 1e-12);
        assert!(fit.r_squared > 1.0 - 1e-12 && fit.predictive_r_squared > 1.0 - 1e-12);
    }

    #[test]
    fn values_without_structure_get_hardly_a_term_and_no_power_to_predict() {
        let mut terms = 0;
        for seed in 0..20 {
            let points = cube(64, 15);
            let wild = |k: usize| (((k + 64 * seed) as f64 * 12.9898).sin() * 43758.5453).fract();
            let values: Vec<f64> = (0..64).map(wild).collect();
            let fit = Surrogate::fit(&points, &values).unwrap();
            terms += fit.terms.len();
            assert!(fit.predictive_r_squared < 0.5, "{fit:?}");
        }
        assert!(terms <= 5, "{terms} terms from 20 samples without structure");
    }

    #[test]
    fn the_predictive_share_is_that_of_leaving_each_sample_out() {
        let points = cube(12, 1);
        let values: Vec<f64> = points.iter().map(|x| x[0] + 0.3 * (9.0 * x[0]).sin()).collect();
        let fit = Surrogate::fit(&points, &values).unwrap();
        assert_eq!(
            fit.terms.iter().map(|(term, _)| *term).collect::<Vec<_>>(),
            [Term::Linear(0)]
        );
        let (mut missed, mut spread) = (0.0, 0.0);
        for out in 0..12 {
            let rest: Vec<(f64, f64)> = (0..12)
                .filter(|k| *k != out)
                .map(|k| (points[k][0], values[k]))
                .collect();
            let mean = |part: fn(&(f64, f64)) -> f64| rest.iter().map(part).sum::<f64>() / 11.0;
            let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
            let slope = rest.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum::<f64>()
                / rest.iter().map(|p| (p.0 - mx).powi(2)).sum::<f64>();
            missed += (values[out] - my - slope * (points[out][0] - mx)).powi(2);
            spread += (values[out] - my).powi(2);
        }
        assert!((fit.predictive_r_squared - (1.0 - missed / spread)).abs() < 1e-12);
    }

    #[test]
    fn values_without_variance_have_no_surrogate() {
        assert_eq!(Surrogate::fit(&cube(16, 2), &[1.0; 16]), None);
        assert_eq!(Surrogate::fit(&cube(16, 2), &[0.0; 16]), None);
        assert_eq!(Surrogate::fit(&[], &[]), None);
    }
}
