//! Prediction of what was left out, in closed form: proof, not ranking.
//!
//! With Σ_y = Σ + J Jᵀ and P = Σ_y⁻¹, what the others tell of a group g is r_g − e with e = P_gg⁻¹ (P r)_g and covariance P_gg⁻¹
//! (Sundararajan & Keerthi, Neural Comput. 13, 2001, 1103, for groups). Part of that is the error of the model that goes together
//! among conditions, as far as it is admitted; the model itself, fitted to the others, has the unknowns x = Jᵀ P (r − e), e being
//! nought outside of g, and misses the group by r_g − J_g x. Single stations are never left out: their neighbours tell them.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::calibrate::Fit;
use super::forward::Forward;
use super::noise::Noise;

/// One fit, linear and in the units of the observables: what the data are about it under any scatter.
#[derive(Debug, Clone)]
pub struct Local {
    /// Measured minus modelled with the fitted unknowns at their prior means, by the linear model about the fit.
    pub at_means: DVector<f64>,
    /// Derivatives per prior standard deviation of the fitted unknowns.
    pub slopes: DMatrix<f64>,
    /// Indices of the observables.
    pub rows: Vec<usize>,
    /// Columns of unknowns that ended at an end of their range, with their distance from the prior mean in its standard deviations.
    pub ends: Vec<(usize, f64)>,
}

impl Local {
    /// About `fit`, which was made with `noise`.
    pub fn about(fit: &Fit, forward: &dyn Forward, noise: &Noise) -> Local {
        let unknowns = forward.unknowns();
        let pulls = fit
            .free
            .iter()
            .map(|&i| (fit.at[i] - unknowns[i].mean) / unknowns[i].sigma);
        let pulls = DVector::from_iterator(fit.free.len(), pulls);
        let at_means = noise.colour(&(&fit.residual + &fit.slopes * &pulls));
        let is_at_end = |column: &usize| fit.at_end.contains(&fit.free[*column]);
        let ends = (0..fit.free.len()).filter(is_at_end);
        let ends = ends.map(|column| (column, pulls[column])).collect();
        let mut slopes = fit.slopes.clone();
        for mut column in slopes.column_iter_mut() {
            let coloured = noise.colour(&column.clone_owned());
            column.copy_from(&coloured);
        }
        Local {
            at_means,
            slopes,
            rows: fit.rows.clone(),
            ends,
        }
    }

    /// The same with what ended at an end of its range held there: it is not free to be fitted to a part of the data either.
    fn held(&self) -> Local {
        let mut at_means = self.at_means.clone();
        for &(column, pull) in &self.ends {
            at_means -= self.slopes.column(column) * pull;
        }
        let columns: Vec<usize> = self.ends.iter().map(|end| end.0).collect();
        Local {
            at_means,
            slopes: self.slopes.clone().remove_columns_at(&columns),
            rows: self.rows.clone(),
            ends: Vec::new(),
        }
    }
}

/// A group that was predicted from all others.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// Positions among the fitted observables.
    pub positions: Vec<usize>,
    /// Measured minus predicted by the model as fitted to all others, in the units of the observables.
    pub errors: Vec<f64>,
    /// Logarithm of the density that all others give to what was measured.
    pub ln_density: f64,
}

/// What the others tell of each group, about one fit; linear.
#[derive(Debug, Clone)]
pub struct Others {
    local: Local,
    /// P; none where the slopes are not finite.
    precision: Option<DMatrix<f64>>,
}

impl Others {
    /// About a fit, with scatter `noise`.
    pub fn new(local: &Local, noise: &Noise) -> Others {
        let local = local.held();
        let size = local.at_means.len();
        let slopes = noise.whiten_columns(&local.slopes);
        let covariance = DMatrix::identity(size, size) + &slopes * slopes.transpose();
        let precision = Cholesky::new(covariance).map(|factor| {
            let whitener = noise.whiten_columns(&DMatrix::identity(size, size));
            whitener.transpose() * factor.solve(&whitener)
        });
        Others { local, precision }
    }

    /// The same with one unknown more, by its derivatives per prior standard deviation (Sherman & Morrison 1950).
    pub fn with(&self, column: &DVector<f64>) -> Others {
        let count = self.local.slopes.ncols();
        let mut slopes = self.local.slopes.clone().insert_column(count, 0.0);
        slopes.set_column(count, column);
        let precision = self.precision.as_ref().map(|precision| {
            let along = precision * column;
            precision - &along * along.transpose() / (1.0 + column.dot(&along))
        });
        Others {
            local: Local {
                slopes,
                ..self.local.clone()
            },
            precision,
        }
    }

    /// Leaves out each of `groups` in turn; none if the derivatives are not finite.
    pub fn leave_out(&self, groups: &[Vec<usize>]) -> Option<Vec<LeftOut>> {
        let precision = self.precision.as_ref()?;
        let weighted = precision * &self.local.at_means;
        let all = groups.iter();
        all.map(|positions| self.one(precision, &weighted, positions))
            .collect()
    }

    fn one(&self, precision: &DMatrix<f64>, weighted: &DVector<f64>, positions: &[usize]) -> Option<LeftOut> {
        let Local { at_means, slopes, .. } = &self.local;
        let own = precision
            .select_rows(positions.iter())
            .select_columns(positions.iter());
        let part = DVector::from_iterator(positions.len(), positions.iter().map(|&i| weighted[i]));
        let factor = Cholesky::new(own)?;
        let surprise = factor.solve(&part);
        let half_ln_determinant: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
        let ln_density = half_ln_determinant
            - 0.5 * surprise.dot(&part)
            - 0.5 * positions.len() as f64 * (2.0 * std::f64::consts::PI).ln();
        let mut told = at_means.clone();
        for (&position, surprise) in positions.iter().zip(surprise.iter()) {
            told[position] -= surprise;
        }
        let unknowns = slopes.tr_mul(&(precision * told));
        let error = |&position: &usize| at_means[position] - slopes.row(position).transpose().dot(&unknowns);
        Some(LeftOut {
            positions: positions.to_vec(),
            errors: positions.iter().map(error).collect(),
            ln_density,
        })
    }

