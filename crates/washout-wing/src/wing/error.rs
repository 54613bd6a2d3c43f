//! Why a wing cannot be read, meshed, solved or read off.

use std::error::Error;
use std::path::{Path, PathBuf};

use crate::coupling::CouplingError;
use crate::effects::EffectError;
use crate::input::{InputError, Loaded, Place, place_in};
use crate::progress::Cancelled;

/// Why a wing gives no answer.
#[derive(Debug, thiserror::Error)]
pub enum WingError {
    /// A design or a file that it names is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The design is sound by itself, but no such wing can be laid out, meshed, put into the air or read.
    #[error("{}: {reason}", design.display())]
    Design {
        /// The design file.
        design: PathBuf,
        /// What is wrong.
        reason: Box<dyn Error + Send + Sync>,
    },
    /// A table of an effect is refused.
    #[error("{place}: {source}")]
    Effect {
        /// Where it stands.
        place: Place,
        /// What is wrong.
        source: Box<EffectError>,
    },
    /// The wing has no solution that could be found.
    #[error("{}: {source}{remark}", design.display())]
    Solve {
        /// The design file.
        design: PathBuf,
        /// Why.
        source: CouplingError,
        /// What of the design may be why, a sentence behind a full stop; empty if nothing stands out.
        remark: String,
    },
    /// No solution at a phase of the stroke.
    #[error("{}: at phase {phase_deg:.1} deg of the stroke: {source}", design.display())]
    Phase {
        /// The design file.
        design: PathBuf,
        /// Phase; 0 is mid-stroke.
        phase_deg: f64,
        /// Why.
        source: CouplingError,
    },
    /// Nothing to take a twist from.
    #[error("{} names no measurement; give one --with CSV, or add [measured] to the design", design.display())]
    NoMeasurement {
        /// The design file.
        design: PathBuf,
    },
    /// A question that this wing does not allow.
    #[error("{question}: {reason}")]
    Question {
        /// What was asked, as the command line has it.
        question: &'static str,
        /// Why not, and what to do instead.
        reason: String,
    },
    /// No mesh that is tried leaves as little as was asked for.
    #[error(
        "{}: at mesh.refine = {refine} the mesh leaves {found_percent:.2} % of the tip's twist, {asked_percent} % was asked for, and no mesh \
         up to mesh.refine = 4 would leave as little; ask for less, or read the twist where spars hold the film",
        design.display()
    )]
    MeshTooCoarse {
        /// The design file.
        design: PathBuf,
        /// The finest mesh.
        refine: f64,
        /// What it leaves, % of the tip's twist.
        found_percent: f64,
        /// What was asked for.
        asked_percent: f64,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

impl WingError {
    /// A design that makes no wing, because of `reason`.
    pub fn design(design: &Path, reason: impl Error + Send + Sync + 'static) -> WingError {
        WingError::Design {
            design: design.to_path_buf(),
            reason: Box::new(reason),
        }
    }

    /// What is wrong with a table of an effect, with its line in the file of the design.
    pub(super) fn effect(loaded: &Loaded, source: EffectError) -> WingError {
        let key = source.key().unwrap_or_default();
        let value = key.strip_prefix("effects.").and_then(|rest| {
            let (name, number) = rest.split_once('.')?;
            loaded.design.effects.get(name)?.get(number)
        });
        WingError::Effect {
            place: place_in(&loaded.path, &key, value),
            source: Box::new(source),
        }
    }

    /// Whether the wing has no solution that could be found, as opposed to an input at fault.
    pub fn is_not_converged(&self) -> bool {
        match self {
            WingError::Solve { source, .. } | WingError::Phase { source, .. } => source.is_not_converged(),
            WingError::MeshTooCoarse { .. } => true,
            _ => false,
        }
    }

    /// The exit code of a process that ends with it: 2 input, 3 not converged, 130 interrupted.
    pub fn exit_code(&self) -> u8 {
        match self {
            WingError::Interrupted(_) => 130,
            _ if self.is_not_converged() => 3,
            _ => 2,
        }
    }
}
