//! The model as it is: fitted, with the scatter that the data show, and every direction in which it could be wrong.

use nalgebra::{DMatrix, DVector};

use crate::progress::Progress;
use crate::study::calibrate::misfit;
use crate::study::left_out::Local;
use crate::study::{AdmittedError, Fit, Footing, Forward, Work};

use super::data::{Data, Scatter, start};
use super::error::DiagnoseError;
use super::evidence::Likelihood;
use super::fields::{Field, Law, fields};
use super::novel::seen;
use super::null::{NullTest, Scale, Significance};
use super::refit::{Explanation, Refits};
use super::robust::outlier_widening;
use super::rough::{FEWEST, Smooth};
use super::screening::{Directions, Slopes, is_one_sided, slopes_of_missing};
use super::settings::Settings;
use super::whitened::Whitened;
use crate::study::draws::Draws;

/// Size of the fields that count as smooth when the noise is judged, over that of the prediction.
const SMOOTH_AMPLITUDE: f64 = 0.3;
/// An explanation counts as calmer if the data scatter less about it than this share.
const CALMER: f64 = 0.8;
/// Rounds in which the scale of the noise settles.
const ROUNDS: usize = 3;

/// The model as it is, seen in the data.
pub struct Baseline<'a> {
    /// The model.
    pub forward: &'a dyn Forward,
    /// What the user said.
    pub settings: &'a Settings,
    /// What is fitted.
    pub data: Data,
    /// Predictions where the unknowns start.
    pub raw: DVector<f64>,
    /// The error that is admitted of the model.
    pub admitted: AdmittedError,
    /// Scatter that the data show.
    pub scatter: Scatter,
    /// The fit.
    pub fit: Fit,
    /// The data about it.
    pub local: Local,
    /// The same, whitened.
    pub whitened: Whitened,
    /// Derivatives with the missing effects, per prior standard deviation.
    pub slopes: DMatrix<f64>,
    /// Directions of the missing effects.
    pub directions: Directions,
    /// Responses of all observables to a moment at each station, those of bounds that are kept left out.
    pub moment: DMatrix<f64>,
    /// Fields that have no name.
    pub fields: Vec<Field>,
    /// Their columns, whitened.
    pub seen: Vec<DMatrix<f64>>,
    /// How the noise enters.
    pub likelihood: Likelihood,
    /// What the derivatives with every effect took; nothing if another diagnosis found them.
    pub screening: Work,
    /// What the model left at the first fit, with all derivatives.
    pub footing: Option<Footing>,
    /// Missing effects (positions) of which nothing is known: no derivative, and no solution at their plausible size.
    pub unanswered: Vec<usize>,
}

