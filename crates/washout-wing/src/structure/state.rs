//! The shape of a structure: displacement and rotation of every node.

use nalgebra::{UnitQuaternion, Vector3};

/// Displacements and rotations of the nodes, wing frame.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Displacement of each node, m.
    pub displacement: Vec<Vector3<f64>>,
    /// Rotation of each node from rest.
    pub rotation: Vec<UnitQuaternion<f64>>,
}

impl State {
    /// The shape at rest of `nodes` nodes.
    pub fn at_rest(nodes: usize) -> Self {
        State {
            displacement: vec![Vector3::zeros(); nodes],
            rotation: vec![UnitQuaternion::identity(); nodes],
        }
    }
}
