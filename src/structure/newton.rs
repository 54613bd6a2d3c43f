//! Equilibrium under dead loads: Newton's method with an energy line search and load increments that adapt.
//!
//! Two aids help on the way and vanish before the end, so neither changes the answer: the tangent (never the residual) of
//! thin films gets a share of a fictitious tension while the residual is large, and a tangent that is not positive
//! definite is raised until it is.

use nalgebra::{UnitQuaternion, Vector3};

use super::StructureError;
use super::factor::Factor;
use super::loads::Loads;
use super::model::Model;
use super::pattern::Pattern;
use super::shell::{Compression, Sheet};
use super::state::State;
use crate::progress::Progress;

/// How an equilibrium is sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonSettings {
    /// Residual relative to the load at which it is met.
    pub tolerance: f64,
    /// Load increments to begin with; more are made where they are needed.
    pub increments: usize,
    /// Newton steps per increment before it is cut.
    pub max_steps: usize,
}

impl Default for NewtonSettings {
    fn default() -> Self {
        NewtonSettings {
            tolerance: 1e-9,
            increments: 1,
            max_steps: 150,
        }
    }
}

/// What it took to find an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NewtonReport {
    /// Newton steps in all.
    pub steps: usize,
    /// Increments that were completed.
    pub increments: usize,
    /// Residual relative to the load.
    pub residual: f64,
}

/// How steps are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    /// The whole Newton step, as long as no node turns too far.
    Whole,
    /// As far along the step as the energy falls.
    Searched,
}

/// Relative residual below which the fictitious tension is taken back step by step.
const NEAR: f64 = 3.0;

/// Fictitious tension over the tension that the load would cause in a film.
const TENSION_SHARE: f64 = 0.1;

/// A structure with all that is made once for its mesh.
#[derive(Debug)]
pub struct Equilibrium<'m> {
    /// The structure.
    pub model: &'m Model,
    /// Pattern of its stiffness.
    pub pattern: Pattern,
    factor: Factor,
    held: Vec<bool>,
    values: Vec<f64>,
    work: Vec<f64>,
    /// Norm of the internal forces at rest, N; not zero with pre-tension.
    rest_force_n: f64,
    extent_m: f64,
    /// Longest side of the elements at each node, m.
    side_m: Vec<f64>,
    /// Whether the last factorization is that at rest.
    at_rest: bool,
}

impl<'m> Equilibrium<'m> {
    /// Analyses a structure.
    ///
    /// # Errors
    /// If it cannot be analysed.
    pub fn new(model: &'m Model) -> Result<Self, StructureError> {
        let pattern = Pattern::new(model);
        let factor = Factor::new(&pattern)?;
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
        Ok(Equilibrium {
            model,
            pattern,
            factor,
            held,
            work: values.clone(),
            values,
            rest_force_n,
            extent_m,
            side_m: longest_sides(model),
            at_rest: false,
        })
    }

    /// Freedoms held by the supports.
    pub fn held(&self) -> &[bool] {
        &self.held
    }

    /// Moves `state`, in equilibrium under `from`, to equilibrium under `to`.
    ///
    /// # Errors
    /// If none is found; `state` is then left as it was.
    pub fn solve(
        &mut self,
        state: &mut State,
        from: &Loads,
        to: &Loads,
        settings: &NewtonSettings,
        progress: &Progress,
    ) -> Result<NewtonReport, StructureError> {
        let mut report = NewtonReport::default();
        let mut step = 1.0 / settings.increments.max(1) as f64;
        let mut share = 0.0;
        let mut current = state.clone();
        while share < 1.0 {
            let next = if share + step > 1.0 - 1e-9 {
                1.0
            } else {
                share + step
            };
            let loads = to.between(from, next);
            // whole steps pass through states of high energy and so along inextensible bending; searched steps go surely
            let mut found = Err(f64::INFINITY);
            let before = report.steps;
            for &way in self.ways(next - share) {
                found = self.attempt(&current, &loads, settings, way, &mut report, progress)?;
                if found.is_ok() {
                    break;
                }
            }
            match found {
                Ok(found) => {
                    current = found;
                    share = next;
                    report.increments += 1;
                    // an increment that took many steps is as long as it should be
                    if report.steps - before <= 12 {
                        step *= 1.5;
                    }
                }
                Err(residual) => {
                    step = 0.4 * (next - share);
                    if step < 1e-3 {
                        return Err(StructureError::NoEquilibrium {
                            load_share: next,
                            residual,
                            steps: report.steps,
                        });
                    }
                }
            }
        }
        *state = current;
        Ok(report)
    }

