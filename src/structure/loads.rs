//! Loads on the nodes: dead forces, dead moments, and dead forces on rigid arms.

use nalgebra::{Matrix3, Vector3};

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
    /// Forces that grow with the displacement of their node.
    pub linear: Vec<LinearForce>,
}

/// A force F + G u that is linear in the displacement u of its node, with a symmetric G, so that it has a potential.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearForce {
    /// The node.
    pub node: usize,
    /// Force at rest, N.
    pub force_n: Vector3<f64>,
    /// Change of the force with the displacement, N/m.
    pub gradient_n_m: Matrix3<f64>,
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
            linear: Vec::new(),
        }
    }

    /// A share of the loads between `from` and these: 0 gives `from`, 1 these. Arms and linear
    /// forces must stand at the same nodes.
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
        let linear = |(index, to): (usize, &LinearForce)| {
            let nothing = (Vector3::zeros(), Matrix3::zeros());
            let from = from.linear.get(index);
            let (force, gradient) = from.map_or(nothing, |from| (from.force_n, from.gradient_n_m));
            LinearForce {
                node: to.node,
                force_n: force + share * (to.force_n - force),
                gradient_n_m: gradient + share * (to.gradient_n_m - gradient),
            }
        };
        Loads {
            linear: self.linear.iter().enumerate().map(linear).collect(),
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
            .sum::<f64>()
            + self
                .linear
                .iter()
                .map(|linear| linear.at(state).norm_squared())
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
        for linear in &self.linear {
            take(linear.node, &linear.at(state), &Vector3::zeros());
        }
    }

    /// Adds the stiffness that linear forces and (symmetrised) forces on arms bring.
    pub fn add_tangent(&self, pattern: &Pattern, state: &State, values: &mut [f64]) {
        for linear in &self.linear {
            let k = linear.gradient_n_m;
            pattern.add_node(
                values,
                linear.node,
                |i, j| {
                    if i < 3 && j < 3 { -k[(i, j)] } else { 0.0 }
                },
            );
        }
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

impl LinearForce {
    /// The force in a state, N.
    fn at(&self, state: &State) -> Vector3<f64> {
        self.force_n + self.gradient_n_m * state.displacement[self.node]
    }
}
