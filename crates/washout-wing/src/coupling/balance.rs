//! A shape that was found before, put into the equations again: how well they are met, and whether forces, moments and work balance.

use std::sync::Arc;

use nalgebra::Vector3;

use super::cure;
use super::equilibrium::solution;
use super::error::CouplingError;
use super::fixed_point::{Coupled, stable};
use super::motion::motion_needed;
use super::near::Care;
use super::solution::Solution;
use super::wing::Wing;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Model};

/// What the loads do to a wing, and what holds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Residual of the free nodes relative to the load; in linear kinematics, by how much the loads on this shape give another, relative to it.
    pub residual: f64,
    /// What it is relative to: a force (N) and a moment (N·m).
    pub scale: (f64, f64),
    /// Sum of all loads, N, wing frame.
    pub load_n: Vector3<f64>,
    /// Their moment about the wing base, N·m.
    pub load_moment_n_m: Vector3<f64>,
    /// Force of the supports and of springs to the ground on the wing, N: minus the load in equilibrium.
    pub support_n: Vector3<f64>,
    /// Their moment about the wing base, N·m.
    pub support_moment_n_m: Vector3<f64>,
    /// Virtual work of the loads on the way from the unloaded shape, as one small displacement, J.
    pub load_work_j: f64,
    /// The same of the internal forces: equal in equilibrium (principle of virtual work).
    pub internal_work_j: f64,
}

/// The wing in a shape that is made from its unloaded one; nothing is solved but that.
///
/// # Errors
/// If design and mesh do not belong together, or the wing would not stay in that shape.
pub fn at_shape(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    shape: impl FnOnce(&State) -> State,
    progress: &Progress,
) -> Result<(Solution, Balance), CouplingError> {
    let motion = motion_needed(design, mesh, air_table, None, progress)?;
    let wing = Wing::with_motion(design, mesh, air_table, motion)?;
    let mut equilibrium = wing.equilibrium()?;
    let (rest, _) = cure::cured(&wing.model, &mut equilibrium, progress)?;
    let state = shape(&rest);
    let loads = wing.loads_on(&state)?;
    let balance = balance(&wing, &mut equilibrium, &rest, &state, &loads)?;
    let mut coupled = Coupled::at(state, loads);
    coupled.residual = balance.residual;
    coupled.twist_change_deg = 0.0;
    let coupled = stable(&wing, &mut equilibrium, &rest, coupled, Care::Full)?;
    Ok((solution(&wing, mesh, &equilibrium, rest, coupled)?, balance))
}

fn balance(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    state: &State,
    loads: &Loads,
) -> Result<Balance, CouplingError> {
    let scale = equilibrium.scale(state, loads);
    let (residual, work_left_j, support) = match wing.linear {
        false => {
            let residual = wing.model.residual(&equilibrium.pattern, state, loads);
            let left_j = work(equilibrium, &residual, rest, state);
            (
                equilibrium.relative(&residual, scale),
                left_j,
                supports(wing, equilibrium, rest, state, loads),
            )
        }
        true => {
            // a film may turn by more than half a turn here, which a rotation does not tell: the same loads give the shape once more
            let again = equilibrium.solve_linear(rest, loads)?;
            let size = |from: &State| {
                let pairs = again.displacement.iter().zip(&from.displacement);
                pairs
                    .map(|(to, from)| (to - from).norm_squared())
                    .sum::<f64>()
                    .sqrt()
            };
            let residual = if size(state) == 0.0 {
                0.0
            } else {
                size(state) / size(rest)
            };
            let moved = again.displacement.iter().zip(&state.displacement);
            let left_j = moved
                .zip(&loads.force_n)
                .map(|((again, own), force)| force.dot(&(again - own)));
            (residual, left_j.sum(), wing.reaction(equilibrium, state, loads))
        }
    };
    // arms are those of the shape on which the equations stand
    let stands_on = if wing.linear { rest } else { state };
    let mut minus_loads = vec![0.0; equilibrium.pattern.len()];
    loads.subtract(&equilibrium.pattern, stands_on, &mut minus_loads);
    let load_work_j = -work(equilibrium, &minus_loads, rest, state);
    let (mut load_n, mut load_moment_n_m) = (Vector3::zeros(), Vector3::zeros());
    for node in 0..wing.model.nodes.len() {
        let place = wing.model.nodes[node] + stands_on.displacement[node];
        let (force, moment) = at_node(equilibrium, &minus_loads, node);
        load_n -= force;
        load_moment_n_m -= place.cross(&force) + moment;
    }
    Ok(Balance {
        residual,
        scale,
        load_n,
        load_moment_n_m,
        support_n: support.0,
        support_moment_n_m: support.1,
        load_work_j,
        internal_work_j: load_work_j + work_left_j,
    })
}

