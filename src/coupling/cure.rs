//! The shape without load: flat, or pulled by the pre-tension of its films into what cure leaves.

use super::error::CouplingError;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Model, NewtonSettings};

/// The shape without load and the Newton steps it took: the flat film is held by forces, which are let go of.
///
/// # Errors
/// If it has no equilibrium.
pub fn cured(
    model: &Model,
    equilibrium: &mut Equilibrium,
    progress: &Progress,
) -> Result<(State, usize), CouplingError> {
    if let Some(known) = without_cure(model) {
        return Ok((known, 0));
    }
    let mut state = State::at_rest(model.nodes.len());
    let inner = equilibrium.internal_loads(&state);
    let none = Loads::none(state.displacement.len());
    let settings = NewtonSettings::default();
    let report = equilibrium.solve(&mut state, &inner, &none, &settings, progress)?;
    Ok((state, report.steps))
}

/// The shape without load where no film is pre-tensioned, or it is known already.
pub(super) fn without_cure(model: &Model) -> Option<State> {
    if let Some(blend) = &model.blend {
        return Some(blend.rest.clone());
    }
    let mut sheets = model.sheets.iter();
    let is_loose = sheets.all(|sheet| sheet.pretension_n_per_m == 0.0);
    is_loose.then(|| State::at_rest(model.nodes.len()))
}
