//! Causes without a name, fitted: where the linear fields of [`super::fields`] look from the wrong place, because calibration has taken
//! up most of what is missing and the wing answers to it no longer in proportion.

use nalgebra::{DMatrix, DVector};

use crate::progress::Progress;
use crate::study::left_out::Local;
use crate::study::unnamed::{Kind, UNNAMED};
use crate::study::{Fit, UnknownKind};

use super::baseline::Baseline;
use super::error::DiagnoseError;
use super::evidence::ln_sum;
use super::fields::{AMPLITUDES, Field, fields};
use super::refit::{Refits, ln_determinant};
use super::whitened::Whitened;

/// Where fits start, the second if the first settles nowhere: place along the span, and size in standard deviations.
const STARTS: [[f64; 2]; 2] = [[0.6, 0.1], [0.35, -0.1]];

/// Q above that of the best cause at which another is of no use: its evidence is e⁻²⁰ of it.
const HOPELESS: f64 = 40.0;

/// One cause without a name, fitted with everything that the model has.
#[derive(Debug, Clone)]
pub struct Bump {
    /// What kind of thing it is.
    pub kind: Kind,
    /// Logarithm of the evidence, by which the bumps are told from one another.
    pub ln_evidence: f64,
    /// The fit.
    pub fit: Fit,
    /// The data about it.
    pub local: Local,
    /// Index of the unknown that is its size.
    pub size: usize,
}

/// All that were tried.
#[derive(Debug, Clone, Default)]
pub struct Bumps {
    /// Those that were fitted.
    pub fitted: Vec<Bump>,
    /// Those whose fit settled nowhere.
    pub unsettled: Vec<Kind>,
}

impl Bump {
    /// Of a fit; none if its size moves no reading.
    fn new(baseline: &Baseline, kind: Kind, fit: Fit, size: usize) -> Option<Bump> {
        let local = Local::about(&fit, baseline.forward, &baseline.scatter.noise);
        let ln_evidence = ln_evidence(baseline, &fit, &local, size)?;
        Some(Bump {
            kind,
            ln_evidence,
            fit,
            local,
            size,
        })
    }
}

