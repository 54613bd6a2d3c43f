//! Prediction of what was left out, in closed form: proof, not ranking.
//!
//! With Σ_y = Σ + J Jᵀ and P = Σ_y⁻¹, the error of predicting a group g from all others is e = P_gg⁻¹ (P r)_g with
//! covariance P_gg⁻¹ (Sundararajan & Keerthi, Neural Comput. 13, 2001, 1103, for groups). Single stations are never left
//! out: their neighbours tell them.

use nalgebra::{Cholesky, DMatrix, DVector};

use crate::study::{Forward, Noise};

use super::data::Data;
use super::whitened::Local;

/// A group that was predicted from all others.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// Positions among the fitted observables.
    pub positions: Vec<usize>,
    /// Measured minus predicted, in the units of the observables.
    pub errors: Vec<f64>,
    /// Logarithm of the density that the prediction gave to what was measured.
    pub ln_density: f64,
}

/// Leaves out each of `groups` in turn; linear about the fit.
pub fn leave_out(local: &Local, noise: &Noise, groups: &[Vec<usize>]) -> Vec<LeftOut> {
    let size = local.at_means.len();
    let slopes = noise.whiten_columns(&local.slopes);
    let covariance = DMatrix::identity(size, size) + &slopes * slopes.transpose();
    let Some(factor) = Cholesky::new(covariance) else {
        return Vec::new();
    };
    let whitener = noise.whiten_columns(&DMatrix::identity(size, size));
    let precision = whitener.transpose() * factor.solve(&whitener);
    let weighted = &precision * &local.at_means;
    let predict = |positions: &Vec<usize>| {
        let own = precision
            .select_rows(positions.iter())
            .select_columns(positions.iter());
        let part = DVector::from_iterator(positions.len(), positions.iter().map(|&i| weighted[i]));
        let factor = Cholesky::new(own)?;
        let errors = factor.solve(&part);
        let half_ln_determinant: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
        let ln_density = half_ln_determinant
            - 0.5 * errors.dot(&part)
            - 0.5 * positions.len() as f64 * (2.0 * std::f64::consts::PI).ln();
        Some(LeftOut {
            positions: positions.clone(),
            errors: errors.as_slice().to_vec(),
            ln_density,
        })
    };
    groups.iter().filter_map(predict).collect()
}

/// Sum of the logarithms of the densities; none if there are fewer than two groups.
pub fn ln_density(local: &Local, noise: &Noise, groups: &[Vec<usize>]) -> Option<f64> {
    (groups.len() > 1).then(|| {
        leave_out(local, noise, groups)
            .iter()
            .map(|left| left.ln_density)
            .sum()
    })
}

/// The fitted observables by condition.
pub fn by_condition(forward: &dyn Forward, data: &Data) -> Vec<Vec<usize>> {
    data.conditions(forward)
        .into_iter()
        .map(|(_, positions)| positions)
        .collect()
}

/// The fitted observables by wing.
pub fn by_wing(forward: &dyn Forward, data: &Data) -> Vec<Vec<usize>> {
    let mut wings: Vec<(&str, Vec<usize>)> = Vec::new();
    for (condition, positions) in data.conditions(forward) {
        let wing = forward.conditions()[condition].wing.as_str();
        match wings.iter_mut().find(|(known, _)| *known == wing) {
            Some((_, found)) => found.extend(positions),
            None => wings.push((wing, positions)),
        }
    }
    wings.into_iter().map(|(_, positions)| positions).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::{Bound, Channel};
    use crate::study::AdmittedError;
    use crate::study::{Condition, Observable};

    fn noise(size: usize, sigma: f64) -> Noise {
        let observable = |line| Observable {
            condition: 0,
            line,
            channel: Channel::Twist,
            run: String::new(),
            r_mm: Some(1.0),
            r_to_mm: None,
            value: 0.0,
            sigma,
            bound: Bound::None,
        };
        let observables: Vec<Observable> = (0..size).map(observable).collect();
        let condition = Condition {
            name: "c".into(),
            wing: "w".into(),
            is_held_out: false,
            frequency_hz: None,
            half_amplitude_deg: None,
            dynamic_pressure_pa: 0.0,
            length_m: 1.0,
        };
        let rows: Vec<usize> = (0..size).collect();
        Noise::new(
            &observables,
            &[condition],
            &rows,
            &AdmittedError::of_predictions(0.0, &DVector::zeros(size)),
        )
        .unwrap()
    }

    #[test]
    fn leaving_out_in_closed_form_is_fitting_without() {
        // y = a + b x with priors of standard deviation 3; the last two of five points left out
        let slopes = DMatrix::from_fn(5, 2, |i, j| 3.0 * (i as f64).powi(j as i32));
        let at_means = DVector::from_vec(vec![1.0, 1.5, 2.5, 2.0, 5.0]);
        let local = Local {
            at_means: at_means.clone(),
            slopes: slopes.clone(),
            rows: (0..5).collect(),
        };
        let left = leave_out(&local, &noise(5, 0.5), &[vec![0, 1, 2], vec![3, 4]]);
        let near = slopes.rows(0, 3) / 0.5;
        let curvature = DMatrix::identity(2, 2) + near.transpose() * &near;
        let fit = curvature
            .cholesky()
            .unwrap()
            .solve(&(near.transpose() * at_means.rows(0, 3) / 0.5));
        for (k, i) in [3, 4].into_iter().enumerate() {
            let error = at_means[i] - (slopes.row(i) * &fit)[0];
            assert!((left[1].errors[k] - error).abs() < 1e-10, "{k}");
        }
    }
}
