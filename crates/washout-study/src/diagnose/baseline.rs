//! The model as it is: fitted, with the errors that the data show, and how it answers to everything that could be missing.

use nalgebra::{DMatrix, DVector};

use crate::progress::Progress;
use crate::study::left_out::Local;
use crate::study::{Fit, Forward, WarmStart, Work};

use super::data::{Data, start};
use super::error::DiagnoseError;
use super::evidence::Likelihood;
use super::fields::{Field, Law, fields};
use super::library::{Family, Trial, families};
use super::model_error::{ModelError, Size};
use super::responses::{Response, Responses};
use super::robust::outlier_widening;
use super::scatter::Scatter;
use super::screening::{Directions, effect_of};
use super::settings::Settings;
use super::table::Table;
use super::weigh::{Weighing, weigh};
use super::weights::Seen;
use super::whitened::Whitened;

/// Size of the fields that count as smooth when outliers are looked for, over that of the prediction.
const SMOOTH_AMPLITUDE: f64 = 0.3;
/// Numbers from which on the scale of the scatter can be told from them.
const FEWEST: usize = 24;

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
    /// The error that is expected.
    pub error: ModelError,
    /// Its size that the data show.
    pub size: Size,
    /// The same for fits.
    pub scatter: Scatter,
    /// The fit.
    pub fit: Fit,
    /// The data about it.
    pub local: Local,
    /// The same, whitened.
    pub whitened: Whitened,
    /// What the model reads with each missing effect.
    pub responses: Responses,
    /// How far the data lie with each missing effect at its plausible size from without, in standard deviations, what calibration takes up
    /// left out; none where the model has no solution there.
    pub distances: Vec<Option<f64>>,
    /// Families of the missing effects that can be seen.
    pub families: Vec<Family>,
    /// How probable everything is.
    pub weighing: Weighing,
    /// Derivatives with the missing effects, per prior standard deviation.
    pub slopes: DMatrix<f64>,
    /// Directions of the missing effects.
    pub directions: Directions,
    /// Responses of all observables to a moment at each station, those of bounds that are kept left out.
    pub moment: DMatrix<f64>,
    /// Fields that have no name.
    pub fields: Vec<Field>,
    /// How the noise enters.
    pub likelihood: Likelihood,
    /// What the derivatives with every effect took; nothing if another diagnosis found them.
    pub screening: Work,
    /// What the model left at the first fit.
    pub warm_start: Option<WarmStart>,
}

/// The model fitted with the errors as they are stated.
struct FirstFit {
    start: Vec<f64>,
    /// Predictions at `start`.
    raw: DVector<f64>,
    /// Size of the error that is expected before any is seen.
    typical: Size,
    scatter: Scatter,
    fit: Fit,
}

/// Everything that may be missing, weighed about the first fit.
struct Weighed {
    weighing: Weighing,
    families: Vec<Family>,
    error: ModelError,
    /// Factors for numbers that are far from what all the others tell.
    widening: Vec<f64>,
}

impl FirstFit {
    fn new(
        forward: &dyn Forward,
        settings: &Settings,
        data: &Data,
        start: Vec<f64>,
    ) -> Result<FirstFit, DiagnoseError> {
        let count = data.rows.len();
        let raw = forward.predict(&start)?;
        if raw.iter().any(|value| !value.is_finite()) {
            return Err(DiagnoseError::NotFinite {
                what: "its start".into(),
            });
        }
        let typical = Size::typical(settings.discrepancy, settings.noise_scale);
        let stated = ModelError::new(forward, data, &raw, &vec![1.0; count], &DMatrix::zeros(count, 0));
        let scatter = Scatter::new(&stated, &typical, vec![1.0; count])?;
        let fit = scatter.fit(forward, data, &data.model, &start, None)?;
        Ok(FirstFit {
            start,
            raw,
            typical,
            scatter,
            fit,
        })
    }

    /// How the campaign answers, moments of bounds that are kept left out; `known`: if it is known already.
    fn table(
        &self,
        (forward, settings): (&dyn Forward, &Settings),
        data: &Data,
        known: Option<&Table>,
        progress: &Progress,
    ) -> Result<Table, DiagnoseError> {
        let mut table = match known {
            Some(table) => table.clone(),
            None => Table::new(forward, settings, progress)?,
        };
        for row in data.kept_bounds(forward, &self.fit.predicted) {
            table.moment.row_mut(row).fill(0.0);
        }
        Ok(table)
    }

    fn weighed(
        &self,
        (forward, settings): (&dyn Forward, &Settings),
        data: &Data,
        table: &Table,
        fields: &[Field],
        progress: &Progress,
    ) -> Result<Weighed, DiagnoseError> {
        let first = &self.fit;
        let local = Local::about(first, forward, &self.scatter.noise);
        let widening = outliers(forward, data, first, &local, &table.slopes, fields);
        let error = ModelError::new(forward, data, &first.predicted, &widening, &local.slopes);
        let scatter = Scatter::new(&error, &self.typical, widening.clone())?;
        let whitened = Whitened::new(&local, &scatter.noise)?;
        let visible = distances(forward, data, &table.responses, &whitened);
        let visible: Vec<f64> = visible.iter().map(|own| own.unwrap_or(f64::INFINITY)).collect();
        let families = families(forward, data, &visible);
        progress.say("weighing every effect");
        let seen = Seen {
            forward,
            data,
            error,
            residual: local.at_means,
            fields,
            start: &self.start,
            raw: &self.raw,
            warm_start: first.warm_start.as_ref().map(WarmStart::for_trials),
        };
        let weighing = weigh(&seen, &table.responses, &families, settings)?;
        Ok(Weighed {
            weighing,
            families,
            error: seen.error,
            widening,
        })
    }
}

