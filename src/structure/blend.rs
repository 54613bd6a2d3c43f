//! A path from the linear model to the model itself: residual (1 − s) · linear + s · large rotation.
//!
//! The linear model is that about a shape without load, in displacements and rotation vectors from there: a potential
//! ½ Δᵀ K₀ Δ − loads · Δ. Its gradient with spins is Hᵀ (K₀ Δ − loads), H from spins to rotation vectors, so that both models
//! are gradients and the tangent stays symmetric.

use nalgebra::Vector3;

use super::loads::Loads;
use super::model::{Aid, Assembled, Model};
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
    /// Of a model whose shape without load is `rest`.
    pub fn new(model: &Model, pattern: &Pattern, rest: State, linear_share: f64) -> Self {
        let mut tangent = vec![0.0; pattern.entries()];
        let none = Loads::none(model.nodes.len());
        model.large_assemble(pattern, &rest, &none, None, &mut tangent);
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

    /// Internal forces less loads of the linear model, against displacements and rotation vectors.
    fn linear_residual(&self, model: &Model, pattern: &Pattern, loads: &Loads, moved: &[f64]) -> Vec<f64> {
        let mut residual = model.large_residual(pattern, &self.rest, loads);
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

    /// Mixes its share into the residual of the large-rotation model, and into its tangent if that is asked for.
    fn mix(
        &self,
        model: &Model,
        pattern: &Pattern,
        state: &State,
        loads: &Loads,
        residual: &mut [f64],
        tangent: Option<(&[f64], &mut [f64])>,
    ) {
        let moved = self.moved(pattern, state);
        let turn = |node: usize| Vector3::from_column_slice(&moved[pattern.freedom(node, 3)..][..3]);
        let linear = self.linear_residual(model, pattern, loads, &moved);
        let moment = |node: usize| Vector3::from_column_slice(&linear[pattern.freedom(node, 3)..][..3]);
        let (share, rest) = (self.linear_share, 1.0 - self.linear_share);
        for node in 0..model.nodes.len() {
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
        for node in 0..model.nodes.len() {
            let correction = moment_correction(&turn(node), &moment(node));
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

impl Model {
    /// Internal forces less loads by freedom of `pattern` (N, N·m), held freedoms included.
    pub fn residual(&self, pattern: &Pattern, state: &State, loads: &Loads) -> Vec<f64> {
        let mut residual = self.large_residual(pattern, state, loads);
        if let Some(blend) = &self.blend {
            blend.mix(self, pattern, state, loads, &mut residual, None);
        }
        residual
    }

    /// Residual as in [`Model::residual`], and its tangent added to `values`; the tangent with the help of
    /// `aid` if there is one.
    pub fn tangent(
        &self,
        pattern: &Pattern,
        state: &State,
        loads: &Loads,
        aid: Option<&Aid>,
        values: &mut [f64],
    ) -> Vec<f64> {
        self.assemble(pattern, state, loads, aid, values).residual
    }

    /// As [`Model::tangent`], with the residual that a mixed step starts from too.
    pub fn assemble(
        &self,
        pattern: &Pattern,
        state: &State,
        loads: &Loads,
        aid: Option<&Aid>,
        values: &mut [f64],
    ) -> Assembled {
        let Some(blend) = &self.blend else {
            return self.large_assemble(pattern, state, loads, aid, values);
        };
        let mut large = vec![0.0; values.len()];
        let Assembled {
            mut residual,
            mut linearized,
        } = self.large_assemble(pattern, state, loads, aid, &mut large);
        linearized.iter_mut().zip(&residual).for_each(|(l, r)| *l -= r);
        let tangent = Some((large.as_slice(), values));
        blend.mix(self, pattern, state, loads, &mut residual, tangent);
        for (more, r) in linearized.iter_mut().zip(&residual) {
            *more = r + (1.0 - blend.linear_share) * *more;
        }
        Assembled { residual, linearized }
    }
}
