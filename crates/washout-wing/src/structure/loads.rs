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
    /// Twists of beam elements that cost no torque.
    pub twists: Vec<BeamTwist>,
}

/// A twist from end to end at which a beam element is without torque: play, or heat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamTwist {
    /// Index of the beam element.
    pub beam: usize,
    /// The twist about its axis, from its first node to its second, rad.
    pub angle_rad: f64,
}

/// A force F + G (u + R a − a) at the end of a rigid arm a, linear in the displacement there; u and R are those of its
/// node. G is symmetric, so that it has a potential.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearForce {
    /// The node.
    pub node: usize,
    /// End of the arm against the node at rest, m.
    pub arm_m: Vector3<f64>,
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
            twists: Vec::new(),
        }
    }

    /// What of these loads grows with displacements, without the rest: a linear model's share of the tangent.
    #[must_use]
    pub fn growing(&self) -> Loads {
        Loads {
            linear: self.linear.clone(),
            ..Loads::none(self.force_n.len())
        }
    }

    /// Twist of a beam element that costs no torque, rad.
    pub fn twist_rad(&self, beam: usize) -> f64 {
        let of_beam = self.twists.iter().filter(|twist| twist.beam == beam);
        of_beam.map(|twist| twist.angle_rad).sum()
    }

    /// A share of the loads between `from` and these: 0 gives `from`, 1 these. Arms, linear
    /// forces and twists must stand at the same places.
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
                arm_m: to.arm_m,
                force_n: force + share * (to.force_n - force),
                gradient_n_m: gradient + share * (to.gradient_n_m - gradient),
            }
        };
        let twist = |(index, to): (usize, &BeamTwist)| {
            let from = from.twists.get(index).map_or(0.0, |from| from.angle_rad);
            BeamTwist {
                angle_rad: from + share * (to.angle_rad - from),
                ..*to
            }
        };
        Loads {
            twists: self.twists.iter().enumerate().map(twist).collect(),
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

    /// Subtracts the loads from internal forces by freedom; twists are part of the internal forces.
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
            let force = linear.at(state);
            take(linear.node, &force, &linear.turned(state).cross(&force));
        }
    }

    /// Adds the stiffness that linear forces and (symmetrised) forces on arms bring.
    pub fn add_tangent(&self, pattern: &Pattern, state: &State, values: &mut [f64]) {
        for linear in &self.linear {
            let (k, arm) = (linear.gradient_n_m, skew(&linear.turned(state)));
            let lever = arm * k;
            // as for arms below, and the force's own change
            let turn = arm * k * arm - skew(&linear.at(state)) * arm;
            let turn = 0.5 * (turn + turn.transpose());
            pattern.add_node(values, linear.node, |i, j| match (i, j) {
                (0..3, 0..3) => -k[(i, j)],
                (3..6, 0..3) => -lever[(i - 3, j)],
                (3..6, 3..6) => turn[(i - 3, j - 3)],
                // above the diagonal
                _ => -lever[(j - 3, i)],
            });
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
        let moved = state.displacement[self.node] + self.turned(state) - self.arm_m;
        self.force_n + self.gradient_n_m * moved
    }

    /// The arm in a state, m.
    fn turned(&self, state: &State) -> Vector3<f64> {
        state.rotation[self.node] * self.arm_m
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::Model;
    use super::*;
    use nalgebra::{Matrix6, UnitQuaternion};

    /// Spins do not commute: the rest of the differences is that of every moment, and cancels in equilibrium.
    #[test]
    fn stiffness_of_a_linear_force_on_an_arm_is_the_symmetric_part_of_its_differences() {
        let pattern = Model::new(vec![Vector3::zeros()]).pattern();
        let mut loads = Loads::none(1);
        loads.linear.push(LinearForce {
            node: 0,
            arm_m: Vector3::new(0.3, -0.2, 0.5),
            force_n: Vector3::new(1.0, 2.0, -0.7),
            gradient_n_m: Matrix3::new(2.0, 0.3, -0.5, 0.3, 1.0, 0.2, -0.5, 0.2, 3.0),
        });
        let mut state = State::at_rest(1);
        state.displacement[0] = Vector3::new(0.1, -0.3, 0.2);
        state.rotation[0] = UnitQuaternion::new(Vector3::new(0.4, -0.6, 0.3));
        let residual = |freedom: usize, h: f64| {
            let mut moved = state.clone();
            if freedom < 3 {
                moved.displacement[0][freedom] += h;
            } else {
                moved.rotation[0] = UnitQuaternion::new(Vector3::ith(freedom - 3, h)) * moved.rotation[0];
            }
            let mut residual = vec![0.0; 6];
            loads.subtract(&pattern, &moved, &mut residual);
            residual
        };
        let slope = |i: usize, j: usize| (residual(j, 1e-6)[i] - residual(j, -1e-6)[i]) / 2e-6;
        let difference = Matrix6::from_fn(slope);
        let mut values = vec![0.0; pattern.entries()];
        loads.add_tangent(&pattern, &state, &mut values);
        for j in 0..6 {
            let mut unit = vec![0.0; 6];
            unit[j] = 1.0;
            let column = pattern.multiply(&values, &unit);
            for i in 0..6 {
                let expected = 0.5 * (difference[(i, j)] + difference[(j, i)]);
                assert!(
                    (column[i] - expected).abs() < 1e-8,
                    "{i} {j}: {} {expected}",
                    column[i]
                );
            }
        }
    }
}
