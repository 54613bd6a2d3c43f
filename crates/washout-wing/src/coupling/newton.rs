//! Air and structure in one Newton iteration: every step updates shape and air load together.
//!
//! The step solves (K − A S) d = −F with the mixed tangent K of the structure ([`crate::structure::mixed`]) and the air's
//! own change (see [`super::feedback`]); only the residual decides what equilibrium is. Where the steps do not
//! settle, or settle on a shape that is not stable, the wing moves in pseudo-time; the fixed point is the slow path beside both.

use super::error::CouplingError;
use super::feedback::Feedback;
use super::fixed_point::{Coupled, twists};
use super::recycled::Recycled;
use super::wing::Wing;
use crate::input::design::Coupling;
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Mixed, larger};
use nalgebra::Vector3;

/// Residual of the linear solve over that of the step: far from the solution, and near it.
const LOOSE: f64 = 1e-3;
const TIGHT: f64 = 1e-6;

/// Share of the tension of a flat film that holds it in the first step.
const FIRST_TENSION: f64 = 1.0;

/// Where an iteration starts.
#[derive(Debug, Clone, Copy)]
pub struct Start<'a> {
    /// Shape without load, from which twist is told.
    pub rest: &'a State,
    /// Shape to start from: that without load, or an equilibrium nearby.
    pub shape: &'a State,
    /// Whether the films hang in that shape already.
    pub is_loaded: bool,
    /// Step by freedom from there to where the shape is expected, to first order.
    pub step: Option<&'a [f64]>,
}

/// Iterates; the inner error is the number of steps that did not settle.
///
/// # Errors
/// If the structure cannot be solved at all, or the user asks to stop.
pub fn iterate(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    start: Start,
    coupling: &Coupling,
    progress: &Progress,
) -> Result<Result<Coupled, usize>, CouplingError> {
    let rest_twist = twists(&wing.strips.shapes(start.rest));
    let mut coupled = Coupled::at(start.shape.clone(), Loads::none(wing.model.nodes.len()));
    let mut way = Mixed::new();
    let mut known = Recycled::new();
    if let Some(step) = start.step.filter(|step| step.len() == equilibrium.pattern.len()) {
        coupled.state = equilibrium.move_mixed(start.shape, &mut step.to_vec(), &mut way);
    }
    let mut shapes = wing.strips.shapes(&coupled.state);
    loop {
        progress.check()?;
        // a step too far may do that: the fixed point tells what is at fault where it meets it too
        let Ok(loads) = wing.loads(&shapes) else {
            return Ok(Err(coupled.newton_steps));
        };
        let distance = equilibrium.assemble_mixed(&coupled.state, &loads, &way);
        coupled.residual = distance.relative;
        progress.say(format_args!(
            "Newton step {}: twist changes by {:.1e} deg, residual {:.1e}",
            coupled.newton_steps, coupled.twist_change_deg, coupled.residual
        ));
        let allowed = larger(coupling.residual_tolerance, 2.0 * distance.rounding);
        if coupled.residual <= allowed && coupled.twist_change_deg <= coupling.twist_tolerance_deg {
            coupled.loads = loads;
            return Ok(Ok(coupled));
        }
        if !coupled.residual.is_finite() || coupled.iterations == coupling.max_iterations {
            return Ok(Err(coupled.newton_steps));
        }
        let tension = if coupled.iterations == 0 && !start.is_loaded {
            FIRST_TENSION * equilibrium.starting_tension_n_per_m(&coupled.state, &loads)
        } else {
            0.0
        };
        if equilibrium
            .factorize_mixed(&coupled.state, tension, &mut way)
            .is_err()
        {
            return Ok(Err(coupled.newton_steps));
        }
        let tolerance = if coupled.residual > 1e-2 { LOOSE } else { TIGHT };
        known.change();
        let found = match Feedback::new(wing, equilibrium, &shapes) {
            Ok(mut feedback) => feedback.solve(&distance.right, tolerance, &mut known),
            Err(_) => None,
        };
        let Some(mut step) = found else {
            return Ok(Err(coupled.newton_steps));
        };
        let state = equilibrium.move_mixed(&coupled.state, &mut step, &mut way);
        shapes = coupled.step_to(wing, state, &shapes, &rest_twist);
    }
}

/// A shape of `mesh` on the mesh of a wing, whose nodes may stand elsewhere at rest: each moves as its rotation has it,
/// so that the films are not strained. `None` if the mesh has another pattern.
pub fn carried(wing: &Wing, mesh: &Mesh, shape: &State) -> Option<State> {
    let model = &wing.model;
    let triangles = model.shells.iter().map(|shell| shell.nodes);
    let is_alike = model.nodes.len() == mesh.nodes.len()
        && (model.shells.is_empty() || triangles.eq(mesh.triangles.iter().copied()))
        && (model.beams.iter().map(|beam| beam.nodes)).eq(mesh.beams.iter().map(|beam| beam.nodes));
    if !is_alike {
        return None;
    }
    let mut state = shape.clone();
    let nodes = state.displacement.iter_mut().zip(&state.rotation);
    for ((u, q), (to, from)) in nodes.zip(model.nodes.iter().zip(&mesh.nodes)) {
        let step = to - Vector3::from(*from);
        *u += q * step - step;
    }
    Some(state)
}
