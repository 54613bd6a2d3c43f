//! Small helpers that the proofs share, on top of those of `washout::verify`.

use nalgebra::{UnitQuaternion, Vector3};
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Loads, Model};
use washout::verify::answer::equilibrium;

/// Equilibrium from rest under dead loads.
pub fn solve(model: &Model, loads: &Loads) -> State {
    equilibrium(model, loads, &Progress::quiet()).unwrap()
}

/// A large turn about no special axis.
pub fn big_turn() -> UnitQuaternion<f64> {
    UnitQuaternion::new(Vector3::new(1.1, -0.8, 1.6))
}

/// |value/expected − 1|.
pub fn off(value: f64, expected: f64) -> f64 {
    (value / expected - 1.0).abs()
}
