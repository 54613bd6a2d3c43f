//! The scale of the noise, from the part of the residual that nothing smooth could have made.

use nalgebra::{DMatrix, DVector};

use super::whitened::Whitened;

/// Share of the numbers that smooth things may take.
const SMOOTH_SHARE: f64 = 0.65;
/// Smooth directions below this size, in standard deviations of the noise, are left to the noise.
const VISIBLE: f64 = 0.3;
/// Fewest numbers by which the scale of the noise can be estimated.
pub const FEWEST: usize = 24;

/// Orthonormal basis of everything that is smooth.
#[derive(Debug, Clone)]
pub struct Smooth {
    basis: DMatrix<f64>,
}

impl Smooth {
    /// Of what was fitted, and of `columns` (of unit prior variance) in the order of how visible they are.
    pub fn new(whitened: &Whitened, columns: &DMatrix<f64>) -> Smooth {
        let size = whitened.residual.len();
        let fitted = orthonormal(&whitened.slopes);
        let rest = columns - &fitted * (fitted.transpose() * columns);
        let eigen = (&rest * rest.transpose()).symmetric_eigen();
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
        let room = ((SMOOTH_SHARE * size as f64) as usize).saturating_sub(fitted.ncols());
        let taken: Vec<usize> = order
            .into_iter()
            .filter(|&k| eigen.eigenvalues[k] > VISIBLE * VISIBLE)
            .take(room)
            .collect();
        let mut basis = DMatrix::zeros(size, fitted.ncols() + taken.len());
        basis.columns_mut(0, fitted.ncols()).copy_from(&fitted);
        for (k, &from) in taken.iter().enumerate() {
            basis.set_column(fitted.ncols() + k, &eigen.eigenvectors.column(from));
        }
        Smooth { basis }
    }

    /// Numbers that nothing smooth takes.
    pub fn freedom(&self) -> usize {
        self.basis.nrows() - self.basis.ncols()
    }

    /// Squares of the rough part of each column of `errors`.
    pub fn rough_squares(&self, errors: &DMatrix<f64>) -> DVector<f64> {
        let smooth = self.basis.transpose() * errors;
        DVector::from_fn(errors.ncols(), |k, _| {
            (errors.column(k).norm_squared() - smooth.column(k).norm_squared()).max(0.0)
        })
    }

    /// Variance of the noise in units of what was assumed; `trust`: numbers that the assumption is worth.
    pub fn variance(&self, rough_square: f64, trust: usize) -> f64 {
        (trust as f64 + rough_square) / (trust + self.freedom()) as f64
    }
}

fn orthonormal(columns: &DMatrix<f64>) -> DMatrix<f64> {
    if columns.ncols() == 0 {
        return columns.clone();
    }
    let mut basis: Vec<DVector<f64>> = Vec::new();
    for column in columns.column_iter() {
        let length = column.norm();
        let mut rest = column.into_owned();
        for _ in 0..2 {
            for known in &basis {
                rest -= known * known.dot(&rest);
            }
        }
        let left = rest.norm();
        if left > 1e-9 * length && left > 0.0 {
            basis.push(rest / left);
        }
    }
    if basis.is_empty() {
        return DMatrix::zeros(columns.nrows(), 0);
    }
    DMatrix::from_columns(&basis)
}
