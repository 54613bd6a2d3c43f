//! How a campaign answers to everything that may be missing, where its unknowns start. It takes most of the time of a first diagnosis,
//! does not depend on what was measured, and serves every question after it.

use nalgebra::DMatrix;

use crate::progress::Progress;
use crate::study::{Forward, WarmStart, Work};

use super::data::{Data, start};
use super::error::DiagnoseError;
use super::responses::Responses;
use super::screening::{Slopes, slopes_of_missing};
use super::settings::Settings;

/// The answers of one campaign.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Derivatives of all observables with the missing effects, a column each, per prior standard deviation.
    pub slopes: DMatrix<f64>,
    /// Responses of all observables to a moment at each station.
    pub moment: DMatrix<f64>,
    /// Finite steps of every missing effect.
    pub responses: Responses,
    /// What the derivatives took.
    pub screening: Work,
    /// What everything took.
    pub work: Work,
}

impl Table {
    /// Of a campaign.
    ///
    /// # Errors
    /// If there is nothing to fit, the model has no solution where its unknowns start, or the user asked to stop.
    pub fn new(
        forward: &dyn Forward,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Table, DiagnoseError> {
        Table::of_those(forward, settings, &|_| true, progress)
    }

    /// The same of the missing effects of which `wanted` holds alone, by the index of the unknown that is their strength.
    ///
    /// # Errors
    /// As [`Table::new`].
    pub fn of_those(
        forward: &dyn Forward,
        settings: &Settings,
        wanted: &dyn Fn(usize) -> bool,
        progress: &Progress,
    ) -> Result<Table, DiagnoseError> {
        settings.check()?;
        let start = start(forward, settings)?;
        let mut data = Data::new(forward, &start)?;
        data.missing.retain(|&unknown| wanted(unknown));
        progress.say("derivatives with every effect");
        let before = forward.work();
        let Slopes { missing, warm_start } = slopes_of_missing(forward, &data, &start, settings, None)?;
        progress.check()?;
        let moment = forward.moment_response_from(warm_start.as_ref(), &start, settings.stations)?;
        let screening = forward.work() - before;
        let warm_start = warm_start.as_ref().map(WarmStart::roughly);
        let responses = Responses::new(forward, &data, &start, (&missing, warm_start.as_ref()), progress)?;
        Ok(Table {
            slopes: missing,
            moment,
            responses,
            screening,
            work: forward.work() - before,
        })
    }
}
