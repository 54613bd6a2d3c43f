//! Buckling of beams: a strip cantilever tips over sideways under its tip load; Euler's column.
//!
//! Timoshenko & Gere, Theory of Elastic Stability, 2nd ed. (1961), §2.2 and §6.3.
//!
//! ```text
//!   |====================   P_cr = 4.012599 √(EI_minor GJ) / L² at the centroid, EI_major ≫ EI_minor
//!   |                  ↓ P         (4.012599: root with the Bessel function J₋₁⸝₄)
//!   |====================← P   P_cr = π² EI / (4 L²)
//! ```
//!
//! The tangent in the unbuckled equilibrium is factorized; the load at which it gets a negative pivot is found by halving.

use std::f64::consts::PI;

use nalgebra::Vector3;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, NewtonSettings};

use crate::support::{chain, off, section, straight};

/// Load at which the tangent of a cantilever of length 1 turns indefinite, between `low` and `high`.
fn critical(stiffness: [f64; 6], direction: Vector3<f64>, [mut low, mut high]: [f64; 2]) -> f64 {
    let elements = 24;
    let model = chain(straight(1.0, elements), &Vector3::z(), section(stiffness));
    let mut equilibrium = Equilibrium::new(&model).unwrap();
    let none = Loads::none(elements + 1);
    for _ in 0..20 {
        let load = 0.5 * (low + high);
        let mut loads = none.clone();
        loads.force_n[elements] = load * direction;
        let mut state = State::at_rest(elements + 1);
        equilibrium
            .solve(
                &mut state,
                &none,
                &loads,
                &NewtonSettings::default(),
                &Progress::quiet(),
            )
            .unwrap();
        if equilibrium.factorize(&state, &loads).unwrap() > 0 {
            high = load;
        } else {
            low = load;
        }
    }
    0.5 * (low + high)
}

#[test]
fn strip_cantilever_tips_over_at_the_load_of_timoshenko_and_gere() {
    let (minor, torsion) = (1.0, 0.7_f64);
    let exact = 4.012_599 * (minor * torsion).sqrt();
    let load = critical(
        [1e8, 1e8, 1e8, torsion, minor, 1e5],
        -Vector3::y(),
        [0.5 * exact, 1.5 * exact],
    );
    println!("lateral buckling: {}", load / exact);
    assert!(off(load, exact) < 2e-3, "{load} {exact}");
}

#[test]
fn column_buckles_at_euler_s_load() {
    let exact = PI * PI / 4.0;
    let load = critical(
        [1e8, 1e8, 1e8, 1.0, 1.0, 3.0],
        -Vector3::x(),
        [0.5 * exact, 1.5 * exact],
    );
    println!("Euler: {}", load / exact);
    assert!(off(load, exact) < 1e-3, "{load} {exact}");
}
