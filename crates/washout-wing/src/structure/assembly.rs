//! Residual and tangent of a model, the linear model mixed in where there is one.

use super::blend::Blend;
use super::loads::Loads;
use super::model::{Aid, Assembled, Model};
use super::pattern::Pattern;
use super::state::State;

impl Model {
    /// Where each entry of its stiffness matrix stands.
    pub fn pattern(&self) -> Pattern {
        let shells: Vec<[usize; 3]> = self.shells.iter().map(|shell| shell.nodes).collect();
        let beams: Vec<[usize; 2]> = self.beams.iter().map(|beam| beam.nodes).collect();
        Pattern::new(self.nodes.len(), &shells, &beams)
    }

    /// The linear model about its shape without load `rest`, to be mixed in with this share.
    pub fn linear(&self, pattern: &Pattern, rest: State, share: f64) -> Blend {
        let mut tangent = vec![0.0; pattern.entries()];
        let none = Loads::none(self.nodes.len());
        self.large_assemble(pattern, &rest, &none, None, &mut tangent);
        Blend::new(rest, tangent, share)
    }

    /// Internal forces less loads by freedom of `pattern` (N, N·m), held freedoms included.
    pub fn residual(&self, pattern: &Pattern, state: &State, loads: &Loads) -> Vec<f64> {
        let mut residual = self.large_residual(pattern, state, loads);
        if let Some(blend) = &self.blend {
            let at_rest = self.large_residual(pattern, &blend.rest, loads);
            blend.mix((pattern, at_rest), state, loads, &mut residual, None);
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
        let at_rest = self.large_residual(pattern, &blend.rest, loads);
        blend.mix((pattern, at_rest), state, loads, &mut residual, tangent);
        for (more, r) in linearized.iter_mut().zip(&residual) {
            *more = r + (1.0 - blend.linear_share) * *more;
        }
        Assembled { residual, linearized }
    }
}
