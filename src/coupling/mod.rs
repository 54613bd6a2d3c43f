//! Air and structure together: load and shape transfer, residual, fixed point, sensitivity.

pub mod engineering;

pub mod error;

pub mod solution;

pub use engineering::{Engineering, Extreme};
pub use error::CouplingError;

use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::progress::Progress;

use solution::Solution;

/// The loaded shape of a wing in its air.
///
/// `air_table`: rows alpha_deg, cl, cd for `air.coefficients = "table"`.
pub fn solve(
    _design: &Design,
    _planform: &Planform,
    _mesh: &Mesh,
    _air_table: Option<&[[f64; 3]]>,
    progress: &Progress,
) -> Result<Solution, CouplingError> {
    progress.check()?;
    Err(CouplingError::NotAvailable)
}