/// Force and moment of a node in a list by freedom.
fn at_node(equilibrium: &Equilibrium, freedoms: &[f64], node: usize) -> (Vector3<f64>, Vector3<f64>) {
    let at = equilibrium.pattern.freedom(node, 0);
    let part = |first: usize| Vector3::from_column_slice(&freedoms[at + first..][..3]);
    (part(0), part(3))
}

/// Virtual work of nodal forces and moments on the way from the unloaded shape, J.
fn work(equilibrium: &Equilibrium, freedoms: &[f64], rest: &State, state: &State) -> f64 {
    let of_node = |node: usize| {
        let (force, moment) = at_node(equilibrium, freedoms, node);
        let moved = state.displacement[node] - rest.displacement[node];
        let turned = (state.rotation[node] * rest.rotation[node].inverse()).scaled_axis();
        force.dot(&moved) + moment.dot(&turned)
    };
    (0..state.displacement.len()).map(of_node).sum()
}

/// Force and moment about the wing base of supports and springs to the ground.
fn supports(
    wing: &Wing,
    equilibrium: &Equilibrium,
    rest: &State,
    state: &State,
    loads: &Loads,
) -> (Vector3<f64>, Vector3<f64>) {
    // without springs, what is left where one holds is the force of the spring
    let mut free = Model {
        springs: Vec::new(),
        blend: None,
        ..wing.model.clone()
    };
    if let Some(blend) = &wing.model.blend {
        let linear = free.linear(&equilibrium.pattern, rest.clone(), blend.linear_share);
        free.blend = Some(Arc::new(linear));
    }
    let residual = free.residual(&equilibrium.pattern, state, loads);
    let (mut force_n, mut moment_n_m) = (Vector3::zeros(), Vector3::zeros());
    for (node, held) in wing.model.held.iter().enumerate() {
        let is_sprung = wing.model.springs.iter().any(|spring| spring.node == node);
        let held = held.map(|held| if held || is_sprung { 1.0 } else { 0.0 });
        let (force, moment) = at_node(equilibrium, &residual, node);
        let force = force.component_mul(&Vector3::from_column_slice(&held[..3]));
        let moment = moment.component_mul(&Vector3::from_column_slice(&held[3..]));
        force_n += force;
        moment_n_m += (wing.model.nodes[node] + state.displacement[node]).cross(&force) + moment;
    }
    (force_n, moment_n_m)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::for_design;

    /// Loads, supports and work of a solved wing, and of the same with every displacement a percent larger.
    fn two(file: &str, sets: &[&str]) -> [Balance; 2] {
        let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
        let file = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(file);
        let loaded = Design::load(&file, &sets).unwrap();
        let (_, mesh) = for_design(&loaded.design, None).unwrap();
        let progress = Progress::quiet();
        let solved = super::super::solve(&loaded.design, &mesh, None, &progress).unwrap();
        let at = |factor: f64| {
            let moved = |_: &State| {
                let mut state = solved.state.clone();
                for (own, rest) in state.displacement.iter_mut().zip(&solved.rest.displacement) {
                    *own = rest + factor * (*own - rest);
                }
                state
            };
            let wing = Wing::new(&loaded.design, &mesh, None).unwrap();
            let mut equilibrium = wing.equilibrium().unwrap();
            let state = moved(&solved.rest);
            let loads = wing.loads_on(&state).unwrap();
            balance(&wing, &mut equilibrium, &solved.rest, &state, &loads).unwrap()
        };
        [at(1.0), at(1.01)]
    }

    #[test]
    fn forces_moments_and_work_balance_on_a_solved_wing_and_on_no_other() {
        let coarse = "mesh.refine=0.3";
        let spring = "root.pitch_stiffness_n_m_per_rad=0.005";
        let v2 = "designs/twist-v2.toml";
        let wings = [
            (v2, &[coarse][..]),
            (v2, &[coarse, spring]),
            ("designs/tang-dowell.toml", &["structure.kinematics=linear"]),
        ];
        for (file, sets) in wings {
            let [solved, other] = two(file, sets);
            let apart = |found: &Balance| (found.load_n + found.support_n).norm() / found.load_n.norm();
            let turned = |found: &Balance| {
                (found.load_moment_n_m + found.support_moment_n_m).norm() / found.load_moment_n_m.norm()
            };
            let work = |found: &Balance| (found.internal_work_j / found.load_work_j - 1.0).abs();
            assert!(solved.residual < 1e-6, "{sets:?}: {}", solved.residual);
            for (name, found) in [
                ("force", apart(&solved)),
                ("moment", turned(&solved)),
                ("work", work(&solved)),
            ] {
                assert!(found < 1e-5, "{sets:?}: {name}: {found}");
            }
            assert!(other.residual > 1e-3, "{sets:?}: {}", other.residual);
            assert!(work(&other) > 1e-3, "{sets:?}: {}", work(&other));
        }
    }
}
