//! Derivatives of the readings of a case.

/// How a case answers to an unknown.
#[derive(Debug)]
pub struct Column {
    /// Derivative of every row.
    pub rates: Vec<f64>,
    /// Change of the loaded shape by freedom, per unit of the unknown; none if the mesh moves too, or there is a kink.
    pub shape: Option<Vec<f64>>,
}

/// How a case answers, for the index of a column.
pub type Columns = Vec<(usize, Column)>;