    /// Newton's method at fixed loads; the inner error is the best relative residual.
    fn attempt(
        &mut self,
        start: &State,
        loads: &Loads,
        settings: &NewtonSettings,
        way: Way,
        report: &mut NewtonReport,
        progress: &Progress,
    ) -> Result<Result<State, f64>, StructureError> {
        let mut state = start.clone();
        let scale = self.scale(&state, loads);
        let (force, moment) = loads.size(&state);
        let tension = self.fictitious_tension(force.max(moment / self.extent_m));
        let mut raise = 0.0;
        let mut best = f64::INFINITY;
        let mut guess = None;
        let (mut share, mut last) = (1.0_f64, f64::INFINITY);
        // plates and rods find equilibrium in a dozen whole steps or not at all; films wrinkle for longer
        let most = if way == Way::Whole && tension == 0.0 {
            20
        } else {
            settings.max_steps
        };
        for count in 0..=most {
            progress.check()?;
            self.values.fill(0.0);
            let residual = self
                .model
                .tangent(&self.pattern, &state, loads, guess.as_ref(), &mut self.values);
            let size = self.relative(&residual, scale);
            if !size.is_finite() {
                return Ok(Err(best));
            }
            best = best.min(size);
            // below the estimate of rounding it goes on as long as steps still help
            let at_floor = size <= self.rounding_at(&state, scale);
            if size <= settings.tolerance || (at_floor && (size > 0.3 * last || count == most)) {
                report.residual = size;
                return Ok(Ok(state));
            }
            if size < NEAR && size < 0.9 * last {
                share *= 0.2;
            } else if size < NEAR && size > 3.0 * last {
                share = (4.0 * share).min(1.0);
            }
            last = size;
            let mut step = self.step(&state, &residual, tension * share, way, &mut raise)?;
            report.steps += 1;
            let next = match way {
                Way::Whole => {
                    let length = self.longest(&step);
                    step.iter_mut().for_each(|s| *s *= length);
                    guess = Some(self.model.guess(&self.pattern, &state, &step, tension == 0.0));
                    Some(self.moved(&state, &step, 1.0))
                }
                Way::Searched => {
                    guess = None;
                    self.search(&state, &step, &residual, loads)
                }
            };
            match next {
                Some(next) => state = next,
                None if at_floor => {
                    report.residual = size;
                    return Ok(Ok(state));
                }
                None => return Ok(Err(best)),
            }
        }
        Ok(Err(best))
    }

    /// Newton step with a tangent that is raised until it is positive definite.
    fn step(
        &mut self,
        state: &State,
        residual: &[f64],
        tension: f64,
        way: Way,
        raise: &mut f64,
    ) -> Result<Vec<f64>, StructureError> {
        self.at_rest = false;
        if tension > 0.0 {
            self.model
                .add_tension(&self.pattern, state, tension, &mut self.values);
        }
        self.pattern.hold(&mut self.values, &self.held);
        let mut tries = 0;
        *raise *= 0.1;
        if *raise < 1e-9 {
            *raise = 0.0;
        }
        loop {
            self.work.copy_from_slice(&self.values);
            if *raise > 0.0 {
                self.pattern.raise_diagonal(&mut self.work, *raise);
            }
            if self.factor.positive(&self.pattern, &self.work) {
                break;
            }
            if way == Way::Whole && tension == 0.0 {
                self.factor.indefinite(&self.pattern, &self.work)?;
                break;
            }
            *raise = if *raise > 0.0 { 10.0 * *raise } else { 1e-8 };
            tries += 1;
            if tries > 12 {
                return Err(StructureError::Singular { node: 0 });
            }
        }
        let mut step: Vec<f64> = residual
            .iter()
            .zip(&self.held)
            .map(|(r, &held)| if held { 0.0 } else { -r })
            .collect();
        self.factor.solve(&mut step, 1);
        Ok(step)
    }

    /// Moves along a step as far as the energy falls.
    fn search(&self, state: &State, step: &[f64], residual: &[f64], loads: &Loads) -> Option<State> {
        let slope = |residual: &[f64]| -> f64 {
            (residual.iter().zip(step).zip(&self.held))
                .map(|((r, d), &held)| if held { 0.0 } else { r * d })
                .sum()
        };
        let start = slope(residual);
        let mut length = self.longest(step);
        let (mut low, mut low_slope) = (0.0, start);
        let mut high: Option<f64> = None;
        for _ in 0..12 {
            let moved = self.moved(state, step, length);
            let here = slope(&self.model.residual(&self.pattern, &moved, loads));
            if here.is_finite() && here <= 0.6 * start.abs() {
                if here.abs() <= 0.9 * start.abs() || high.is_none() {
                    return Some(moved);
                }
                (low, low_slope) = (length, here);
            } else {
                high = Some(length);
            }
            let top = high.unwrap_or(length);
            let guess = if here.is_finite() && here > 0.0 {
                low + (top - low) * low_slope / (low_slope - here)
            } else {
                0.5 * (low + top)
            };
            length = guess.clamp(low + 0.1 * (top - low), low + 0.7 * (top - low));
        }
        None
    }

