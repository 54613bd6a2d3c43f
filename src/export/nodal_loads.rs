//! The loads of a loaded wing as dead forces and moments on its nodes, for programs that know nothing else.

use nalgebra::Vector3;

use crate::coupling::vibration::Standing;

/// Force (N) and moment (N·m) on each node where the wing stands: forces on arms with their moment there, forces that grow
/// with the displacement at their value there.
pub fn nodal_loads(standing: &Standing) -> (Vec<Vector3<f64>>, Vec<Vector3<f64>>) {
    let Standing { state, loads, .. } = standing;
    let (mut force_n, mut moment_n_m) = (loads.force_n.clone(), loads.moment_n_m.clone());
    let mut add = |node: usize, arm_m: Vector3<f64>, force: Vector3<f64>| {
        force_n[node] += force;
        moment_n_m[node] += (state.rotation[node] * arm_m).cross(&force);
    };
    for arm in &loads.arms {
        add(arm.node, arm.arm_m, arm.force_n);
    }
    for grown in &loads.linear {
        let (node, arm_m) = (grown.node, grown.arm_m);
        let moved = state.displacement[node] + state.rotation[node] * arm_m - arm_m;
        add(node, arm_m, grown.force_n + grown.gradient_n_m * moved);
    }
    (force_n, moment_n_m)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, UnitQuaternion};

    use super::*;
    use crate::structure::state::State;
    use crate::structure::{ArmForce, LinearForce, Loads, Model};

    #[test]
    fn arms_turn_with_their_node_and_growing_forces_are_taken_where_the_wing_stands() {
        let mut state = State::at_rest(1);
        // a quarter turn about x takes an arm along y to z
        state.rotation[0] = UnitQuaternion::new(Vector3::x() * std::f64::consts::FRAC_PI_2);
        state.displacement[0] = Vector3::new(0.0, 0.0, 0.5);
        let mut loads = Loads::none(1);
        let (node, arm_m) = (0, Vector3::y());
        let force_n = Vector3::new(3.0, 0.0, 0.0);
        loads.arms.push(ArmForce { node, arm_m, force_n });
        loads.linear.push(LinearForce {
            node,
            arm_m,
            force_n: Vector3::zeros(),
            gradient_n_m: Matrix3::from_diagonal(&Vector3::new(0.0, 0.0, 2.0)),
        });
        let standing = Standing {
            model: Model::new(vec![Vector3::zeros()]),
            state,
            loads,
            moved_air_kg_m2: Vec::new(),
        };
        let (force, moment) = nodal_loads(&standing);
        // the end of the arm rises by 0.5 + 1: a force of 3 along z, whose arm is along z too
        assert!(
            (force[0] - Vector3::new(3.0, 0.0, 3.0)).norm() < 1e-12,
            "{force:?}"
        );
        assert!(
            (moment[0] - Vector3::new(0.0, 3.0, 0.0)).norm() < 1e-12,
            "{moment:?}"
        );
    }
}
