//! Why a coupled solve gives no solution.

use crate::aero::AeroError;
use crate::progress::Cancelled;
use crate::structure::StructureError;

/// Why a coupled solve gives no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CouplingError {
    /// The air cannot be set up.
    #[error(transparent)]
    Air(#[from] AeroError),
    /// The structure cannot be set up, or finds no equilibrium.
    #[error(transparent)]
    Structure(StructureError),
    /// The wing stands beyond its divergence.
    #[error(
        "beyond divergence: the air's moment grows faster with twist than the structure's; the critical dynamic \
         pressure is about {:.3} times that of the design. Lower the speed or the amplitude, stiffen the rod in torsion, \
         or move the spars so that the load acts behind the axis; `washout divergence` shows the way there",
        critical_ratio
    )]
    Diverged {
        /// Critical dynamic pressure over that of the design.
        critical_ratio: f64,
    },
    /// The iteration did not converge.
    #[error(
        "not converged after {iterations} iterations (coupling.max_iterations = {allowed}): the twist still changes by \
         {twist_change_deg:.2e} deg, residual {residual:.2e}. Allow more iterations, try coupling.accelerator = \
         \"aitken\" or \"anderson\", or a finer mesh"
    )]
    OutOfPatience {
        /// Iterations made.
        iterations: usize,
        /// Iterations allowed.
        allowed: usize,
        /// Last change of twist, deg.
        twist_change_deg: f64,
        /// Coupled residual relative to the load.
        residual: f64,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

impl From<StructureError> for CouplingError {
    fn from(error: StructureError) -> Self {
        match error {
            StructureError::Interrupted(cancelled) => CouplingError::Interrupted(cancelled),
            other => CouplingError::Structure(other),
        }
    }
}

impl CouplingError {
    /// Whether the equations had no solution that could be found, as opposed to an input at fault or an interruption.
    pub fn is_not_converged(&self) -> bool {
        match self {
            CouplingError::Diverged { .. } | CouplingError::OutOfPatience { .. } => true,
            CouplingError::Structure(error) => {
                matches!(
                    error,
                    StructureError::NoEquilibrium { .. } | StructureError::Singular { .. }
                )
            }
            CouplingError::Air(_) | CouplingError::Interrupted(_) => false,
        }
    }
}
