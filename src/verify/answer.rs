//! Answers of a structure: small displacements, equilibrium, a load path, natural frequencies.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Model, NewtonSettings, Vibration, lowest_modes};

use super::VerifyError;

/// Small displacement and rotation of every node under dead loads: one solve with the tangent at rest.
///
/// # Errors
/// If the structure at rest is not stable.
pub fn linear(model: &Model, loads: &Loads) -> Result<Vec<[Vector3<f64>; 2]>, VerifyError> {
    let mut equilibrium = Equilibrium::new(model)?;
    let (rest, none) = (State::at_rest(model.nodes.len()), Loads::none(model.nodes.len()));
    let negative = equilibrium.factorize(&rest, &none)?;
    if negative > 0 {
        return Err(VerifyError::Unstable { negative });
    }
    let with = model.residual(&equilibrium.pattern, &rest, loads);
    let without = model.residual(&equilibrium.pattern, &rest, &none);
    let mut right: Vec<f64> = with
        .iter()
        .zip(without)
        .map(|(with, without)| without - with)
        .collect();
    equilibrium.solve_tangent(&mut right, 1);
    let motion = |node: usize| {
        let at = equilibrium.pattern.freedom(node, 0);
        [
            Vector3::from_column_slice(&right[at..at + 3]),
            Vector3::from_column_slice(&right[at + 3..at + 6]),
        ]
    };
    Ok((0..model.nodes.len()).map(motion).collect())
}

/// Equilibrium from rest under dead loads.
///
/// # Errors
/// If none is found.
pub fn equilibrium(model: &Model, loads: &Loads, progress: &Progress) -> Result<State, VerifyError> {
    let mut equilibrium = Equilibrium::new(model)?;
    let mut state = State::at_rest(model.nodes.len());
    let none = Loads::none(model.nodes.len());
    equilibrium.solve(&mut state, &none, loads, &NewtonSettings::default(), progress)?;
    Ok(state)
}

/// Something read off the equilibrium under each share of a load, one share after the other.
///
/// # Errors
/// If no equilibrium is found for one of them.
pub fn follow<T>(
    model: &Model,
    full: &Loads,
    shares: impl IntoIterator<Item = f64>,
    progress: &Progress,
    read: impl Fn(&State) -> T,
) -> Result<Vec<T>, VerifyError> {
    let mut equilibrium = Equilibrium::new(model)?;
    let mut state = State::at_rest(model.nodes.len());
    let none = Loads::none(model.nodes.len());
    let mut from = none.clone();
    let mut found = Vec::new();
    for share in shares {
        let to = full.between(&none, share);
        equilibrium.solve(&mut state, &from, &to, &NewtonSettings::default(), progress)?;
        found.push(read(&state));
        from = to;
    }
    Ok(found)
}

/// The lowest `count` natural frequencies about the shape at rest, Hz.
///
/// # Errors
/// If they are not found, or the structure at rest is not stable.
pub fn frequencies(model: &Model, count: usize, progress: &Progress) -> Result<Vec<f64>, VerifyError> {
    let mut equilibrium = Equilibrium::new(model)?;
    let (state, loads) = (State::at_rest(model.nodes.len()), Loads::none(model.nodes.len()));
    match lowest_modes(&mut equilibrium, &state, &loads, &[], count, progress)? {
        Vibration::Stable(modes) => Ok(modes.iter().map(|mode| mode.frequency_hz).collect()),
        Vibration::Unstable { negative } => Err(VerifyError::Unstable { negative }),
    }
}
