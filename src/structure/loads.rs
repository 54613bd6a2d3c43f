//! Loads on the nodes: dead forces, dead moments, and dead forces on rigid arms.

use nalgebra::Vector3;

use super::pattern::Pattern;
use super::rotation::skew;
use super::state::State;

/// Loads that keep their direction in space.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    /// Force on each node, N.
    pub force_n: Vec<Vector3<f64>>,
    /// Moment on each node, N·m.
    pub moment_n_m: Vec<Vector3<f64>>,
    /// Forces on rigid arms, which turn with their node.
    pub arms: Vec<ArmForce>,
}

/// A dead force at the end of a rigid arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmForce {
    /// Node that carries the arm.
    pub node: usize,
    /// End of the arm against the node at rest, m.
    pub arm_m: Vector3<f64>,
    /// Force, N.
    pub force_n: Vector3<f64>,
}

impl Loads {
    /// No load on any of `nodes` nodes.
    pub fn none(nodes: usize) -> Self {
        Loads {
            force_n: vec![Vector3::zeros(); nodes],
            moment_n_m: vec![Vector3::zeros(); nodes],
            arms: Vec::new(),
        }
    }

    /// A share of the loads between `from` and these: 0 gives `from`, 1 these. The arms must be the same.
    pub fn between(&self, from: &Loads, share: f64) -> Loads {
        let mix = |to: &[Vector3<f64>], from: &[Vector3<f64>]| {
            to.iter()
                .zip(from)
                .map(|(to, from)| from + share * (to - from))
                .collect()
        };
        let arm = |(index, to): (usize, &ArmForce)| {
            let from = from.arms.get(index).map_or(Vector3::zeros(), |arm| arm.force_n);
            ArmForce {
                force_n: from + share * (to.force_n - from),
                ..*to
            }
        };
        Loads {
            force_n: mix(&self.force_n, &from.force_n),
            moment_n_m: mix(&self.moment_n_m, &from.moment_n_m),
            arms: self.arms.iter().enumerate().map(arm).collect(),
        }
    }

    /// Norm of all forces (N) and of all moments (N·m), those of the arms included.
    pub fn size(&self, state: &State) -> (f64, f64) {
        let arms = || self.arms.iter();
        let force = self
            .force_n
            .iter()
            .chain(arms().map(|arm| &arm.force_n))
            .map(Vector3::norm_squared)
            .sum::<f64>();
        let turned = arms().map(|arm| {
            (state.rotation[arm.node] * arm.arm_m)
                .cross(&arm.force_n)
                .norm_squared()
        });
        let moment = self.moment_n_m.iter().map(Vector3::norm_squared).sum::<f64>() + turned.sum::<f64>();
        (force.sqrt(), moment.sqrt())
    }

    /// Subtracts the loads from internal forces by freedom.
    pub fn subtract(&self, pattern: &Pattern, state: &State, residual: &mut [f64]) {
        let mut take = |node: usize, force: &Vector3<f64>, moment: &Vector3<f64>| {
            let at = pattern.freedom(node, 0);
            for i in 0..3 {
                residual[at + i] -= force[i];
                residual[at + 3 + i] -= moment[i];
            }
        };
        for (node, (force, moment)) in self.force_n.iter().zip(&self.moment_n_m).enumerate() {
            take(node, force, moment);
        }
        for arm in &self.arms {
            take(
                arm.node,
                &arm.force_n,
                &(state.rotation[arm.node] * arm.arm_m).cross(&arm.force_n),
            );
        }
    }

    /// Adds the (symmetrised) stiffness that forces on arms bring.
    pub fn add_tangent(&self, pattern: &Pattern, state: &State, values: &mut [f64]) {
        for arm in &self.arms {
            let turned = state.rotation[arm.node] * arm.arm_m;
            // residual −(a × F); a changes by δθ × a, so its derivative is −S(F) S(a)
            let k = -skew(&arm.force_n) * skew(&turned);
            let k = 0.5 * (k + k.transpose());
            pattern.add_node(values, arm.node, |i, j| {
                if i >= 3 && j >= 3 { k[(i - 3, j - 3)] } else { 0.0 }
            });
        }
    }
}
