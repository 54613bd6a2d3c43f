//! A fictitious damper at each node: steps of pseudo-time in place of whole Newton steps.
//!
//! An implicit step of the motion D u̇ = −F(u) solves (K + D/τ) d = −F. Its rests are the equilibria, and only stable ones draw it in.
//! As τ grows the step becomes Newton's. (Pseudo-transient continuation: Kelley & Keyes, SIAM J. Numer. Anal. 35 (1998) 508-523.)

use super::equilibrium::Equilibrium;
use super::largest::larger;

/// Smallest damping of a node, as a share of the mean: parts without mass must not move at once.
const LEAST: f64 = 1e-2;

/// Damping by freedom of the pattern that shares out 1 N·s/m over the wing as its mass is.
#[derive(Debug, Clone)]
pub struct Damper {
    by_freedom: Vec<f64>,
}

impl Damper {
    /// Of a structure: along each axis as its masses, about each axis those times the square of the longest side at the node.
    pub fn new(equilibrium: &Equilibrium) -> Self {
        let mass_kg = equilibrium.model.lumped_mass_kg();
        let total: f64 = mass_kg.iter().sum();
        let even = 1.0 / mass_kg.len() as f64;
        let mut by_freedom = vec![0.0; equilibrium.pattern.len()];
        for (node, mass_kg) in mass_kg.iter().enumerate() {
            let share = if total > 0.0 { mass_kg / total } else { even };
            let along = larger(share, LEAST * even);
            let about = along * equilibrium.side_m[node].powi(2);
            for component in 0..6 {
                let at = equilibrium.pattern.freedom(node, component);
                by_freedom[at] = if component < 3 { along } else { about };
            }
        }
        Damper { by_freedom }
    }

    /// Force and moment by freedom of a step under `rate_n_per_m` in all.
    pub fn force(&self, step: &[f64], rate_n_per_m: f64) -> Vec<f64> {
        let damped = self.by_freedom.iter().zip(step);
        damped
            .map(|(damping, step)| rate_n_per_m * damping * step)
            .collect()
    }
}

impl Equilibrium<'_> {
    /// Factorizes what [`Equilibrium::assemble_mixed`] left with a damper of `rate_n_per_m` in all. `false` if that is not positive definite:
    /// a larger rate can be tried after it.
    pub fn factorize_damped(&mut self, damper: &Damper, rate_n_per_m: f64) -> bool {
        self.is_linear = false;
        let mut values = self.values.clone();
        let pattern = &self.pattern;
        for node in 0..self.model.nodes.len() {
            for component in 0..6 {
                let damping = damper.by_freedom[pattern.freedom(node, component)];
                values[pattern.diagonal(node, component)] += rate_n_per_m * damping;
            }
        }
        pattern.hold(&mut values, &self.held);
        self.factor.positive(pattern, &values)
    }
}