/// A fit of each cause without a name that can act.
///
/// # Errors
/// If the user asked to stop.
pub fn bumps(baseline: &Baseline, refits: &Refits, progress: &Progress) -> Result<Bumps, DiagnoseError> {
    let unknowns = baseline.forward.unknowns();
    let mut found = Bumps::default();
    for cause in &UNNAMED {
        let is_its =
            |kind: &UnknownKind| matches!(kind, UnknownKind::Unnamed { cause: own } if own == cause.name);
        let own: Vec<usize> = (0..unknowns.len())
            .filter(|&i| is_its(&unknowns[i].kind))
            .collect();
        let &[size, place, ..] = own.as_slice() else {
            continue;
        };
        progress.say(format_args!("fit of a cause without a name: {}", cause.name));
        let free: Vec<usize> = baseline.data.model.iter().chain(&own).copied().collect();
        let mut settled = None;
        for [at_place, at_size] in STARTS {
            progress.check()?;
            let mut start = baseline.fit.at.clone();
            start[place] = at_place;
            start[size] = at_size * unknowns[size].sigma;
            let least = found.fitted.iter().map(|bump| bump.fit.q).min_by(f64::total_cmp);
            let from = (free.as_slice(), start.as_slice());
            let fit = refits.scatter.fit_below(
                least.map(|q| q + HOPELESS),
                baseline.forward,
                refits.data,
                from,
                refits.warm_start,
            );
            match fit {
                Ok(fit) => {
                    settled = Bump::new(baseline, cause.kind, fit, size);
                    break;
                }
                Err(DiagnoseError::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(_) => {}
            }
        }
        match settled {
            Some(bump) => found.fitted.push(bump),
            None => found.unsettled.push(cause.kind),
        }
    }
    Ok(found)
}

/// Evidence of a fit in which the unknown `size` was free, whose prior is that of the fields: it moves the readings by a share of what is
/// predicted.
fn ln_evidence(baseline: &Baseline, fit: &Fit, local: &Local, size: usize) -> Option<f64> {
    let unknowns = baseline.forward.unknowns();
    let column = fit.free.iter().position(|&i| i == size)?;
    let parameters = fit.slopes.ncols();
    let curvature = DMatrix::identity(parameters, parameters) + fit.slopes.transpose() * &fit.slopes;
    let laplace = baseline.likelihood.ln(fit.q) - 0.5 * ln_determinant(curvature);
    let (mut predicted, mut responded) = (0.0, 0.0);
    for (position, &row) in local.rows.iter().enumerate() {
        let sigma = baseline.forward.observables()[row].sigma;
        predicted += (fit.predicted[row] / sigma).powi(2);
        responded += (local.slopes[(position, column)] / sigma).powi(2);
    }
    // its size over the standard deviation by which it was fitted, and the same of one that moves the readings as far as they go
    let found = fit.at[size] / unknowns[size].sigma;
    let whole = (predicted / responded).sqrt();
    if !whole.is_finite() {
        return None;
    }
    Some(laplace + ln_over_unit(found, whole))
}

/// Logarithm of the prior of a size over the unit normal by which it was fitted. The prior is a normal for each amplitude; `whole` is
/// the size at which the readings move as far as they go.
fn ln_over_unit(found: f64, whole: f64) -> f64 {
    let density = AMPLITUDES.map(|amplitude| {
        let wide = amplitude * whole;
        -0.5 * (found / wide).powi(2) - wide.ln() - (AMPLITUDES.len() as f64).ln()
    });
    0.5 * found * found + ln_sum(density.into_iter())
}

/// The data about a bump, without it: where the fields are what they are linear about.
pub struct Around {
    /// The data.
    pub whitened: Whitened,
    /// Responses of all observables to a moment at each station.
    pub moment: DMatrix<f64>,
    /// Predictions with the bump.
    pub value: DVector<f64>,
    /// Fields that have no name.
    pub fields: Vec<Field>,
}

impl Around {
    /// About the fit of a bump.
    ///
    /// # Errors
    /// If the model has no solution there.
    pub fn new(baseline: &Baseline, bump: &Bump) -> Result<Around, DiagnoseError> {
        let (forward, data, noise) = (baseline.forward, &baseline.data, &baseline.scatter.noise);
        let fit = &bump.fit;
        let column = |unknown: usize| fit.free.iter().position(|&i| i == unknown);
        let model: Vec<usize> = data.model.iter().filter_map(|&i| column(i)).collect();
        let mut bare = fit.clone();
        if let Some(size) = column(bump.size) {
            let found = fit.at[bump.size] / forward.unknowns()[bump.size].sigma;
            bare.residual += fit.slopes.column(size) * found;
        }
        bare.free = data.model.clone();
        bare.slopes = fit.slopes.select_columns(&model);
        let whitened = Whitened::new(&Local::about(&bare, forward, noise), noise)?;
        let mut moment =
            forward.moment_response_from(fit.warm_start.as_ref(), &fit.at, baseline.moment.ncols())?;
        for row in data.kept_bounds(forward, &fit.predicted) {
            moment.row_mut(row).fill(0.0);
        }
        let fields = fields(forward, data, &moment, &fit.predicted);
        Ok(Around {
            whitened,
            moment,
            value: fit.predicted.clone(),
            fields,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prior_of_a_size_is_a_density_as_wide_as_its_amplitudes() {
        for whole in [0.5, 3.0] {
            let step = 1e-3 * whole;
            let unit = |x: f64| (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt();
            let (mut sum, mut square) = (0.0, 0.0);
            for i in -8000..=8000 {
                let x = f64::from(i) * step;
                let density = unit(x) * ln_over_unit(x, whole).exp() * step;
                sum += density;
                square += density * x * x;
            }
            assert!((sum - 1.0).abs() < 1e-9, "{whole}: {sum}");
            let amplitudes = AMPLITUDES.map(|amplitude| (amplitude * whole).powi(2));
            let mean = amplitudes.iter().sum::<f64>() / AMPLITUDES.len() as f64;
            assert!((square / mean - 1.0).abs() < 1e-9, "{whole}: {square} for {mean}");
        }
    }
}
