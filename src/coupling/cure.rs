//! The shape without load: flat, or pulled by the pre-tension of its films into what cure leaves.

use super::Near;
use super::error::CouplingError;
use super::newton::carried;
use super::wing::Wing;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Mixed, Model, NewtonSettings};

/// Mixed steps allowed from one start.
const PATIENCE: usize = 40;

/// The shape without load and the Newton steps it took.
///
/// # Errors
/// If it has no equilibrium.
pub fn cured(
    model: &Model,
    equilibrium: &mut Equilibrium,
    progress: &Progress,
) -> Result<(State, usize), CouplingError> {
    let flat = State::at_rest(model.nodes.len());
    match quickly(model, equilibrium, &[&flat], progress)? {
        (Some(state), steps) => Ok((state, steps)),
        (None, lost) => slowly(equilibrium, flat, lost, progress),
    }
}

/// The same of a wing with a solution nearby: from its shape without load. A trial is given up where that leads nowhere.
///
/// # Errors
/// If no equilibrium is found.
pub fn cured_near(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    near: &Near,
    progress: &Progress,
) -> Result<(State, usize), CouplingError> {
    let flat = State::at_rest(wing.model.nodes.len());
    let nearby = carried(wing, &near.solution.mesh, &near.solution.rest);
    let starts: Vec<&State> = nearby.iter().chain([&flat]).collect();
    match quickly(&wing.model, equilibrium, &starts, progress)? {
        (Some(state), steps) => Ok((state, steps)),
        (None, steps) if near.is_trial => Err(CouplingError::GivenUp { steps }),
        (None, lost) => slowly(equilibrium, flat, lost, progress),
    }
}

/// By mixed steps from the first start that they lead from to a stable shape, if any; and how many they were.
fn quickly(
    model: &Model,
    equilibrium: &mut Equilibrium,
    starts: &[&State],
    progress: &Progress,
) -> Result<(Option<State>, usize), CouplingError> {
    if let Some(blend) = &model.blend {
        return Ok((Some(blend.rest.clone()), 0));
    }
    let mut sheets = model.sheets.iter();
    if sheets.all(|sheet| sheet.pretension_n_per_m == 0.0) {
        return Ok((Some(State::at_rest(model.nodes.len())), 0));
    }
    let mut lost = 0;
    for start in starts {
        let (found, steps) = mixed(equilibrium, start, progress)?;
        lost += steps;
        if found.is_some() {
            return Ok((found, lost));
        }
    }
    Ok((None, lost))
}

/// Holds the flat film by forces and lets go of them.
fn slowly(
    equilibrium: &mut Equilibrium,
    flat: State,
    lost: usize,
    progress: &Progress,
) -> Result<(State, usize), CouplingError> {
    let mut state = flat;
    let inner = equilibrium.internal_loads(&state);
    let none = Loads::none(state.displacement.len());
    let settings = NewtonSettings::default();
    let report = equilibrium.solve(&mut state, &inner, &none, &settings, progress)?;
    Ok((state, lost + report.steps))
}

/// The equilibrium that mixed steps lead to from `start`, if they settle on one that is stable; and how many they were.
fn mixed(
    equilibrium: &mut Equilibrium,
    start: &State,
    progress: &Progress,
) -> Result<(Option<State>, usize), CouplingError> {
    let none = Loads::none(start.displacement.len());
    let tolerance = NewtonSettings::default().tolerance;
    let mut way = Mixed::new();
    let mut state = start.clone();
    for count in 0..=PATIENCE {
        progress.check()?;
        let distance = equilibrium.assemble_mixed(&state, &none, &way);
        if distance.relative <= tolerance.max(distance.rounding) {
            let is_stable = equilibrium
                .factorize(&state, &none)
                .is_ok_and(|negative| negative == 0);
            return Ok((is_stable.then_some(state), count));
        }
        let is_lost = count == PATIENCE || !distance.relative.is_finite();
        if is_lost || equilibrium.factorize_mixed(&state, 0.0, &mut way).is_err() {
            return Ok((None, count));
        }
        let mut step = distance.right;
        equilibrium.solve_tangent(&mut step, 1);
        state = equilibrium.move_mixed(&state, &mut step, &mut way);
    }
    Ok((None, PATIENCE))
}