impl<'a> Baseline<'a> {
    /// Fits the model and looks around; `table`: how its campaign answers, if that is known.
    ///
    /// # Errors
    /// If there is nothing to fit, a result is not finite, or the user asked to stop.
    pub fn new(
        forward: &'a dyn Forward,
        settings: &'a Settings,
        table: Option<&Table>,
        progress: &Progress,
    ) -> Result<Baseline<'a>, DiagnoseError> {
        settings.check()?;
        let start = start(forward, settings)?;
        let data = Data::new(forward, &start)?;
        let count = data.rows.len();
        progress.say("fitting the model as it is");
        let first = FirstFit::new(forward, settings, &data, start)?;
        let at_first = &first.fit.predicted;
        progress.check()?;
        let table = first.table((forward, settings), &data, table, progress)?;
        let fields = fields(forward, &data, &table.moment, at_first);
        let Weighed {
            weighing,
            families,
            error,
            widening,
        } = first.weighed((forward, settings), &data, &table, &fields, progress)?;
        let size = size_of_fits([weighing.share, weighing.scale], count, settings);
        let scatter = Scatter::new(&error, &size, widening)?;
        progress.say("fitting the model with the errors that the data show");
        let warm_start = first.fit.warm_start.clone();
        let fit = scatter.fit(forward, &data, &data.model, &first.fit.at, warm_start.as_ref())?;
        let local = Local::about(&fit, forward, &scatter.noise);
        let whitened = Whitened::new(&local, &scatter.noise)?;
        let kept = data.kept_bounds(forward, at_first).len();
        let distances = distances(forward, &data, &table.responses, &whitened);
        Ok(Baseline {
            forward,
            settings,
            raw: first.raw,
            error,
            size,
            scatter,
            directions: Directions::new(&data, &table.slopes, &whitened),
            distances,
            fit,
            local,
            whitened,
            responses: table.responses,
            families,
            weighing,
            slopes: table.slopes,
            moment: table.moment,
            fields,
            likelihood: Likelihood::of(count - kept, settings),
            screening: table.screening,
            warm_start,
            data,
        })
    }

    /// The scatter under an explanation: with what was missing less is left to the formulation.
    ///
    /// # Errors
    /// If a standard deviation is not positive.
    pub fn scatter_under(&self, trial: &Trial) -> Result<Scatter, DiagnoseError> {
        let Some(found) = trial.size else {
            return Ok(self.scatter.clone());
        };
        let size = size_of_fits(found, self.data.rows.len(), self.settings);
        Scatter::new(&self.error, &size, self.scatter.widening.clone())
    }

    /// Whether the scale of the noise is taken on trust, for want of numbers.
    pub fn on_trust(&self) -> bool {
        self.settings.noise_scale.is_none() && self.data.rows.len() < FEWEST
    }

    /// Change of the fitted readings by a missing effect at a strength.
    pub fn change(&self, k: usize, strength: f64) -> DVector<f64> {
        self.responses.each[k]
            .at(strength)
            .select_rows(self.data.rows.iter())
    }
}

/// The size of the errors by which fits of `count` numbers weigh, from what the data show: with few numbers the scatter is that which is stated.
fn size_of_fits([share, scale]: [f64; 2], count: usize, settings: &Settings) -> Size {
    let scale = match settings.noise_scale {
        None if count >= FEWEST => scale,
        known => known.unwrap_or(1.0),
    };
    Size {
        share,
        scale,
        ln_prior: 0.0,
    }
}

/// How far each missing effect at its plausible size is from none, in standard deviations, what calibration takes up left out.
pub fn distances(
    forward: &dyn Forward,
    data: &Data,
    responses: &Responses,
    whitened: &Whitened,
) -> Vec<Option<f64>> {
    let distance = |(k, &i): (usize, &usize)| {
        let (_, _, scale, _) = effect_of(&forward.unknowns()[i])?;
        let response = &responses.each[k];
        let size = if response.has(scale) { scale } else { -scale };
        response.has(size).then(|| distance(response, size, whitened))
    };
    data.missing.iter().enumerate().map(distance).collect()
}

/// How far an effect at a size that was solved is from none, in standard deviations, what calibration takes up left out.
pub fn distance(response: &Response, size: f64, whitened: &Whitened) -> f64 {
    let change = response.at(size);
    let change = DMatrix::from_column_slice(change.len(), 1, change.as_slice());
    whitened.directions(&change).norm()
}

/// Factors for numbers that are far from what all the others tell, whatever is missing.
fn outliers(
    forward: &dyn Forward,
    data: &Data,
    first: &Fit,
    local: &Local,
    slopes: &DMatrix<f64>,
    fields: &[Field],
) -> Vec<f64> {
    let rows = &data.rows;
    if rows.len() < FEWEST {
        return vec![1.0; rows.len()];
    }
    let observables = forward.observables();
    let inverse = rows.iter().map(|&row| 1.0 / observables[row].sigma);
    let inverse = DVector::from_iterator(rows.len(), inverse);
    let errors = rows
        .iter()
        .map(|&row| observables[row].misfit(first.predicted[row]));
    let residual = DVector::from_iterator(rows.len(), errors).component_mul(&inverse);
    let mut parts = vec![local.slopes.clone(), slopes.select_rows(rows.iter())];
    let is_smooth = |field: &&Field| matches!(field.law, Law::Free | Law::Sensor | Law::Compliance);
    let smooth = fields.iter().filter(is_smooth);
    parts.extend(smooth.map(|field| &field.columns * SMOOTH_AMPLITUDE));
    let columns = DMatrix::from_diagonal(&inverse) * side_by_side(&parts);
    outlier_widening(&residual, &columns)
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
