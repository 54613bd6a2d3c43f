//! Numbers that are far from what all the others tell.

use nalgebra::{Cholesky, DMatrix, DVector};

/// Distance from what its neighbours tell, in standard deviations, beyond which a number is an outlier.
const OUTLIER: f64 = 4.0;
/// Degrees of freedom of the Student distribution by which outliers are weighed.
const STUDENT: f64 = 4.0;
/// Factor by which to widen the noise of each number: 1, or more for one that is far from what all the others tell.
///
/// `columns` hold everything smooth, with unit prior variance, in the units of `residual`; both whitened by the
/// measurement's noise alone, so that one number is one row. At most a tenth of the numbers are taken for outliers.
pub fn outlier_widening(residual: &DVector<f64>, columns: &DMatrix<f64>) -> Vec<f64> {
    let size = residual.len();
    let smooth = columns * columns.transpose();
    let mut widening = vec![1.0; size];
    for _ in 0..(size / 10).max(1) {
        let own = DVector::from_iterator(size, widening.iter().map(|wider: &f64| wider * wider));
        let Some(factor) = Cholesky::new(&smooth + DMatrix::from_diagonal(&own)) else {
            return widening;
        };
        let inverse = factor.inverse();
        let weighted = &inverse * residual;
        let distance = |i: usize| (weighted[i] / inverse[(i, i)].sqrt()).abs();
        let mut sizes: Vec<f64> = (0..size).map(distance).collect();
        sizes.sort_by(f64::total_cmp);
        let typical = (sizes[size / 2] / 0.6745).max(0.5);
        let farthest = (0..size)
            .filter(|&i| widening[i] == 1.0)
            .max_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        let Some(farthest) = farthest else { return widening };
        let far = distance(farthest) / typical;
        if far <= OUTLIER {
            return widening;
        }
        widening[farthest] = ((STUDENT + far * far) / (STUDENT + 1.0)).sqrt();
    }
    widening
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_number_far_from_its_neighbours_is_widened_and_no_other() {
        let size = 30;
        let columns = DMatrix::from_fn(size, 3, |i, j| 20.0 * (i as f64 / 30.0).powi(j as i32));
        let mut residual = DVector::from_fn(size, |i, _| {
            8.0 * (i as f64 / 30.0) + 0.8 * ((7 * i) as f64).sin()
        });
        assert_eq!(outlier_widening(&residual, &columns), vec![1.0; size]);
        residual[11] += 9.0;
        let found = outlier_widening(&residual, &columns);
        assert!(found[11] > 2.5, "{}", found[11]);
        assert!(found.iter().enumerate().all(|(i, &x)| i == 11 || x == 1.0));
    }
}