    /// The ways to try for an increment, in order: films snap on whole steps, rods crawl on searched ones.
    fn ways(&self, increment: f64) -> &'static [Way] {
        let film = |sheet: &Sheet| matches!(sheet.compression, Compression::TensionField { .. });
        match (self.model.sheets.iter().any(film), increment < 0.05) {
            (true, _) => &[Way::Whole, Way::Searched],
            (false, true) => &[Way::Whole, Way::Searched],
            (false, false) => &[Way::Whole],
        }
    }

    /// Longest share of a step to take: no node turns by more than 0.5 rad.
    fn longest(&self, step: &[f64]) -> f64 {
        let turn = |spin: &[f64]| spin[3..6].iter().map(|r| r * r).sum::<f64>();
        let largest = step.chunks_exact(6).map(turn).fold(0.0, f64::max).sqrt();
        if largest > 0.5 { 0.5 / largest } else { 1.0 }
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
        let force = force.max(self.rest_force_n).max(moment / self.extent_m);
        let force = if force > 0.0 { force } else { 1.0 };
        (force, force * self.extent_m)
    }

    /// Relative residual of the free freedoms.
    pub fn relative(&self, residual: &[f64], (force, moment): (f64, f64)) -> f64 {
        let (f, m) = split_norm(residual, |at| !self.held[at]);
        (f / force).max(m / moment)
    }

    /// Relative residual that rounding of displacements and of lengths of elements alone makes.
    pub fn rounding(&self, state: &State, loads: &Loads) -> f64 {
        self.rounding_at(state, self.scale(state, loads))
    }

    fn rounding_at(&self, state: &State, (force, moment): (f64, f64)) -> f64 {
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
        4.0 * f64::EPSILON * (force_floor.sqrt() / force).max(moment_floor.sqrt() / moment)
    }

    /// Tension that a film under this much load would take up; zero for plates whose bending carries it.
    fn fictitious_tension(&self, force_n: f64) -> f64 {
        let area: f64 = self.model.shells.iter().map(|shell| shell.area_m2()).sum();
        let films = self.model.sheets.iter().filter(|sheet| {
            let bending = sheet.e_pa * sheet.thickness_m.powi(3) / 12.0;
            matches!(sheet.compression, Compression::TensionField { .. })
                || bending < 1e-3 * force_n * area.sqrt()
        });
        let stretching = films
            .map(|sheet| sheet.e_pa * sheet.thickness_m)
            .fold(0.0, f64::max);
        if area > 0.0 {
            TENSION_SHARE * (force_n * force_n / area * stretching / 24.0).cbrt()
        } else {
            0.0
        }
    }

    /// Factorizes the tangent at `state` under `loads` as it is; gives the number of negative pivots.
    ///
    /// # Errors
    /// If it is singular.
    pub fn factorize(&mut self, state: &State, loads: &Loads) -> Result<usize, StructureError> {
        self.at_rest = false;
        self.values.fill(0.0);
        self.model
            .tangent(&self.pattern, state, loads, None, &mut self.values);
        self.pattern.hold(&mut self.values, &self.held);
        if self.factor.positive(&self.pattern, &self.values) {
            return Ok(0);
        }
        self.factor.indefinite(&self.pattern, &self.values)
    }

    /// The same at rest without loads, as linear kinematics has it.
    ///
    /// # Errors
    /// If it is singular.
    pub fn factorize_at_rest(&mut self) -> Result<usize, StructureError> {
        let nodes = self.model.nodes.len();
        self.factorize(&State::at_rest(nodes), &Loads::none(nodes))
    }

    /// Linear answer to `loads`, small rotations about the rest; the tangent at rest is factorized once.
    ///
    /// # Errors
    /// If it is singular.
    pub fn solve_linear(&mut self, loads: &Loads) -> Result<State, StructureError> {
        let rest = State::at_rest(self.model.nodes.len());
        if !self.at_rest {
            self.factorize_at_rest()?;
            self.at_rest = true;
        }
        let mut step = self.model.residual(&self.pattern, &rest, loads);
        step.iter_mut().for_each(|r| *r = -*r);
        self.solve_tangent(&mut step, 1);
        Ok(self.moved(&rest, &step, 1.0))
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
        longest[a] = longest[a].max(side);
        longest[b] = longest[b].max(side);
    }
    longest
}
