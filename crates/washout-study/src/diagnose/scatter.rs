//! The scatter of the fitted readings, and fits by it.

use nalgebra::DMatrix;

use crate::study::{Fit, Forward, Noise, Task, WarmStart, calibrate};

use super::data::Data;
use super::error::DiagnoseError;
use super::model_error::{ModelError, Size};

/// The scatter that is assumed of the fitted observables.
#[derive(Debug, Clone)]
pub struct Scatter {
    /// Factor on the stated standard deviations.
    pub scale: f64,
    /// Further factor for each fitted observable: larger than 1 for outliers.
    pub widening: Vec<f64>,
    /// Covariance.
    pub covariance: DMatrix<f64>,
    /// The same, ready to weigh by.
    pub noise: Noise,
}

impl Scatter {
    /// Of readings, mesh and formulation at one size of these errors; `widening`: what `error` holds of outliers.
    ///
    /// # Errors
    /// If a standard deviation is not positive.
    pub fn new(error: &ModelError, size: &Size, widening: Vec<f64>) -> Result<Scatter, DiagnoseError> {
        let covariance = error.of_readings(size);
        Ok(Scatter {
            scale: size.scale,
            widening,
            noise: Noise::of_covariance(covariance.clone())?,
            covariance,
        })
    }

    /// The same with one more error.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn with(&self, more: &DMatrix<f64>) -> Result<Scatter, DiagnoseError> {
        let covariance = &self.covariance + more;
        Ok(Scatter {
            noise: Noise::of_covariance(covariance.clone())?,
            covariance,
            ..self.clone()
        })
    }

    /// Fits `free` from `start`; `warm_start`: what the model left near there.
    ///
    /// # Errors
    /// If the model has no solution there or the search does not settle.
    pub fn fit(
        &self,
        forward: &dyn Forward,
        data: &Data,
        free: &[usize],
        start: &[f64],
        warm_start: Option<&WarmStart>,
    ) -> Result<Fit, DiagnoseError> {
        self.fit_below(None, forward, data, (free, start), warm_start)
    }

    /// The same, given up where it stays far above the Q below which it is of use, if there is one.
    ///
    /// # Errors
    /// As [`Scatter::fit`], and if it is given up.
    pub fn fit_below(
        &self,
        of_use_below: Option<f64>,
        forward: &dyn Forward,
        data: &Data,
        (free, start): (&[usize], &[f64]),
        warm_start: Option<&WarmStart>,
    ) -> Result<Fit, DiagnoseError> {
        let task = Task {
            rows: &data.rows,
            noise: &self.noise,
            free,
            start,
            warm_start,
            of_use_below,
        };
        let fit = calibrate(forward, &task)?;
        if fit.q.is_finite() && fit.slopes.iter().all(|slope| slope.is_finite()) {
            return Ok(fit);
        }
        Err(DiagnoseError::NotFinite {
            what: "the fitted unknowns".into(),
        })
    }
}
