//! How a campaign answers to everything that may be missing, where its unknowns start. It takes most of the time of a first diagnosis,
//! does not depend on what was measured, and serves every question after it.

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use crate::progress::Progress;
use crate::study::{Footing, Forward, Work};

use super::data::{Data, start};
use super::error::DiagnoseError;
use super::responses::{Response, Responses};
use super::screening::{Slopes, slopes_of_missing};
use super::settings::Settings;

/// The answers of one campaign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Derivatives of all observables with the missing effects, a column each, per prior standard deviation.
    #[serde(with = "columns")]
    pub slopes: DMatrix<f64>,
    /// Responses of all observables to a moment at each station.
    #[serde(with = "columns")]
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
        settings.check()?;
        let start = start(forward, settings)?;
        let data = Data::new(forward, &start)?;
        progress.say("derivatives with every effect");
        let before = forward.work();
        let Slopes { missing, footing } = slopes_of_missing(forward, &data, &start, settings, None)?;
        progress.check()?;
        let moment = forward.moment_response_from(footing.as_ref(), &start, settings.stations)?;
        let screening = forward.work() - before;
        let footing = footing.as_ref().map(Footing::roughly);
        let responses = Responses::new(forward, &data, &start, (&missing, footing.as_ref()), progress)?;
        Ok(Table {
            slopes: missing,
            moment,
            responses,
            screening,
            work: forward.work() - before,
        })
    }

    /// Observables of its campaign; none if its parts are not of one.
    pub fn observables(&self) -> Option<usize> {
        let rows = self.slopes.nrows();
        let of_steps = self.responses.each.iter().flat_map(Response::changes);
        let is_one = self.moment.nrows() == rows
            && self.responses.each.len() == self.slopes.ncols()
            && of_steps.into_iter().all(|change| change.len() == rows);
        is_one.then_some(rows)
    }
}

/// Matrices as files have them.
pub(super) mod columns {
    use nalgebra::{DMatrix, DVector};
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

    pub fn serialize<S: Serializer>(matrix: &DMatrix<f64>, to: S) -> Result<S::Ok, S::Error> {
        let columns: Vec<Vec<f64>> = matrix
            .column_iter()
            .map(|own| own.iter().copied().collect())
            .collect();
        (matrix.nrows(), columns).serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<DMatrix<f64>, D::Error> {
        let (rows, columns): (usize, Vec<Vec<f64>>) = Deserialize::deserialize(from)?;
        if columns.iter().any(|own| own.len() != rows) {
            return Err(D::Error::custom("columns of unequal length"));
        }
        let count = columns.len();
        Ok(DMatrix::from_vec(rows, count, columns.concat()))
    }

    /// Vectors beside their strengths.
    pub mod of_strengths {
        use super::*;

        pub fn serialize<S: Serializer>(knots: &[(f64, DVector<f64>)], to: S) -> Result<S::Ok, S::Error> {
            to.collect_seq(knots.iter().map(|(strength, own)| (strength, own.as_slice())))
        }

        pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<(f64, DVector<f64>)>, D::Error> {
            let knots: Vec<(f64, Vec<f64>)> = Deserialize::deserialize(from)?;
            Ok(knots
                .into_iter()
                .map(|(strength, own)| (strength, DVector::from_vec(own)))
                .collect())
        }
    }
}
