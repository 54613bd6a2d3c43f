//! Matrices and vectors as files have them: column by column.

use nalgebra::DMatrix;
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
    use nalgebra::DVector;
    use serde::{Deserialize, Deserializer, Serializer};

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
