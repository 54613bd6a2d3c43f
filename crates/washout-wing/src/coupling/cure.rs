//! The shape without load: flat, or pulled by the pre-tension of its films into what cure leaves.

use super::error::CouplingError;
use super::pace::Pace;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Mixed, Model, NewtonSettings, StructureError, larger};

/// Newton steps after which the film is let go of at once, and steps after which that is given up and it is let go of step by step, however
/// many these are.
const PATIENCE_BY_STEPS: usize = 300;
const PATIENCE: usize = 600;

/// The shape without load and the Newton steps it took: the flat film is held by forces, which are let go of; step by step, and where that
/// meets no equilibrium, at once in pseudo-time.
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
    let hasty = NewtonSettings {
        patience: PATIENCE_BY_STEPS,
        ..settings
    };
    let lost = match equilibrium.solve(&mut state, &inner, &none, &hasty, progress) {
        Ok(report) => return Ok((state, report.steps)),
        Err(StructureError::NoEquilibrium { steps, .. }) => steps,
        Err(error) => return Err(error.into()),
    };
    let (found, more) = let_go(equilibrium, &settings, progress)?;
    if let Some(found) = found {
        return Ok((found, lost + more));
    }
    let report = equilibrium.solve(&mut state, &inner, &none, &settings, progress)?;
    Ok((state, lost + more + report.steps))
}

/// The shape in which the wing comes to rest when the flat film is let go of and damped, if it does; and the steps until then.
fn let_go(
    equilibrium: &mut Equilibrium,
    settings: &NewtonSettings,
    progress: &Progress,
) -> Result<(Option<State>, usize), CouplingError> {
    let mut state = State::at_rest(equilibrium.model.nodes.len());
    let none = Loads::none(state.displacement.len());
    let mut way = Mixed::new();
    let scale = equilibrium.scale(&state, &none);
    let mut pace = Pace::new(equilibrium, scale.0);
    for count in 0..=PATIENCE {
        progress.check()?;
        let distance = equilibrium.assemble_mixed(&state, &none, &way);
        if distance.relative <= larger(settings.tolerance, 2.0 * distance.rounding) {
            return Ok((Some(state), count));
        }
        let (turn, rate) = pace.turn_and_rate();
        progress.say(format_args!(
            "cure {count}: turn {turn:.1e}, rate {rate:.1e} N/m, residual {:.1e}",
            distance.relative
        ));
        if !distance.relative.is_finite() || !pace.factorize(equilibrium, &distance, scale) {
            return Ok((None, count));
        }
        let mut step = distance.right.clone();
        equilibrium.solve_tangent(&mut step, 1);
        state = pace.step(equilibrium, &state, &distance, scale, (&mut step, &mut way));
    }
    Ok((None, PATIENCE))
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
