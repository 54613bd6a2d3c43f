//! How a verb can fail, and the exit code of each way.

use std::io;
use std::path::PathBuf;

use crate::aero::AeroError;
use crate::export::ExportError;
use crate::geometry::GeometryError;
use crate::input::InputError;
use crate::mesh::MeshError;
use crate::progress::Cancelled;

/// Why a verb did not do what it should.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// A design or measurement is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The wing cannot be laid out.
    #[error("{}: {source}", design.display())]
    Geometry {
        /// The design file.
        design: PathBuf,
        /// What is wrong.
        source: GeometryError,
    },
    /// The wing cannot be meshed.
    #[error("{}: {source}", design.display())]
    Mesh {
        /// The design file.
        design: PathBuf,
        /// What is wrong.
        source: MeshError,
    },
    /// The air cannot be set up.
    #[error("{}: {source}", design.display())]
    Aero {
        /// The design file.
        design: PathBuf,
        /// What is wrong.
        source: AeroError,
    },
    /// Results cannot be written or read.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// A file to be written stands already.
    #[error("{} exists already; give another name, or move it away", path.display())]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// A name that makes no file name.
    #[error("'{name}' is no name for a wing: use letters, digits, '-' and '_' only")]
    Name {
        /// The name.
        name: String,
    },
    /// Standard output does not take the result.
    #[error("cannot write to standard output: {0}; send it elsewhere, or free some space there")]
    Output(io::Error),
    /// Threads cannot be started.
    #[error("cannot start the threads: {0}; give a smaller number with --threads")]
    Threads(String),
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

impl Failure {
    /// The exit code of the process: 1 other, 2 input, 3 not converged, 130 interrupted.
    pub fn exit_code(&self) -> u8 {
        match self {
            Failure::Input(_) | Failure::Geometry { .. } | Failure::Mesh { .. } | Failure::Aero { .. } => 2,
            Failure::Name { .. } | Failure::Exists { .. } => 2,
            Failure::Export(ExportError::NoRun { .. } | ExportError::ForeignSummary { .. }) => 2,
            Failure::Export(_) | Failure::Output(_) | Failure::Threads(_) => 1,
            Failure::Interrupted(_) => 130,
        }
    }
}
