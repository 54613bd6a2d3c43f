//! How the loaded shape answers to a parameter: one linear solve with the coupled tangent for each.
//!
//! F(u, ψ) = 0 gives (K − A S) du/dψ = −∂F/∂ψ (see [`super::feedback`]); ∂F/∂ψ at fixed displacements by differences of
//! the design, its mesh included. Where a parameter moves the mesh, each node is carried along as its rotation has it, so
//! that the differences do not strain the film; the carry is part of du/dψ. The tangent is factorized once for all
//! parameters. What the stroke does at the phase of the design stays as it is, for effects that are made from it.

use nalgebra::Vector3;

use crate::effects::bind;
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh::{Mesh, MeshError};
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads};

use super::error::{CouplingError, SensitivityError};
use super::feedback::Feedback;
use super::solution::Solution;
use super::wing::Wing;

/// Step of a parameter over its value, or over its assumed range where that is larger.
const STEP: f64 = 1e-5;

/// Outline and mesh of a design, as the solved wing got its own.
pub type Remesh<'a> = &'a dyn Fn(&Design) -> Result<(Planform, Mesh), MeshError>;

/// A solved wing whose coupled tangent is factorized.
pub struct Sensitivity<'a> {
    design: &'a Design,
    wing: &'a Wing,
    air_table: Option<&'a [[f64; 3]]>,
    solution: &'a Solution,
    remesh: Remesh<'a>,
    equilibrium: Equilibrium<'a>,
    /// The tangent of the shape without load; made when a parameter first moves that shape.
    rest: Option<Equilibrium<'a>>,
}

impl std::fmt::Debug for Sensitivity<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Sensitivity")
            .field("wing", &self.design.name)
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
    stencil: Stencil,
}

/// A design beside the solved one, with the solution that the rate predicts.
#[derive(Debug, Clone)]
pub struct Nearby {
    /// The design.
    pub design: Design,
    /// Its outline.
    pub planform: Planform,
    /// Shape and air to first order; the report is that of the solved wing.
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
    /// If the tangent is singular.
    pub fn new(
        design: &'a Design,
        wing: &'a Wing,
        air_table: Option<&'a [[f64; 3]]>,
        solution: &'a Solution,
        remesh: Remesh<'a>,
    ) -> Result<Self, SensitivityError> {
        let mut equilibrium = Equilibrium::new(&wing.model)?;
        if wing.linear {
            equilibrium.factorize(&solution.rest, &wing.bench.growing())?;
        } else {
            equilibrium.factorize(&solution.state, &wing.loads_on(&solution.state))?;
        }
        Ok(Sensitivity {
            design,
            wing,
            air_table,
            solution,
            remesh,
            equilibrium,
            rest: None,
        })
    }