impl<'a> Baseline<'a> {
    /// Fits the model and looks around; `shared`: how another diagnosis found it to answer nearby, which is taken over.
    ///
    /// # Errors
    /// If there is nothing to fit, a result is not finite, or the user asked to stop.
    pub fn new(
        forward: &'a dyn Forward,
        settings: &'a Settings,
        shared: Option<&Shared>,
        progress: &Progress,
    ) -> Result<Baseline<'a>, DiagnoseError> {
        settings.check()?;
        let start = start(forward, settings)?;
        let data = Data::new(forward, &start)?;
        let size = data.rows.len();
        progress.say("fitting the model as it is");
        let raw = forward.predict(&start)?;
        if raw.iter().any(|value| !value.is_finite()) {
            return Err(DiagnoseError::NotFinite {
                what: "its start".into(),
            });
        }
        let glanced = AdmittedError::of_predictions(settings.slop, &raw);
        let stated = Scatter::new(forward, &data, &glanced, 1.0, vec![1.0; size])?;
        let footing = shared.and_then(|shared| shared.slopes.footing.as_ref());
        let first = stated.fit(forward, &data, &data.model, &start, footing)?;
        progress.check()?;
        let before = forward.work();
        let Shared {
            slopes:
                Slopes {
                    missing: slopes,
                    mut admitted,
                    footing,
                    unanswered,
                },
            mut moment,
        } = match shared {
            Some(shared) => shared.clone(),
            None => Shared::at(
                forward,
                &data,
                &first.at,
                settings,
                first.footing.as_ref(),
                progress,
            )?,
        };
        let screening = forward.work() - before;
        admitted.value = first.predicted.clone();
        let kept = data.kept_bounds(forward, &first.predicted);
        for &row in &kept {
            moment.row_mut(row).fill(0.0);
        }
        progress.check()?;
        let fields = fields(forward, &data, &moment, &admitted.value);
        let local = Local::about(&first, forward, &stated.noise);
        let glance = Glance {
            forward,
            settings,
            data: &data,
            local: &local,
            slopes: &slopes,
            fields: &fields,
            admitted: &admitted,
        };
        let widening = glance.outliers();
        let scatter = glance.settle(widening)?;
        progress.say("fitting the model with the scatter that the data show");
        let fit = scatter.fit(forward, &data, &data.model, &first.at, footing.as_ref())?;
        let local = Local::about(&fit, forward, &scatter.noise);
        let whitened = Whitened::new(&local, &scatter.noise)?;
        let directions = Directions::new(&data, &slopes, &whitened);
        let seen = seen(&fields, &whitened);
        let likelihood = Likelihood::of(size - kept.len(), settings);
        Ok(Baseline {
            forward,
            settings,
            data,
            raw,
            admitted,
            scatter,
            fit,
            local,
            whitened,
            slopes,
            directions,
            moment,
            fields,
            seen,
            likelihood,
            screening,
            footing,
            unanswered,
        })
    }

    /// The same with the scatter that the data show about an explanation, if that is clearly less than about the model as it
    /// is: what is missing may be too large and too crooked to count as smooth there.
    ///
    /// # Errors
    /// As [`Baseline::new`].
    pub fn calmed(
        &self,
        explanation: &Explanation,
        progress: &Progress,
    ) -> Result<Option<Baseline<'a>>, DiagnoseError> {
        let (Some(local), Some(found)) = (&explanation.local, &explanation.fit) else {
            return Ok(None);
        };
        let admitted = AdmittedError {
            value: found.predicted.clone(),
            ..self.admitted.clone()
        };
        let glance = Glance {
            forward: self.forward,
            settings: self.settings,
            data: &self.data,
            local,
            slopes: &self.slopes,
            fields: &self.fields,
            admitted: &admitted,
        };
        let widening = glance.outliers();
        let scatter = glance.settle(widening)?;
        if scatter.scale > CALMER * self.scatter.scale {
            return Ok(None);
        }
        progress.say("fitting the model with the scatter that the data show about the best explanation");
        let footing = self.footing.as_ref();
        let fit = scatter.fit(self.forward, &self.data, &self.data.model, &self.fit.at, footing)?;
        let local = Local::about(&fit, self.forward, &scatter.noise);
        let whitened = Whitened::new(&local, &scatter.noise)?;
        Ok(Some(Baseline {
            forward: self.forward,
            settings: self.settings,
            data: self.data.clone(),
            raw: self.raw.clone(),
            directions: Directions::new(&self.data, &self.slopes, &whitened),
            seen: seen(&self.fields, &whitened),
            moment: self.moment.clone(),
            fields: self.fields.clone(),
            slopes: self.slopes.clone(),
            likelihood: self.likelihood,
            screening: self.screening,
            footing: self.footing.clone(),
            unanswered: self.unanswered.clone(),
            admitted,
            scatter,
            fit,
            local,
            whitened,
        }))
    }

    /// What fits with effects start from; `footing`: what the model left at the fit.
    pub fn refits<'b>(&'b self, footing: Option<&'b Footing>) -> Refits<'b> {
        Refits {
            forward: self.forward,
            data: &self.data,
            scatter: &self.scatter,
            baseline: &self.fit,
            slopes: &self.slopes,
            footing,
            likelihood: self.likelihood,
        }
    }

    /// Whether the scale of the noise is taken on trust, for want of numbers.
    pub fn on_trust(&self) -> bool {
        self.settings.noise_scale.is_none() && self.data.rows.len() < FEWEST
    }

    /// Significance of the residual about a fit, against these directions and all fields.
    pub fn significance(&self, whitened: &Whitened, directions: &Directions) -> Significance {
        let fields = seen(&self.fields, whitened);
        let scale = if self.settings.noise_scale.is_some() {
            Scale::Known
        } else if self.on_trust() {
            Scale::Trusted(self.settings.noise_trust)
        } else {
            let columns = smooth_columns(&self.fields, &fields, &directions.columns);
            Scale::Estimated(self.settings.noise_trust, Smooth::new(whitened, &columns))
        };
        let unknowns = self.forward.unknowns();
        let one_sided: Vec<bool> = directions
            .unknowns
            .iter()
            .map(|&i| is_one_sided(&unknowns[i]))
            .collect();
        NullTest::new(&directions.columns, &one_sided, &fields, scale).significance(
            &whitened.residual,
            &whitened.rotation_to_readings(),
            Draws::new(self.settings.seed),
            self.settings.draws,
        )
    }
}

/// Everything smooth, of unit prior variance.
fn smooth_columns(fields: &[Field], seen: &[DMatrix<f64>], directions: &DMatrix<f64>) -> DMatrix<f64> {
    let smooth = fields.iter().zip(seen).filter(|(field, _)| is_smooth(field.law));
    let parts: Vec<DMatrix<f64>> = smooth
        .map(|(_, columns)| columns * SMOOTH_AMPLITUDE)
        .chain([directions.clone()])
        .collect();
    side_by_side(&parts)
}

