//! Why a case could not be run.

use std::error::Error;

use crate::coupling::CouplingError;
use crate::geometry::GeometryError;
use crate::input::InputError;
use crate::mesh::MeshError;
use crate::progress::Cancelled;
use crate::structure::StructureError;
use crate::wing::WingError;

/// Why a case could not be run.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// The structure cannot be built or solved.
    #[error(transparent)]
    Structure(StructureError),
    /// Air and structure together have no solution.
    #[error(transparent)]
    Coupling(CouplingError),
    /// The design of a case is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The outline of a case is refused.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// The wing of a case cannot be meshed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The tangent at rest is not positive definite.
    #[error("the structure at rest has {negative} negative pivots; please report this as a bug")]
    Unstable {
        /// Negative pivots.
        negative: usize,
    },
    /// The solver found no such number.
    #[error("the solution has no {what}; please report this as a bug")]
    Missing {
        /// What was sought.
        what: &'static str,
    },
    /// The wing of a case cannot be made or read.
    #[error("{0}")]
    Wing(Box<dyn Error + Send + Sync>),
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

impl From<WingError> for VerifyError {
    fn from(error: WingError) -> Self {
        match error {
            WingError::Input(error) => error.into(),
            WingError::Solve { source, .. } | WingError::Phase { source, .. } => source.into(),
            WingError::Interrupted(cancelled) => cancelled.into(),
            WingError::Design { reason, .. } => VerifyError::Wing(reason),
            error => VerifyError::Wing(Box::new(error)),
        }
    }
}

impl From<StructureError> for VerifyError {
    fn from(error: StructureError) -> Self {
        match error {
            StructureError::Interrupted(cancelled) => VerifyError::Interrupted(cancelled),
            other => VerifyError::Structure(other),
        }
    }
}

impl From<CouplingError> for VerifyError {
    fn from(error: CouplingError) -> Self {
        match error {
            CouplingError::Interrupted(cancelled)
            | CouplingError::Structure(StructureError::Interrupted(cancelled)) => {
                VerifyError::Interrupted(cancelled)
            }
            other => VerifyError::Coupling(other),
        }
    }
}