    /// Change of the solution with the number at a dotted key of the design.
    ///
    /// # Errors
    /// If there is no such number, the mesh changes its pattern with it, or the coupled tangent is singular.
    pub fn rate(&mut self, key: &str) -> Result<Rate, SensitivityError> {
        let (value, step, stencil) = self.stencil(key)?;
        let nodes = self.wing.model.nodes.len();
        let zeros = || vec![0.0; 6 * nodes];
        // right-hand side and carry, loaded and at rest
        let mut sums = [[zeros(), zeros()], [zeros(), zeros()]];
        for &(at, weight) in stencil {
            let (design, _, mesh) = self.design_at(key, value + at * step)?;
            let wing = Wing::with_motion(&design, &mesh, self.air_table, self.wing.motion.clone())?;
            let states = [&self.solution.state, &self.solution.rest];
            for ([right, carried], (state, is_loaded)) in
                sums.iter_mut().zip(states.into_iter().zip([true, false]))
            {
                let (state, carry) = self.carried(state, &mesh);
                let loads = if is_loaded {
                    wing.loads_on(&state)
                } else {
                    Loads::none(nodes)
                };
                let share = weight / step;
                for (sum, r) in right.iter_mut().zip(self.residual(&wing, &state, &loads)) {
                    *sum -= share * r;
                }
                for (sum, c) in carried.iter_mut().zip(carry) {
                    *sum += share * c;
                }
            }
        }
        let [[loaded, carried], rest] = sums;
        let shapes = self.wing.strips.shapes(&self.solution.state);
        let mut state = Feedback::new(self.wing, &mut self.equilibrium, &shapes)
            .solve(&loaded)
            .ok_or(SensitivityError::Singular)?;
        state.iter_mut().zip(carried).for_each(|(x, carry)| *x += carry);
        Ok(Rate {
            key: key.to_string(),
            value,
            step,
            state,
            rest: self.rest_rate(rest)?,
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
        let shapes = self.wing.strips.shapes(&self.solution.state);
        let state = Feedback::new(self.wing, &mut self.equilibrium, &shapes)
            .solve(&right)
            .ok_or(SensitivityError::Singular)?;
        Ok(Rate {
            key: String::new(),
            value: 0.0,
            step: 1.0,
            state,
            rest: Vec::new(),
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
        let (design, planform, mesh) = self.design_at(&rate.key, rate.value + offset)?;
        let wing = Wing::with_motion(&design, &mesh, self.air_table, self.wing.motion.clone())?;
        let moved = |state: &State, change: &[f64]| match change {
            [] => state.clone(),
            _ => self.equilibrium.moved(state, change, offset),
        };
        let state = moved(&self.solution.state, &rate.state);
        let rest = moved(&self.solution.rest, &rate.rest);
        let air = wing.strip_air(&wing.strips.shapes(&state), false);
        let solution = Solution {
            strips: wing.strip_loads(&air),
            pressure_pa: wing.pressure(&mesh, &air),
            beam_force: wing.beam_forces(&rest, &state),
            membrane_force_n_per_m: wing.membrane_forces(&rest, &state),
            air_force_n: wing.air_force(&air).into_iter().map(Into::into).collect(),
            rest,
            report: self.solution.report.clone(),
            state,
            mesh,
        };
        Ok(Nearby {
            design,
            planform,
            solution,
        })
    }

    /// A state whose nodes move with those of another mesh, as their rotations turn them; the motion by freedom.
    fn carried(&self, state: &State, mesh: &Mesh) -> (State, Vec<f64>) {
        let pattern = &self.equilibrium.pattern;
        let (mut carried, mut motion) = (state.clone(), vec![0.0; pattern.len()]);
        if self.wing.linear {
            return (carried, motion);
        }
        for (node, (to, from)) in mesh.nodes.iter().zip(&self.solution.mesh.nodes).enumerate() {
            let step = Vector3::from(*to) - Vector3::from(*from);
            let carry = state.rotation[node] * step - step;
            carried.displacement[node] += carry;
            let at = pattern.freedom(node, 0);
            motion[at..at + 3].copy_from_slice(carry.as_slice());
        }
        (carried, motion)
    }

    /// Change of the shape without load from its right-hand side and carry; nothing if both vanish.
    fn rest_rate(&mut self, [mut right, carried]: [Vec<f64>; 2]) -> Result<Vec<f64>, SensitivityError> {
        if right.iter().chain(&carried).all(|r| *r == 0.0) {
            return Ok(Vec::new());
        }
        if self.rest.is_none() {
            let mut equilibrium = Equilibrium::new(&self.wing.model)?;
            equilibrium.factorize(&self.solution.rest, &Loads::none(self.wing.model.nodes.len()))?;
            self.rest = Some(equilibrium);
        }
        if let Some(rest) = &mut self.rest {
            rest.solve_tangent(&mut right, 1);
        }
        right.iter_mut().zip(carried).for_each(|(x, carry)| *x += carry);
        Ok(right)
    }

    /// Internal forces less loads, in the kinematics of the wing; linear kinematics about the shape without load, whose own
    /// change moves the linear stiffness only in the second order, which is left out.
    fn residual(&self, wing: &Wing, state: &State, loads: &Loads) -> Vec<f64> {
        let pattern = &self.equilibrium.pattern;
        if !wing.linear {
            return wing.model.residual(pattern, state, loads);
        }
        let rest = &self.solution.rest;
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

    /// Value, step and a stencil that the design accepts.
    fn stencil(&self, key: &str) -> Result<(f64, f64, Stencil), SensitivityError> {
        let unknown = || SensitivityError::NoNumber { key: key.to_string() };
        let value = self.design.get(key).ok_or_else(unknown)?;
        let assumptions = self.design.assumptions();
        let range = assumptions.iter().find(|assumption| assumption.key == key);
        let width = range.map_or(0.0, |assumption| assumption.range[1] - assumption.range[0]);
        let size = value.abs().max(width);
        let step = STEP * if size > 0.0 { size } else { 1.0 };
        let accepts = |stencil: Stencil| {
            let refused = |&(at, _): &(f64, f64)| self.design_at(key, value + at * step).is_err();
            !stencil.iter().any(refused)
        };
        let stencils = [CENTRAL, FORWARD, BACKWARD].into_iter();
        let stencil = stencils.clone().find(|stencil| accepts(stencil));
        match stencil {
            Some(stencil) => Ok((value, step, stencil)),
            // say why
            None => Err(self.design_at(key, value + step).err().unwrap_or_else(unknown)),
        }
    }

    /// The design with another value, meshed with the pattern of the solved wing.
    fn design_at(&self, key: &str, value: f64) -> Result<(Design, Planform, Mesh), SensitivityError> {
        let mut design = self.design.clone();
        // the rate of a load has no key
        if !key.is_empty() {
            design.set(key, value)?;
            bind(&design).map_err(CouplingError::from)?;
        }
        let (planform, mesh) = (self.remesh)(&design)?;
        let solved = &self.solution.mesh;
        let alike = mesh.nodes.len() == solved.nodes.len()
            && mesh.triangles == solved.triangles
            && mesh.beams == solved.beams;
        if !alike {
            return Err(SensitivityError::OtherPattern { key: key.to_string() });
        }
        Ok((design, planform, mesh))
    }
}