fn is_smooth(law: Law) -> bool {
    matches!(law, Law::Free | Law::Sensor | Law::Compliance)
}

fn side_by_side(parts: &[DMatrix<f64>]) -> DMatrix<f64> {
    let rows = parts.first().map_or(0, |part| part.nrows());
    let columns: Vec<DVector<f64>> = parts
        .iter()
        .flat_map(|part| {
            part.column_iter()
                .map(|column| column.into_owned())
                .collect::<Vec<_>>()
        })
        .collect();
    if columns.is_empty() {
        return DMatrix::zeros(rows, 0);
    }
    DMatrix::from_columns(&columns)
}

/// How a model answers about one point: to every effect, and to a moment at each station.
#[derive(Debug, Clone)]
pub struct Shared {
    slopes: Slopes,
    moment: DMatrix<f64>,
}

impl Shared {
    /// Where the unknowns start: for many diagnoses of one campaign with other readings.
    ///
    /// # Errors
    /// As [`Baseline::new`].
    pub fn new(
        forward: &dyn Forward,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Shared, DiagnoseError> {
        settings.check()?;
        let start = start(forward, settings)?;
        let data = Data::new(forward, &start)?;
        Shared::at(forward, &data, &start, settings, None, progress)
    }

    fn at(
        forward: &dyn Forward,
        data: &Data,
        at: &[f64],
        settings: &Settings,
        footing: Option<&Footing>,
        progress: &Progress,
    ) -> Result<Shared, DiagnoseError> {
        progress.say("derivatives with every effect");
        let slopes = slopes_of_missing(forward, data, at, settings, footing)?;
        let moment = forward.moment_response_from(slopes.footing.as_ref(), at, settings.stations)?;
        Ok(Shared { slopes, moment })
    }
}

/// The first fit and all that could be wrong with it, before the scatter is known.
struct Glance<'a> {
    forward: &'a dyn Forward,
    settings: &'a Settings,
    data: &'a Data,
    local: &'a Local,
    slopes: &'a DMatrix<f64>,
    fields: &'a [Field],
    admitted: &'a AdmittedError,
}

impl Glance<'_> {
    /// Factors for numbers that are far from what all the others tell, whatever is missing.
    fn outliers(&self) -> Vec<f64> {
        let rows = &self.data.rows;
        if rows.len() < FEWEST {
            return vec![1.0; rows.len()];
        }
        let observables = self.forward.observables();
        let inverse = rows.iter().map(|&row| 1.0 / observables[row].sigma);
        let inverse = DVector::from_iterator(rows.len(), inverse);
        let errors = rows
            .iter()
            .map(|&row| misfit(&observables[row], self.admitted.value[row]));
        let residual = DVector::from_iterator(rows.len(), errors).component_mul(&inverse);
        let mut parts = vec![self.local.slopes.clone(), self.slopes.select_rows(rows.iter())];
        let smooth = self.fields.iter().filter(|field| is_smooth(field.law));
        parts.extend(smooth.map(|field| &field.columns * SMOOTH_AMPLITUDE));
        let columns = DMatrix::from_diagonal(&inverse) * side_by_side(&parts);
        outlier_widening(&residual, &columns)
    }

    /// The scatter whose scale agrees with the rough part of the residual.
    fn settle(&self, widening: Vec<f64>) -> Result<Scatter, DiagnoseError> {
        let settings = self.settings;
        let mut scale = settings.noise_scale.unwrap_or(1.0);
        let is_estimated = settings.noise_scale.is_none() && self.data.rows.len() >= FEWEST;
        let rounds = if is_estimated { ROUNDS } else { 0 };
        for _ in 0..rounds {
            let scatter = self.scatter(scale, &widening)?;
            let whitened = Whitened::new(self.local, &scatter.noise)?;
            let directions = Directions::new(self.data, self.slopes, &whitened);
            let seen = seen(self.fields, &whitened);
            let smooth = Smooth::new(
                &whitened,
                &smooth_columns(self.fields, &seen, &directions.columns),
            );
            let size = whitened.residual.len();
            let residual = DMatrix::from_column_slice(size, 1, whitened.residual.as_slice());
            let rough = smooth.rough_squares(&residual)[0] * scale * scale;
            scale = smooth.variance(rough, settings.noise_trust).sqrt();
        }
        self.scatter(scale, &widening)
    }

    fn scatter(&self, scale: f64, widening: &[f64]) -> Result<Scatter, DiagnoseError> {
        let widening = widening.to_vec();
        Scatter::new(self.forward, self.data, self.admitted, scale, widening)
    }
}
