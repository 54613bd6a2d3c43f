//! How probable a cause without a name is: an error of the readings that is smooth along the span and larger than any formulation should
//! have, or a field of moment, spring or softness that the wing answers to, smooth over the span or at one place.
//!
//! A field acts through the wing: it moves what lies outboard of it, the soft wing more than the stiff one, the fast stroke more than the
//! slow one. What acts so is far more probable under it than under an error of the readings that may be anything, and without it would go
//! to whatever pair of effects happens to bend to it. Fields are linear about the first fit, and are known no better than effects are: v ~ N(0, I) of columns a·C adds a²·C·Cᵀ to
//! the covariance, and |I + a²·G| and (I + a²·G)⁻¹ with G = Cᵀ·Σ⁻¹·C are all that is needed of it (matrix determinant lemma).

use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::error::DiagnoseError;
use super::evidence::ln_sum;
use super::fields::{AMPLITUDES, Field, share};
use super::weights::{Level, Weights};

/// Prior shares of errors of the readings, of fields over the span and of fields at one place.
const ERRORS: f64 = 0.4;
const SMOOTH: f64 = 0.3;
const LOCAL: f64 = 0.3;
/// Share to which the change by a field is known: it is linear about the first fit, and its shape is that of no real thing. Assumed; so are the
/// prior shares above.
const OWN_ERROR: f64 = 0.15;

/// ln of the probability of a size by nothing and by errors of the readings, over that of the most probable, below which no field is weighed
/// with it: half as much again as what no effect is weighed with.
const IMPROBABLE: f64 = -15.0;

/// ln of the density of the readings under each cause without a name (column) for every size (row), the priors of both in it; −∞ for fields at
/// sizes that are improbable. `of_sizes`: ln of how probable nothing makes each size, over the prior of a cause without a name.
///
/// # Errors
/// If a covariance is not positive definite.
pub fn unknown(weights: &Weights, fields: &[Field], of_sizes: &[f64]) -> Result<DMatrix<f64>, DiagnoseError> {
    let plain = weights.less(&DMatrix::zeros(weights.residual.len(), 1));
    let errors = weights.error.unknown();
    let ln_error = (ERRORS / errors.len() as f64).ln();
    let of_errors: Vec<DMatrix<f64>> = errors
        .into_par_iter()
        .map(|own| Ok(weights.of(Some(&own), &plain)?.add_scalar(ln_error)))
        .collect::<Result<_, DiagnoseError>>()?;
    let likely: Vec<f64> = of_sizes
        .iter()
        .enumerate()
        .map(|(level, ln)| ln_sum(of_errors.iter().map(|own| own[(level, 0)]).chain([*ln])))
        .collect();
    let most = likely.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let of_fields: Vec<Vec<f64>> = (0..weights.levels.len())
        .into_par_iter()
        .map(|level| match likely[level] > most + IMPROBABLE {
            true => of_fields(weights, &weights.levels[level], &plain, fields),
            false => Ok(Vec::new()),
        })
        .collect::<Result<_, _>>()?;
    let count = of_fields.iter().map(Vec::len).max().unwrap_or(0);
    let mut found = DMatrix::from_fn(
        of_fields.len(),
        of_errors.len() + count,
        |row, column| match column.checked_sub(of_errors.len()) {
            None => of_errors[column][(row, 0)],
            Some(field) => of_fields[row].get(field).copied().unwrap_or(f64::NEG_INFINITY),
        },
    );
    // a prior that no field takes up is that of errors of the readings
    if count == 0 {
        found.add_scalar_mut(-ERRORS.ln());
    }
    Ok(found)
}

/// The same of all fields for one size of the errors.
fn of_fields(
    weights: &Weights,
    level: &Level,
    plain: &DMatrix<f64>,
    fields: &[Field],
) -> Result<Vec<f64>, DiagnoseError> {
    let of_local: f64 = fields
        .iter()
        .filter(|field| field.local.ncols() > 0)
        .map(|field| share(field.law, fields))
        .sum();
    let mut found = Vec::new();
    for field in fields {
        let own = share(field.law, fields) / AMPLITUDES.len() as f64;
        let width = field.columns.ncols();
        let mut columns = plain
            .clone()
            .resize_horizontally(1 + width + field.local.ncols(), 0.0);
        columns.columns_mut(1, width).copy_from(&field.columns);
        columns
            .columns_mut(1 + width, field.local.ncols())
            .copy_from(&field.local);
        let size = field.columns.row_iter().map(|row| row.norm());
        let size = DVector::from_iterator(field.columns.nrows(), size);
        for amplitude in AMPLITUDES {
            let error = weights.error.own(&(&size * amplitude), OWN_ERROR, 1.0);
            let root = level.root(Some(&error))?;
            let whitened = root.whiten(&columns);
            let residual = whitened.column(0).into_owned();
            let ln_plain = level.ln_size(&root) - 0.5 * residual.norm_squared();
            let smooth = whitened.columns(1, width);
            let ln = ln_gain(&smooth.tr_mul(&smooth), &smooth.tr_mul(&residual), amplitude)?;
            found.push(ln_plain + (SMOOTH * own).ln() + ln);
            let each = (LOCAL * own / of_local / field.local.ncols() as f64).ln();
            for local in whitened.columns(1 + width, field.local.ncols()).column_iter() {
                let gain = amplitude * amplitude;
                let whole = 1.0 + gain * local.norm_squared();
                let ln = 0.5 * (gain * local.dot(&residual).powi(2) / whole - whole.ln());
                found.push(ln_plain + each + ln);
            }
        }
    }
    Ok(found)
}

/// ln of the density with a field of this amplitude over that without.
fn ln_gain(gram: &DMatrix<f64>, seen: &DVector<f64>, amplitude: f64) -> Result<f64, DiagnoseError> {
    let gain = amplitude * amplitude;
    let whole = DMatrix::identity(gram.nrows(), gram.nrows()) + gram * gain;
    let root = Cholesky::new(whole).ok_or_else(|| DiagnoseError::NotFinite {
        what: "a cause without a name".into(),
    })?;
    let ln_determinant = 2.0 * root.l_dirty().diagonal().iter().map(|own| own.ln()).sum::<f64>();
    Ok(0.5 * (gain * seen.dot(&root.solve(seen)) - ln_determinant))
}
