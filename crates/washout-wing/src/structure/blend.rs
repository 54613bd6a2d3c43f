//! A path from the linear model to the model itself: residual (1 − s) · linear + s · large rotation.
//!
//! The linear model is that about a shape without load, in displacements and rotation vectors from there: a potential
//! ½ Δᵀ K₀ Δ − loads · Δ. Its gradient with spins is Hᵀ (K₀ Δ − loads), H from spins to rotation vectors, so that both models
//! are gradients and the tangent stays symmetric.

use nalgebra::Vector3;

use super::loads::Loads;
use super::pattern::Pattern;
use super::rotation::{moment_correction, spin_to_vector};
use super::state::State;

/// The linear model that stands beside a model, and its share.
#[derive(Debug, Clone)]
pub struct Blend {
    /// Share of the linear model, 0 to 1.
    pub linear_share: f64,
    /// Shape without load, about which it is linear.
    pub rest: State,
    /// Tangent there.
    tangent: Vec<f64>,
}

impl Blend {
    /// About the shape without load `rest`, where the tangent is `tangent`.
    pub fn new(rest: State, tangent: Vec<f64>, linear_share: f64) -> Self {
        Blend {
            linear_share,
            rest,
            tangent,
        }
    }

    /// Displacements and rotation vectors from the rest.
    fn moved(&self, pattern: &Pattern, state: &State) -> Vec<f64> {
        let mut moved = vec![0.0; pattern.len()];
        for (node, (u, q)) in state.displacement.iter().zip(&state.rotation).enumerate() {
            let at = pattern.freedom(node, 0);
            let turned = (q * self.rest.rotation[node].inverse()).scaled_axis();
            moved[at..at + 3].copy_from_slice((u - self.rest.displacement[node]).as_slice());
            moved[at + 3..at + 6].copy_from_slice(turned.as_slice());
        }
        moved
    }

    /// Internal forces less loads of the linear model, against displacements and rotation vectors; `residual`: the same at the rest.
    fn linear_residual(
        &self,
        pattern: &Pattern,
        loads: &Loads,
        mut residual: Vec<f64>,
        moved: &[f64],
    ) -> Vec<f64> {
        let stretched = pattern.multiply(&self.tangent, moved);
        residual.iter_mut().zip(stretched).for_each(|(r, k)| *r += k);
        if !loads.linear.is_empty() {
            let mut growing = vec![0.0; pattern.entries()];
            loads.growing().add_tangent(pattern, &self.rest, &mut growing);
            let grown = pattern.multiply(&growing, moved);
            residual.iter_mut().zip(grown).for_each(|(r, k)| *r += k);
        }
        residual
    }

    /// Mixes its share into the residual of the large-rotation model, and into its tangent if that is asked for; `at_rest`: the residual
    /// of that model at the rest.
    pub(super) fn mix(
        &self,
        (pattern, at_rest): (&Pattern, Vec<f64>),
        state: &State,
        loads: &Loads,
        residual: &mut [f64],
        tangent: Option<(&[f64], &mut [f64])>,
    ) {
        let moved = self.moved(pattern, state);
        let turn = |node: usize| Vector3::from_column_slice(&moved[pattern.freedom(node, 3)..][..3]);
        let linear = self.linear_residual(pattern, loads, at_rest, &moved);
        let moment = |node: usize| Vector3::from_column_slice(&linear[pattern.freedom(node, 3)..][..3]);
        let (share, rest) = (self.linear_share, 1.0 - self.linear_share);
        for node in 0..state.rotation.len() {
            let at = pattern.freedom(node, 0);
            let turned = spin_to_vector(&turn(node)).transpose() * moment(node);
            for i in 0..3 {
                residual[at + i] = rest * residual[at + i] + share * linear[at + i];
                residual[at + 3 + i] = rest * residual[at + 3 + i] + share * turned[i];
            }
        }
        let Some((large, values)) = tangent else {
            return;
        };
        let mut grown = self.tangent.clone();
        loads.growing().add_tangent(pattern, &self.rest, &mut grown);
        let mut turned = pattern.congruent(&grown, |node| spin_to_vector(&turn(node)));
        for node in 0..state.rotation.len() {
            let h = spin_to_vector(&turn(node));
            let correction = moment_correction(&turn(node), &moment(node), &h);
            let correction = 0.5 * (correction + correction.transpose());
            pattern.add_node(&mut turned, node, |i, j| {
                if i >= 3 && j >= 3 {
                    correction[(i - 3, j - 3)]
                } else {
                    0.0
                }
            });
        }
        for ((value, large), linear) in values.iter_mut().zip(large).zip(turned) {
            *value += rest * large + share * linear;
        }
    }
}
