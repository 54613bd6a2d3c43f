//! How the loaded shape answers to a parameter: one linear solve with the coupled tangent for each.
//!
//! F(u, ψ) = 0 gives (K − A S) du/dψ = −∂F/∂ψ (see [`super::feedback`]); ∂F/∂ψ at fixed displacements by differences of
//! the design, its mesh included. Where a parameter moves the mesh, each node is carried along as its rotation has it, so
//! that the differences do not strain the film; the carry is part of du/dψ. The tangent is factorized once for all
//! parameters. What the stroke does at the phase of the design stays as it is, for effects that are made from it.

use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::Vector3;

use crate::effects::Seam;
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Tangent};

use super::beside::{Beside, Home, Remesh};
use super::error::SensitivityError;
use super::feedback::{EXACT, Feedback};
use super::recycled::Recycled;
use super::solution::Solution;
use super::strip_air::StripAir;
use super::wing::Wing;

/// Step of a parameter over its value, or over its assumed range where that is larger.
const STEP: f64 = 1e-5;

/// A solved wing whose coupled tangent is factorized.
pub struct Sensitivity<'a> {
    home: Home<'a>,
    equilibrium: Equilibrium<'a>,
    /// Air on each strip, with derivatives.
    air: Vec<StripAir>,
    /// What the parameters before have told of the air's feedback.
    known: Recycled,
    /// The tangent of the shape without load; made when a parameter first moves that shape.
    rest: Option<Equilibrium<'a>>,
    /// Wings of the last parameter's stencil, which reading takes up again.
    last: Option<Around>,
}

/// The wings of a parameter's stencil.
struct Around {
    key: String,
    /// Offset from the solved value, in the unit of the key; weight; wing.
    points: Vec<(f64, f64, Beside)>,
}

impl std::fmt::Debug for Sensitivity<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Sensitivity")
            .field("wing", &self.home.design.name)
            .finish_non_exhaustive()
    }
}

/// Change of a solution with a parameter, per unit of its key.
#[derive(Debug, Clone, PartialEq)]
pub struct Rate {
    /// Dotted key of the parameter.
    pub key: String,
    /// Value at which the rate holds, in the unit of the key.
    pub value: f64,
    /// Step of the differences, in the unit of the key.
    pub step: f64,
    /// Change of the loaded shape by freedom of the pattern: m and rad per unit of the key.
    pub state: Vec<f64>,
    /// Change of the shape without load, likewise; empty if it does not change.
    pub rest: Vec<f64>,
    /// Whether the mesh moves too, and carries the shape along.
    pub moves_mesh: bool,
    stencil: Stencil,
}

/// A design beside the solved one, with the solution that the rate predicts.
#[derive(Debug, Clone)]
pub struct Nearby {
    /// The design.
    pub design: Design,
    /// Its outline.
    pub planform: Planform,
    /// Shape and air to first order; the report is that of the solved wing. Pressure and forces inside the elements are left
    /// out.
    pub solution: Solution,
}

/// Steps and weights of a first difference of second order.
type Stencil = &'static [(f64, f64)];
const CENTRAL: Stencil = &[(-1.0, -0.5), (1.0, 0.5)];
const FORWARD: Stencil = &[(0.0, -1.5), (1.0, 2.0), (2.0, -0.5)];
const BACKWARD: Stencil = &[(0.0, 1.5), (-1.0, -2.0), (-2.0, 0.5)];

impl<'a> Sensitivity<'a> {
    /// Factorizes at a solution; `wing` is that of `design` on the solution's mesh.
    ///
    /// # Errors
    /// If the tangent is singular, or the air's force does not change with the shape by finite numbers.
    pub fn new(
        design: &'a Design,
        wing: &'a Wing,
        air_table: Option<&'a [[f64; 3]]>,
        solution: &'a Solution,
        remesh: Remesh<'a>,
    ) -> Result<Self, SensitivityError> {
        let mut equilibrium = wing.equilibrium()?;
        if wing.linear {
            equilibrium.factorize(&solution.rest, &wing.bench.growing())?;
        } else {
            equilibrium.factorize(&solution.state, &wing.loads_on(&solution.state)?)?;
        }
        let tangent = equilibrium.into_tangent();
        Sensitivity::with_tangent(design, wing, air_table, solution, remesh, tangent)
    }

