//! The load at which the unbuckled equilibrium of a beam cantilever stops being stable.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, NewtonSettings};

use super::VerifyError;
use super::chain::{chain, section, straight};

/// Halvings of the interval: to 1e-8 of it.
const HALVINGS: usize = 27;

/// Tip load along `direction`, between `low` and `high`, at which the tangent of a cantilever of length 1 turns indefinite.
///
/// # Errors
/// If the structure cannot be solved.
pub fn critical_load(
    elements: usize,
    stiffness: [f64; 6],
    direction: Vector3<f64>,
    [mut low, mut high]: [f64; 2],
    progress: &Progress,
) -> Result<f64, VerifyError> {
    let model = chain(straight(1.0, elements), &Vector3::z(), section(stiffness)?)?;
    let mut equilibrium = Equilibrium::new(&model)?;
    let none = Loads::none(elements + 1);
    for _ in 0..HALVINGS {
        let load = 0.5 * (low + high);
        let mut loads = none.clone();
        loads.force_n[elements] = load * direction;
        let mut state = State::at_rest(elements + 1);
        equilibrium.solve(&mut state, &none, &loads, &NewtonSettings::default(), progress)?;
        if equilibrium.factorize(&state, &loads)? > 0 {
            high = load;
        } else {
            low = load;
        }
    }
    Ok(0.5 * (low + high))
}