    /// Sum of the logarithms of the densities; none if there are fewer than two groups, or the derivatives are not finite.
    pub fn ln_density(&self, groups: &[Vec<usize>]) -> Option<f64> {
        if groups.len() < 2 {
            return None;
        }
        Some(self.leave_out(groups)?.iter().map(|left| left.ln_density).sum())
    }
}

/// Conditions of the observables `rows`, each with the positions of its observables among them, in their order.
pub fn conditions_of(forward: &dyn Forward, rows: &[usize]) -> Vec<(usize, Vec<usize>)> {
    let mut found: Vec<(usize, Vec<usize>)> = Vec::new();
    for (position, &row) in rows.iter().enumerate() {
        let condition = forward.observables()[row].condition;
        match found.iter_mut().find(|(known, _)| *known == condition) {
            Some((_, positions)) => positions.push(position),
            None => found.push((condition, vec![position])),
        }
    }
    found
}

/// The observables `rows` by condition: positions among them.
pub fn by_condition(forward: &dyn Forward, rows: &[usize]) -> Vec<Vec<usize>> {
    conditions_of(forward, rows)
        .into_iter()
        .map(|(_, positions)| positions)
        .collect()
}

/// The observables `rows` by wing: positions among them.
pub fn by_wing(forward: &dyn Forward, rows: &[usize]) -> Vec<Vec<usize>> {
    let mut wings: Vec<(&str, Vec<usize>)> = Vec::new();
    for (condition, positions) in conditions_of(forward, rows) {
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
    use crate::study::forward::toy::{condition, reading};
    use crate::study::{Discrepancy, Observable};

    fn noise(size: usize, sigma: f64, admitted: f64) -> Noise {
        let observables: Vec<Observable> = (0..size).map(|_| reading(1, 0.0, sigma)).collect();
        let rows: Vec<usize> = (0..size).collect();
        Noise::new(
            &observables,
            &[condition()],
            &rows,
            &Discrepancy::of_predictions(admitted, &DVector::from_element(size, 1.0)),
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
            ends: Vec::new(),
        };
        let groups = [vec![0, 1, 2], vec![3, 4]];
        let left = Others::new(&local, &noise(5, 0.5, 0.0))
            .leave_out(&groups)
            .unwrap();
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

    #[test]
    fn what_a_common_error_of_the_model_would_tell_is_no_prediction_of_the_model() {
        // the same error of the model everywhere: the others tell it, the model, which stands at its means, does not know it
        let local = Local {
            at_means: DVector::from_element(4, 2.0),
            slopes: DMatrix::from_element(4, 1, 1e-6),
            rows: (0..4).collect(),
            ends: Vec::new(),
        };
        let left = Others::new(&local, &noise(4, 0.1, 2.0))
            .leave_out(&[vec![0, 1], vec![2, 3]])
            .unwrap();
        for error in left.iter().flat_map(|left| &left.errors) {
            assert!((error - 2.0).abs() < 1e-3, "{error}");
        }
    }

    #[test]
    fn one_unknown_more_is_a_fit_with_one_unknown_more() {
        let slopes = DMatrix::from_fn(5, 2, |i, j| 3.0 * (i as f64).powi(j as i32));
        let whole = Local {
            at_means: DVector::from_vec(vec![1.0, 1.5, 2.5, 2.0, 5.0]),
            slopes: slopes.clone(),
            rows: (0..5).collect(),
            ends: Vec::new(),
        };
        let less = Local {
            slopes: slopes.columns(0, 1).into_owned(),
            ..whole.clone()
        };
        let (noise, groups) = (noise(5, 0.5, 0.3), [vec![0, 1], vec![2], vec![3, 4]]);
        let more = Others::new(&less, &noise).with(&slopes.column(1).into_owned());
        for (a, b) in more
            .leave_out(&groups)
            .unwrap()
            .iter()
            .zip(Others::new(&whole, &noise).leave_out(&groups).unwrap())
        {
            assert!((a.ln_density - b.ln_density).abs() < 1e-9);
            for (a, b) in a.errors.iter().zip(&b.errors) {
                assert!((a - b).abs() < 1e-9, "{a} {b}");
            }
        }
    }

    #[test]
    fn an_unknown_at_the_end_of_its_range_is_held_there() {
        let slopes = DMatrix::from_fn(5, 2, |i, j| 3.0 * (i as f64).powi(j as i32));
        let at_means = DVector::from_vec(vec![1.0, 1.5, 2.5, 2.0, 5.0]);
        let (noise, groups) = (noise(5, 0.5, 0.3), [vec![0, 1], vec![2, 3, 4]]);
        let with = |slopes: DMatrix<f64>, at_means: DVector<f64>, ends: Vec<(usize, f64)>| {
            let local = Local {
                at_means,
                slopes,
                rows: (0..5).collect(),
                ends,
            };
            Others::new(&local, &noise).leave_out(&groups).unwrap()
        };
        let one = slopes.columns(0, 1).into_owned();
        // at its mean it tells as much as if it were not there
        let there = with(slopes.clone(), at_means.clone(), vec![(1, 0.0)]);
        assert_eq!(there, with(one.clone(), at_means.clone(), Vec::new()));
        let moved = &at_means - slopes.column(1) * 0.4;
        let there = with(slopes, at_means, vec![(1, 0.4)]);
        assert_eq!(there, with(one, moved, Vec::new()));
    }
}
