//! The load at which the unbuckled equilibrium of a beam stops being stable.

use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Model, NewtonSettings};

use super::VerifyError;

/// Halvings of the interval: to 1e-8 of it.
const HALVINGS: usize = 27;

/// Share of `full`, between `low` and `high`, at which the tangent of a structure turns indefinite.
///
/// # Errors
/// If the structure cannot be solved.
pub fn critical_share(
    model: &Model,
    full: &Loads,
    [mut low, mut high]: [f64; 2],
    progress: &Progress,
) -> Result<f64, VerifyError> {
    let mut equilibrium = Equilibrium::new(model)?;
    let none = Loads::none(model.nodes.len());
    for _ in 0..HALVINGS {
        let share = 0.5 * (low + high);
        let loads = full.between(&none, share);
        let mut state = State::at_rest(model.nodes.len());
        equilibrium.solve(&mut state, &none, &loads, &NewtonSettings::default(), progress)?;
        if equilibrium.factorize(&state, &loads)? > 0 {
            high = share;
        } else {
            low = share;
        }
    }
    Ok(0.5 * (low + high))
}
