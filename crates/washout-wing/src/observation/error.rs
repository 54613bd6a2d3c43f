//! Why a profile cannot be read as the design asks.

use thiserror::Error;

use crate::effects::EffectError;

/// Why a profile cannot be read as the design asks.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ObservationError {
    /// A camera whose axis is not stated.
    #[error(
        "observation.instrument is \"camera\", but observation.camera_axis is missing: \
         write camera_axis = \"flapping-axis\" or \"stroke\""
    )]
    CameraWithoutAxis,
    /// A camera on a wing without flow, so that nothing says at which angle it is seen.
    #[error(
        "observation.instrument is \"camera\", but the design has neither [flapping] nor [steady], \
         so the root angle that the camera sees is not known: add one, or set instrument = \"chord_rotation\""
    )]
    CameraWithoutFlow,
    /// A camera that sees the untwisted wing edge-on.
    #[error(
        "a camera along the {axis} sees the untwisted wing edge-on at a root angle of {root_angle_deg} deg \
         and cannot read its twist: choose the other camera_axis"
    )]
    CameraSeesNothing {
        /// Axis as the design writes it.
        axis: &'static str,
        /// Root angle of attack, deg.
        root_angle_deg: f64,
    },
    /// Effects of the design that are none, or cannot act.
    #[error(transparent)]
    Effects(#[from] Box<EffectError>),
    /// A state that does not belong to the mesh.
    #[error("the {state} state has {found} nodes, the mesh {expected}: give the solution of this mesh")]
    ForeignState {
        /// Which state.
        state: &'static str,
        /// Nodes of the state.
        found: usize,
        /// Nodes of the mesh.
        expected: usize,
    },
}
