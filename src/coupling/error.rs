//! Why a coupled solve gives no solution.

use crate::aero::AeroError;
use crate::progress::Cancelled;

/// Why a coupled solve gives no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CouplingError {
    /// The solver is not there yet.
    #[error("this version cannot solve a wing yet; it reads designs, meshes and compares runs")]
    NotAvailable,
    /// The air cannot be set up.
    #[error(transparent)]
    Air(#[from] AeroError),
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

impl CouplingError {
    /// Whether the equations had no solution that could be found, as opposed to an input at fault or an interruption.
    pub fn is_not_converged(&self) -> bool {
        matches!(self, CouplingError::NotAvailable)
    }
}