    /// With the tangent that the solve of this wing has left.
    ///
    /// # Errors
    /// If the air's force does not change with the shape by finite numbers.
    pub fn with_tangent(
        design: &'a Design,
        wing: &'a Wing,
        air_table: Option<&'a [[f64; 3]]>,
        solution: &'a Solution,
        remesh: Remesh<'a>,
        tangent: Tangent,
    ) -> Result<Self, SensitivityError> {
        Ok(Sensitivity {
            air: wing.strip_air(&wing.strips.shapes(&solution.state), true)?,
            home: Home::new(design, wing, air_table, solution, remesh),
            equilibrium: Equilibrium::of_tangent(&wing.model, tangent),
            known: Recycled::new(),
            rest: None,
            last: None,
        })
    }

    /// The same for a design whose solution is the same, as one that differs in the numbers of an effect that is off.
    pub fn of_design(&mut self, design: &'a Design) {
        self.home.design = design;
        self.last = None;
    }

    /// What the rates so far have told of the air's feedback: those that follow depend on it in their last digits.
    pub fn known(&mut self) -> &mut Recycled {
        &mut self.known
    }

    /// Change of the solution with the number at a dotted key of the design.
    ///
    /// # Errors
    /// If there is no such number, the mesh changes its pattern with it, or the coupled tangent is singular.
    pub fn rate(&mut self, key: &str) -> Result<Rate, SensitivityError> {
        let (value, step, stencil, around) = self.stencil(key)?;
        let Home {
            wing: here, solution, ..
        } = self.home;
        let nodes = here.model.nodes.len();
        let zeros = || vec![0.0; 6 * nodes];
        // right-hand side and carry, loaded and at rest
        let mut sums = [[zeros(), zeros()], [zeros(), zeros()]];
        let part = Part::of(here, &around);
        for (_, weight, beside) in &around.points {
            let wing = &beside.wing;
            let states = [&solution.state, &solution.rest];
            for ([right, carried], (state, is_loaded)) in
                sums.iter_mut().zip(states.into_iter().zip([true, false]))
            {
                if !is_loaded && part.is_of_loads() {
                    continue;
                }
                let (moved, carry) = match &beside.moved {
                    Some((_, mesh)) => self.carried(state, mesh),
                    None => (Cow::Borrowed(state), Vec::new()),
                };
                let loads = if is_loaded {
                    wing.loads_on(&moved)?
                } else {
                    Loads::none(nodes)
                };
                let share = weight / step;
                for (sum, r) in right.iter_mut().zip(self.residual(wing, part, &moved, &loads)) {
                    *sum -= share * r;
                }
                for (sum, c) in carried.iter_mut().zip(carry) {
                    *sum += share * c;
                }
            }
        }
        let moves_mesh = around.points.iter().any(|(_, _, beside)| beside.moved.is_some());
        self.last = Some(around);
        let [[loaded, carried], rest] = sums;
        let mut state = Feedback::with_air(here, &mut self.equilibrium, &self.air)
            .solve(&loaded, EXACT, &mut self.known)
            .ok_or(SensitivityError::Singular)?;
        state.iter_mut().zip(carried).for_each(|(x, carry)| *x += carry);
        Ok(Rate {
            key: key.to_string(),
            value,
            step,
            state,
            rest: self.rest_rate(rest)?,
            moves_mesh,
            stencil,
        })
    }

    /// Change of the solution with a share of nodal forces (N) that are added to the loads.
    ///
    /// # Errors
    /// If the coupled tangent is singular.
    pub fn load_rate(&mut self, force_n: &[Vector3<f64>]) -> Result<Rate, SensitivityError> {
        let mut right = vec![0.0; self.equilibrium.pattern.len()];
        for (node, force) in force_n.iter().enumerate() {
            let at = self.equilibrium.pattern.freedom(node, 0);
            right[at..at + 3].copy_from_slice(force.as_slice());
        }
        let state = Feedback::with_air(self.home.wing, &mut self.equilibrium, &self.air)
            .solve(&right, EXACT, &mut self.known)
            .ok_or(SensitivityError::Singular)?;
        Ok(Rate {
            key: String::new(),
            value: 0.0,
            step: 1.0,
            state,
            rest: Vec::new(),
            moves_mesh: false,
            stencil: CENTRAL,
        })
    }

