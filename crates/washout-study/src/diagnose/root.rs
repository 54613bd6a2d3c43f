//! Root of a covariance: what brings readings to unit covariance. Found in blocks by faer; a diagnosis takes thousands of them.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltRegularization, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{MatMut, MatRef, Par, Spec};
use nalgebra::DMatrix;

use super::error::DiagnoseError;

/// Lower triangle L of a covariance L·Lᵀ.
#[derive(Debug, Clone)]
pub struct Root {
    /// Above its diagonal stands what is never read.
    lower: DMatrix<f64>,
    /// ln of the root of the determinant of the covariance.
    pub ln_determinant: f64,
}

impl Root {
    /// Of a covariance.
    ///
    /// # Errors
    /// If it is not positive definite: something is not finite.
    pub fn of(covariance: DMatrix<f64>) -> Result<Root, DiagnoseError> {
        let mut lower = covariance;
        let size = lower.nrows();
        let params = Spec::default();
        let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(size, Par::Seq, params));
        let found = cholesky_in_place(
            MatMut::from_column_major_slice_mut(lower.as_mut_slice(), size, size),
            LltRegularization::default(),
            Par::Seq,
            MemStack::new(&mut memory),
            params,
        );
        let ln_determinant: f64 = lower.diagonal().iter().map(|own| own.ln()).sum();
        match found {
            Ok(_) if ln_determinant.is_finite() => Ok(Root {
                lower,
                ln_determinant,
            }),
            _ => Err(DiagnoseError::NotFinite {
                what: "the uncertain inputs".into(),
            }),
        }
    }

    /// Columns brought to unit covariance: L⁻¹ times each.
    pub fn whiten(&self, columns: &DMatrix<f64>) -> DMatrix<f64> {
        let (size, mut whitened) = (self.lower.nrows(), columns.clone());
        let count = whitened.ncols();
        solve_lower_triangular_in_place(
            MatRef::from_column_major_slice(self.lower.as_slice(), size, size),
            MatMut::from_column_major_slice_mut(whitened.as_mut_slice(), size, count),
            Par::Seq,
        );
        whitened
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_whitened_has_the_inverse_of_the_covariance_as_its_product() {
        for size in [1, 7, 40, 130] {
            let draft = DMatrix::from_fn(size, size, |i, j| ((3 * i + 7 * j) as f64).sin());
            let covariance = &draft * draft.transpose() + DMatrix::identity(size, size);
            let root = Root::of(covariance.clone()).expect("a root");
            let whitened = root.whiten(&covariance);
            let back = whitened.tr_mul(&root.whiten(&DMatrix::identity(size, size)));
            let off = (back - DMatrix::<f64>::identity(size, size)).amax();
            assert!(off < 1e-11, "{size}: {off}");
            let ln_determinant = covariance.determinant().ln();
            assert!(
                (2.0 * root.ln_determinant - ln_determinant).abs() < 1e-9 * ln_determinant.abs().max(1.0)
            );
        }
    }

    #[test]
    fn a_covariance_that_is_none_is_refused() {
        for broken in [f64::NAN, -1.0, f64::INFINITY] {
            let mut covariance = DMatrix::identity(9, 9);
            covariance[(4, 4)] = broken;
            assert!(Root::of(covariance).is_err(), "{broken}");
        }
    }
}
