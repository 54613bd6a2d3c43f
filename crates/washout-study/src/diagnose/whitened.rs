//! The data about one fit, with what was fitted integrated out: a residual and directions of unit covariance.
//!
//! With whitened residual r₀ (at the prior means) and slopes J per prior standard deviation, r₀ has covariance
//! M = I + J Jᵀ if nothing is missing. e = L⁻¹ r₀ with M = L Lᵀ is then N(0, I), and ‖e‖² is the least Q of the linear
//! fit. A direction g becomes L⁻¹ g: its length is what remains of it after the fitted unknowns, held by their priors,
//! have taken their part.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use crate::study::Noise;
use crate::study::left_out::Local;

use super::error::DiagnoseError;

/// The data about one fit.
#[derive(Debug, Clone)]
pub struct Whitened {
    /// Residual at the prior means, of unit covariance if nothing is missing.
    pub residual: DVector<f64>,
    /// Slopes of the fitted unknowns, likewise.
    pub slopes: DMatrix<f64>,
    /// Logarithm of the determinant of M.
    pub ln_determinant: f64,
    root: Cholesky<f64, Dyn>,
    noise: Noise,
    rows: Vec<usize>,
}

impl Whitened {
    /// About a fit, with scatter `noise`.
    ///
    /// # Errors
    /// If the slopes are not finite.
    pub fn new(local: &Local, noise: &Noise) -> Result<Whitened, DiagnoseError> {
        let size = local.at_means.len();
        let slopes = noise.whiten_columns(&local.slopes);
        let covariance = DMatrix::identity(size, size) + &slopes * slopes.transpose();
        let root = Cholesky::new(covariance).ok_or_else(|| DiagnoseError::NotFinite {
            what: "the fitted unknowns".into(),
        })?;
        let ln_determinant = 2.0 * root.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
        let at_means = noise.whiten(&local.at_means);
        let mut whitened = Whitened {
            residual: DVector::zeros(0),
            slopes: DMatrix::zeros(0, 0),
            ln_determinant,
            root,
            noise: noise.clone(),
            rows: local.rows.clone(),
        };
        whitened.slopes = whitened.free_of_fit(&slopes);
        let residual = DMatrix::from_column_slice(size, 1, at_means.as_slice());
        whitened.residual = whitened.free_of_fit(&residual).column(0).into_owned();
        Ok(whitened)
    }

    /// Directions in units of the observables (all of them × any number) brought to unit covariance.
    pub fn directions(&self, raw: &DMatrix<f64>) -> DMatrix<f64> {
        let chosen = raw.select_rows(self.rows.iter());
        self.directions_of_rows(&chosen)
    }

    /// The same for columns that hold the fitted observables only.
    pub fn directions_of_rows(&self, chosen: &DMatrix<f64>) -> DMatrix<f64> {
        self.free_of_fit(&self.noise.whiten_columns(chosen))
    }

    /// ‖e‖²: least Q of the linear fit.
    pub fn q(&self) -> f64 {
        self.residual.norm_squared()
    }

    fn free_of_fit(&self, whitened: &DMatrix<f64>) -> DMatrix<f64> {
        self.root
            .l_dirty()
            .solve_lower_triangular(whitened)
            .unwrap_or_else(|| whitened.clone())
    }
}
