//! A structure ready to be solved: pattern, factorization, scales; linear answers and tangent solves.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};

use super::StructureError;
use super::analysis::Analysis;
use super::factor::Factor;
use super::largest::larger;
use super::loads::Loads;
use super::model::Model;
use super::pattern::Pattern;
use super::state::State;

/// A structure with all that is made once for its mesh.
#[derive(Debug)]
pub struct Equilibrium<'m> {
    /// The structure.
    pub model: &'m Model,
    /// Pattern of its stiffness.
    pub pattern: Arc<Pattern>,
    pub(super) factor: Factor,
    pub(super) held: Vec<bool>,
    pub(super) values: Vec<f64>,
    /// Norm of the internal forces at rest, N; not zero with pre-tension.
    pub(super) rest_force_n: f64,
    pub(super) extent_m: f64,
    /// Longest side of the elements at each node, m.
    pub(super) side_m: Vec<f64>,
    /// Whether the last factorization is that of linear kinematics.
    pub(super) is_linear: bool,
}

/// An [`Equilibrium`] without its structure, to be taken up again: its pattern, and its last factorization.
#[derive(Debug)]
pub struct Tangent {
    pattern: Arc<Pattern>,
    factor: Factor,
    held: Vec<bool>,
    values: Vec<f64>,
    rest_force_n: f64,
    extent_m: f64,
    side_m: Vec<f64>,
    is_linear: bool,
}

impl<'m> Equilibrium<'m> {
    /// Hands over all but the structure.
    pub fn into_tangent(self) -> Tangent {
        let Equilibrium {
            pattern,
            factor,
            held,
            values,
            rest_force_n,
            extent_m,
            side_m,
            is_linear,
            ..
        } = self;
        Tangent {
            pattern,
            factor,
            held,
            values,
            rest_force_n,
            extent_m,
            side_m,
            is_linear,
        }
    }

    /// Takes up what was handed over, for the same structure.
    pub fn of_tangent(model: &'m Model, tangent: Tangent) -> Self {
        let Tangent {
            pattern,
            factor,
            held,
            values,
            rest_force_n,
            extent_m,
            side_m,
            is_linear,
        } = tangent;
        Equilibrium {
            model,
            pattern,
            factor,
            held,
            values,
            rest_force_n,
            extent_m,
            side_m,
            is_linear,
        }
    }

    /// Analyses a structure.
    ///
    /// # Errors
    /// If it cannot be analysed.
    pub fn new(model: &'m Model) -> Result<Self, StructureError> {
        Ok(Equilibrium::analysed(model, Analysis::of(model)?))
    }

    /// The same with the analysis, which must be of a structure that hangs together as this one ([`Analysis::is_of`]).
    pub fn analysed(model: &'m Model, analysis: Analysis) -> Self {
        let Analysis {
            pattern, symbolic, ..
        } = analysis;
        let factor = Factor::new(symbolic);
        let mut held = vec![false; pattern.len()];
        for (node, flags) in model.held.iter().enumerate() {
            for (component, &flag) in flags.iter().enumerate() {
                held[pattern.freedom(node, component)] = flag;
            }
        }
        let values = vec![0.0; pattern.entries()];
        let none = Loads::none(model.nodes.len());
        let rest = model.residual(&pattern, &State::at_rest(model.nodes.len()), &none);
        let rest_force_n = split_norm(&rest, |_| true).0;
        let extent_m = model.extent_m();
        Equilibrium {
            model,
            pattern,
            factor,
            held,
            values,
            rest_force_n,
            extent_m,
            side_m: longest_sides(model),
            is_linear: false,
        }
    }

    /// Factorizes by all threads from now on: faster for large structures, and the same to rounding only.
    pub fn spread(&mut self) {
        self.factor.spread();
    }

    /// Freedoms held by the supports.
    pub fn held(&self) -> &[bool] {
        &self.held
    }

    /// The state moved by a share of a step.
    pub fn moved(&self, state: &State, step: &[f64], share: f64) -> State {
        let mut moved = state.clone();
        for (node, (u, q)) in moved.displacement.iter_mut().zip(&mut moved.rotation).enumerate() {
            let at = self.pattern.freedom(node, 0);
            let part = |k: usize| Vector3::new(step[at + k], step[at + k + 1], step[at + k + 2]) * share;
            *u += part(0);
            *q = UnitQuaternion::new(part(3)) * *q;
            q.renormalize_fast();
        }
        moved
    }

    /// Scales of force (N) and moment (N·m) for the relative residual.
    pub fn scale(&self, state: &State, loads: &Loads) -> (f64, f64) {
        let (force, moment) = loads.size(state);
        let force = larger(larger(force, self.rest_force_n), moment / self.extent_m);
        let force = if force == 0.0 { 1.0 } else { force };
        (force, force * self.extent_m)
    }