    /// Rates of anything that can be read from a design and its solution, per unit of the parameter's key.
    ///
    /// # Errors
    /// As [`Sensitivity::rate`].
    pub fn read(
        &self,
        rate: &Rate,
        reading: impl Fn(&Nearby) -> Vec<f64>,
    ) -> Result<Vec<f64>, SensitivityError> {
        let mut rates = Vec::new();
        for &(at, weight) in rate.stencil {
            let values = reading(&self.nearby(rate, at * rate.step)?);
            rates.resize(values.len(), 0.0);
            for (sum, value) in rates.iter_mut().zip(values) {
                *sum += weight / rate.step * value;
            }
        }
        Ok(rates)
    }

    /// What the rate predicts where the parameter differs by `offset`, in the unit of its key.
    ///
    /// # Errors
    /// If the design refuses the value, or its mesh has another pattern.
    pub fn nearby(&self, rate: &Rate, offset: f64) -> Result<Nearby, SensitivityError> {
        // the rate of a load has no key
        if rate.key.is_empty() {
            return self.predicted(rate, offset, self.home.design, self.home.wing, None);
        }
        let of_key = self.last.as_ref().filter(|last| last.key == rate.key);
        let known = of_key.and_then(|last| last.points.iter().find(|(at, _, _)| *at == offset));
        let fresh;
        let beside = match known {
            Some((_, _, beside)) => beside,
            None => {
                fresh = self.home.beside(&rate.key, rate.value + offset)?;
                &fresh
            }
        };
        self.predicted(rate, offset, &beside.design, &beside.wing, beside.moved.as_ref())
    }

    fn predicted(
        &self,
        rate: &Rate,
        offset: f64,
        design: &Design,
        wing: &Wing,
        moved: Option<&(Planform, Mesh)>,
    ) -> Result<Nearby, SensitivityError> {
        let solution = self.home.solution;
        let (planform, mesh) = match moved {
            Some((planform, mesh)) => (planform, mesh),
            None => (self.home.planform()?, &solution.mesh),
        };
        let moved = |state: &State, change: &[f64]| match change {
            [] => state.clone(),
            _ => self.equilibrium.moved(state, change, offset),
        };
        let state = moved(&solution.state, &rate.state);
        let rest = moved(&solution.rest, &rate.rest);
        let air = wing.strip_air(&wing.strips.shapes(&state), false)?;
        let solution = Solution {
            strips: wing.strip_loads(&air),
            air_force_n: wing.air_force(&air).into_iter().map(Into::into).collect(),
            pressure_pa: Vec::new(),
            beam_force: Vec::new(),
            membrane_force_n_per_m: Vec::new(),
            rest,
            report: solution.report.clone(),
            state,
            mesh: mesh.clone(),
        };
        Ok(Nearby {
            design: design.clone(),
            planform: planform.clone(),
            solution,
        })
    }

