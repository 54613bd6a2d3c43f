//! What scatter is expected between measurement and model: that of the measurement, and an admitted error of the model.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::error::StudyError;
use super::forward::{Condition, Observable};

/// Correlation length of the model's admitted error along the span, over the length of the wing.
const SPAN_LENGTH: f64 = 0.3;
/// Correlation of the model's admitted error between two conditions of one wing, and of two wings.
const CONDITION_CORRELATION: [f64; 2] = [0.7, 0.0];

/// Covariance of measurement minus model for a choice of observables, by its Cholesky factor.
///
/// Σ = diag(σ²) + τ² (y yᵀ) ∘ C with the prediction y, the admitted share τ of error, and a smooth correlation C along
/// the span, between conditions of one wing, within one channel.
#[derive(Debug, Clone)]
pub struct Noise {
    factor: Cholesky<f64, Dyn>,
}

/// The error of the model that is admitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Discrepancy {
    /// Share τ of every prediction.
    pub share: f64,
    /// Predictions of all observables.
    pub value: DVector<f64>,
}

impl Discrepancy {
    /// A share of the predictions `value`, and nothing else.
    pub fn of_predictions(share: f64, value: &DVector<f64>) -> Discrepancy {
        Discrepancy {
            share,
            value: value.clone(),
        }
    }
}

impl Noise {
    /// Covariance for the observables `rows`.
    ///
    /// # Errors
    /// If it is not positive definite: a σ that is no positive number.
    pub fn new(
        observables: &[Observable],
        conditions: &[Condition],
        rows: &[usize],
        admitted: &Discrepancy,
    ) -> Result<Noise, StudyError> {
        let size = rows.len();
        let Discrepancy { share, value } = admitted;
        let covariance = DMatrix::from_fn(size, size, |i, j| {
            let (a, b) = (&observables[rows[i]], &observables[rows[j]]);
            let measured = if i == j { a.sigma * a.sigma } else { 0.0 };
            let admitted = share * share * value[rows[i]] * value[rows[j]];
            measured + admitted * correlation(a, b, conditions)
        });
        Noise::of_covariance(covariance)
    }

    /// Of a covariance that is known.
    ///
    /// # Errors
    /// If it is not positive definite: a σ that is no positive number.
    pub fn of_covariance(covariance: DMatrix<f64>) -> Result<Noise, StudyError> {
        let factor = Cholesky::new(covariance).ok_or(StudyError::BadNoise)?;
        Ok(Noise { factor })
    }

    /// The same with every variance scaled by `factor`².
    pub fn scaled(&self, factor: f64) -> Noise {
        let lower = self.factor.l() * factor;
        Noise {
            factor: Cholesky::pack_dirty(lower),
        }
    }

    /// L⁻¹ x: of unit covariance if x has covariance Σ = L Lᵀ.
    pub fn whiten(&self, x: &DVector<f64>) -> DVector<f64> {
        self.factor
            .l_dirty()
            .solve_lower_triangular(x)
            .unwrap_or_else(|| x.clone())
    }

    /// L⁻¹ X, column by column.
    pub fn whiten_columns(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        self.factor
            .l_dirty()
            .solve_lower_triangular(x)
            .unwrap_or_else(|| x.clone())
    }

    /// L x: turns unit noise into noise of this covariance.
    pub fn colour(&self, x: &DVector<f64>) -> DVector<f64> {
        self.factor.l() * x
    }

    /// Logarithm of the determinant of Σ.
    pub fn ln_determinant(&self) -> f64 {
        2.0 * self
            .factor
            .l_dirty()
            .diagonal()
            .iter()
            .map(|d| d.ln())
            .sum::<f64>()
    }
}

fn correlation(a: &Observable, b: &Observable, conditions: &[Condition]) -> f64 {
    if a.channel != b.channel {
        return 0.0;
    }
    let (at, bt) = (&conditions[a.condition], &conditions[b.condition]);
    let between = if a.condition == b.condition {
        1.0
    } else {
        CONDITION_CORRELATION[usize::from(at.wing != bt.wing)]
    };
    let place = |o: &Observable, c: &Condition| {
        let inner = o.r_mm?;
        Some(0.5 * (inner + o.r_to_mm.unwrap_or(inner)) / (1e3 * c.length_m))
    };
    let along = match (place(a, at), place(b, bt)) {
        (Some(x), Some(y)) => (-0.5 * ((x - y) / SPAN_LENGTH).powi(2)).exp(),
        _ => 1.0,
    };
    between * along
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::{Bound, Channel};

    fn observables() -> (Vec<Observable>, Vec<Condition>) {
        let observable = |condition, r_mm, sigma| Observable {
            condition,
            line: 1,
            channel: Channel::Twist,
            run: String::new(),
            r_mm: Some(r_mm),
            r_to_mm: None,
            value: 10.0,
            sigma,
            bound: Bound::None,
        };
        let condition = |name: &str, wing: &str| Condition {
            name: name.into(),
            wing: wing.into(),
            is_held_out: false,
            frequency_hz: None,
            half_amplitude_deg: None,
            dynamic_pressure_pa: 0.0,
            length_m: 0.1,
        };
        let conditions = vec![condition("a", "w"), condition("b", "w"), condition("c", "v")];
        let rows = vec![
            observable(0, 50.0, 0.1),
            observable(0, 80.0, 0.2),
            observable(1, 50.0, 0.1),
            observable(2, 50.0, 0.1),
        ];
        (rows, conditions)
    }

    #[test]
    fn coloured_unit_noise_has_the_stated_covariance() {
        let (rows, conditions) = observables();
        let value = DVector::from_element(4, 10.0);
        let noise = Noise::new(
            &rows,
            &conditions,
            &[0, 1, 2, 3],
            &Discrepancy::of_predictions(0.05, &value),
        )
        .unwrap();
        let lower = DMatrix::from_fn(4, 4, |i, j| {
            noise.colour(&DVector::from_fn(4, |k, _| f64::from(u8::from(k == j))))[i]
        });
        let covariance = &lower * lower.transpose();
        // 0.5 deg of admitted error: 0.1² + 0.25; neighbours 0.3 L apart by exp(-1/2); other condition 0.7; other wing 0
        let expected = |i: usize, j: usize| match (i, j) {
            (1, 1) => 0.04 + 0.25,
            (i, j) if i == j => 0.01 + 0.25,
            (0, 1) | (1, 0) => 0.25 * (-0.5f64).exp(),
            (0, 2) | (2, 0) => 0.25 * 0.7,
            (1, 2) | (2, 1) => 0.25 * 0.7 * (-0.5f64).exp(),
            _ => 0.0,
        };
        for i in 0..4 {
            for j in 0..4 {
                assert!((covariance[(i, j)] - expected(i, j)).abs() < 1e-12, "{i} {j}");
            }
        }
        let x = DVector::from_vec(vec![1.0, -2.0, 0.5, 3.0]);
        assert!((noise.colour(&noise.whiten(&x)) - &x).amax() < 1e-12);
        assert!((noise.scaled(2.0).whiten(&x) * 2.0 - noise.whiten(&x)).amax() < 1e-12);
        assert!((noise.ln_determinant() - covariance.determinant().ln()).abs() < 1e-9);
    }
}