    /// Relative residual of the free freedoms; not a number if a force, a load or the shape is none.
    pub fn relative(&self, residual: &[f64], (force, moment): (f64, f64)) -> f64 {
        let (f, m) = split_norm(residual, |at| !self.held[at]);
        larger(f / force, m / moment)
    }

    /// Relative residual that rounding of displacements and of lengths of elements alone makes.
    pub fn rounding(&self, state: &State, loads: &Loads) -> f64 {
        self.rounding_at(state, self.scale(state, loads))
    }

    pub(super) fn rounding_at(&self, state: &State, (force, moment): (f64, f64)) -> f64 {
        let (mut force_floor, mut moment_floor) = (0.0, 0.0);
        for (node, u) in state.displacement.iter().enumerate() {
            for component in 0..6 {
                let stiffness = self.values[self.pattern.diagonal(node, component)];
                if component < 3 {
                    force_floor += (stiffness * (u[component].abs() + 0.25 * self.side_m[node])).powi(2);
                } else {
                    moment_floor += stiffness.powi(2);
                }
            }
        }
        4.0 * f64::EPSILON * larger(force_floor.sqrt() / force, moment_floor.sqrt() / moment)
    }

    /// Factorizes the tangent at `state` under `loads` as it is; gives the number of negative pivots.
    ///
    /// # Errors
    /// If it is singular.
    pub fn factorize(&mut self, state: &State, loads: &Loads) -> Result<usize, StructureError> {
        self.is_linear = false;
        self.values.fill(0.0);
        self.model
            .tangent(&self.pattern, state, loads, None, &mut self.values);
        self.pattern.hold(&mut self.values, &self.held);
        if self.factor.positive(&self.pattern, &self.values) {
            return Ok(0);
        }
        self.factor.indefinite(&self.pattern, &self.values)
    }

    /// Linear answer to `loads` of a structure that stands in equilibrium without them at `about`: small rotations about that
    /// shape. The tangent there, with that of the linear forces among the loads, is factorized once, as long as nothing else is solved
    /// between.
    ///
    /// # Errors
    /// If it is singular.
    pub fn solve_linear(&mut self, about: &State, loads: &Loads) -> Result<State, StructureError> {
        if !self.is_linear {
            self.factorize(about, &loads.growing())?;
            self.is_linear = true;
        }
        let mut step = self.model.residual(&self.pattern, about, loads);
        step.iter_mut().for_each(|r| *r = -*r);
        self.solve_tangent(&mut step, 1);
        Ok(self.moved(about, &step, 1.0))
    }

    /// The internal forces of a state as loads that would hold it.
    pub fn internal_loads(&self, state: &State) -> Loads {
        let mut loads = Loads::none(self.model.nodes.len());
        let force = self.model.residual(&self.pattern, state, &loads);
        for node in 0..self.model.nodes.len() {
            let at = self.pattern.freedom(node, 0);
            loads.force_n[node] = Vector3::new(force[at], force[at + 1], force[at + 2]);
            loads.moment_n_m[node] = Vector3::new(force[at + 3], force[at + 4], force[at + 5]);
        }
        loads
    }

    /// The tangent of the last factorization, lower triangle, held freedoms taken out.
    pub fn tangent_values(&self) -> &[f64] {
        &self.values
    }

    /// Solves with the last factorization for `count` right-hand sides; held freedoms give zero.
    pub fn solve_tangent(&mut self, right: &mut [f64], count: usize) {
        for column in right.chunks_exact_mut(self.held.len()) {
            for (value, &held) in column.iter_mut().zip(&self.held) {
                if held {
                    *value = 0.0;
                }
            }
        }
        self.factor.solve(right, count);
    }
}

/// Norms of the force and moment parts of a residual over the freedoms that `counts`.
fn split_norm(residual: &[f64], counts: impl Fn(usize) -> bool) -> (f64, f64) {
    let (mut force, mut moment) = (0.0, 0.0);
    for (at, value) in residual.iter().enumerate() {
        if counts(at) {
            *(if at % 6 < 3 { &mut force } else { &mut moment }) += value * value;
        }
    }
    (force.sqrt(), moment.sqrt())
}

/// Longest side of the elements at each node, m.
fn longest_sides(model: &Model) -> Vec<f64> {
    let mut longest = vec![0.0_f64; model.nodes.len()];
    let shells = model.shells.iter().map(|shell| {
        let [a, b, c] = shell.nodes;
        [[a, b], [b, c], [c, a]]
    });
    let beams = model.beams.iter().map(|beam| beam.nodes);
    for [a, b] in shells.flatten().chain(beams) {
        let side = (model.nodes[a] - model.nodes[b]).norm();
        longest[a] = larger(longest[a], side);
        longest[b] = larger(longest[b], side);
    }
    longest
}