    /// A state whose nodes move with those of another mesh, as their rotations turn them; the motion by freedom.
    fn carried<'s>(&self, state: &'s State, mesh: &Mesh) -> (Cow<'s, State>, Vec<f64>) {
        let pattern = &self.equilibrium.pattern;
        if self.home.wing.linear {
            return (Cow::Borrowed(state), Vec::new());
        }
        let (mut carried, mut motion) = (state.clone(), vec![0.0; pattern.len()]);
        for (node, (to, from)) in mesh.nodes.iter().zip(&self.home.solution.mesh.nodes).enumerate() {
            let step = Vector3::from(*to) - Vector3::from(*from);
            let carry = state.rotation[node] * step - step;
            carried.displacement[node] += carry;
            let at = pattern.freedom(node, 0);
            motion[at..at + 3].copy_from_slice(carry.as_slice());
        }
        (Cow::Owned(carried), motion)
    }

    /// Change of the shape without load from its right-hand side and carry; nothing if both vanish.
    fn rest_rate(&mut self, [mut right, carried]: [Vec<f64>; 2]) -> Result<Vec<f64>, SensitivityError> {
        if right.iter().chain(&carried).all(|r| *r == 0.0) {
            return Ok(Vec::new());
        }
        if self.rest.is_none() {
            let mut equilibrium = self.home.wing.equilibrium()?;
            equilibrium.factorize(
                &self.home.solution.rest,
                &Loads::none(self.home.wing.model.nodes.len()),
            )?;
            self.rest = Some(equilibrium);
        }
        if let Some(rest) = &mut self.rest {
            rest.solve_tangent(&mut right, 1);
        }
        right.iter_mut().zip(carried).for_each(|(x, carry)| *x += carry);
        Ok(right)
    }

    /// Internal forces less loads as far as the parameter changes them, in the kinematics of the wing; linear kinematics about
    /// the shape without load, whose own change moves the linear stiffness only in the second order, which is left out.
    fn residual(&self, wing: &Wing, part: Part, state: &State, loads: &Loads) -> Vec<f64> {
        let pattern = &self.equilibrium.pattern;
        match part {
            Part::Loads => {
                let mut residual = vec![0.0; pattern.len()];
                loads.subtract(pattern, state, &mut residual);
                return residual;
            }
            Part::BeamsAndLoads => return wing.model.residual_without_shells(pattern, state, loads),
            Part::All if !wing.linear => return wing.model.residual(pattern, state, loads),
            Part::All => {}
        }
        let rest = &self.home.solution.rest;
        let mut values = vec![0.0; pattern.entries()];
        let growing = loads.growing();
        wing.model.tangent(pattern, rest, &growing, None, &mut values);
        let start = wing.model.residual(pattern, rest, loads);
        let mut moved = vec![0.0; pattern.len()];
        for (node, (u, q)) in state.displacement.iter().zip(&state.rotation).enumerate() {
            let at = pattern.freedom(node, 0);
            let turned = q * rest.rotation[node].inverse();
            moved[at..at + 3].copy_from_slice((u - rest.displacement[node]).as_slice());
            moved[at + 3..at + 6].copy_from_slice(turned.scaled_axis().as_slice());
        }
        let mut residual = pattern.multiply(&values, &moved);
        residual.iter_mut().zip(start).for_each(|(r, s)| *r += s);
        residual
    }

    /// Value, step and a stencil that the design accepts, with its wings.
    fn stencil(&self, key: &str) -> Result<(f64, f64, Stencil, Around), SensitivityError> {
        let unknown = || SensitivityError::NoNumber { key: key.to_string() };
        let value = self.home.design.get(key).ok_or_else(unknown)?;
        let step = STEP * self.size(key, value);
        for stencil in [CENTRAL, FORWARD, BACKWARD] {
            let points = stencil.iter().map(|&(at, weight)| {
                let beside = self.home.beside(key, value + at * step)?;
                Ok((at * step, weight, beside))
            });
            if let Ok(points) = points.collect::<Result<Vec<_>, SensitivityError>>() {
                let key = key.to_string();
                return Ok((value, step, stencil, Around { key, points }));
            }
        }
        // say why
        Err(self.home.beside(key, value + step).err().unwrap_or_else(unknown))
    }

    /// Size of a number, or of its assumed range where that is larger; 1 for zero.
    fn size(&self, key: &str, value: f64) -> f64 {
        // the strength of an effect is stated as it is
        let width = if key.starts_with("effects.") && key.ends_with(".strength") {
            0.0
        } else {
            let assumptions = self.home.design.assumptions();
            let range = assumptions.iter().find(|assumption| assumption.key == key);
            range.map_or(0.0, |assumption| assumption.range[1] - assumption.range[0])
        };
        let size = value.abs().max(width);
        if size > 0.0 { size } else { 1.0 }
    }
}

/// What of the residual a parameter can change; the rest cancels in its differences.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    /// Loads on the same structure.
    Loads,
    /// Beams, springs and loads; the same films.
    BeamsAndLoads,
    /// Anything.
    All,
}

impl Part {
    fn of(here: &Wing, around: &Around) -> Part {
        let wings = || around.points.iter().map(|(_, _, beside)| &beside.wing);
        let is_plain = |wing: &Wing| !wing.linear && wing.model.blend.is_none();
        let stays = around.points.iter().all(|(_, _, beside)| beside.moved.is_none());
        if !stays || !is_plain(here) || !wings().all(is_plain) {
            return Part::All;
        }
        let is_of_loads =
            |(_, _, beside): &(f64, f64, Beside)| matches!(beside.seam, Some(Seam::Air | Seam::Picture));
        if around.points.iter().all(is_of_loads) {
            Part::Loads
        } else if wings().all(|wing| Arc::ptr_eq(&wing.model.shells, &here.model.shells)) {
            Part::BeamsAndLoads
        } else {
            Part::All
        }
    }

    fn is_of_loads(self) -> bool {
        self == Part::Loads
    }
}
