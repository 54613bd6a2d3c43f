//! Air and structure together: load and shape transfer, residual, Newton's method, fixed point, sensitivity.

pub mod accelerate;

pub mod air;

pub mod air_resistance;

mod beside;

pub mod blade;

pub mod build;

pub mod cure;

pub mod engineering;

pub mod error;

pub mod feedback;

mod finite;

pub mod fixed_point;

pub mod newton;

pub mod harmonic_balance;

pub mod instant;

pub mod motion;

pub mod periodic;

pub mod recycled;

pub mod sensitivity;

pub mod solution;

mod strip_path;

pub mod strips;

pub mod stroke;

pub mod vibration;

pub mod wing;

pub use blade::{BladeAir, BladeSection};
pub use engineering::{Engineering, Extreme};
pub use error::{CouplingError, SensitivityError};
pub use periodic::{Periodic, PeriodicSettings, periodic};
pub use sensitivity::Sensitivity;

use crate::geometry::Planform;
use crate::input::design::{Accelerator, Coupling, Design, Factorization};
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Tangent, larger};

use air::Air;
use fixed_point::Coupled;
use solution::{Solution, SolveReport};
use wing::Wing;

/// The loaded shape of a wing in its air.
///
/// `air_table`: rows alpha_deg, cl, cd for `air.coefficients = "table"`.
///
/// # Errors
/// If design and mesh do not belong together, the wing has no equilibrium that is found, or a load or a result is not finite.
pub fn solve(
    design: &Design,
    planform: &Planform,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    progress: &Progress,
) -> Result<Solution, CouplingError> {
    solve_from(design, planform, mesh, air_table, None, progress)
}

/// As [`solve`], from the solution of a design nearby on a mesh with the same pattern: the same shape in fewer steps. Without
/// one, or with one on another pattern, it starts from the shape without load.
///
/// # Errors
/// As [`solve`].
pub fn solve_from(
    design: &Design,
    _planform: &Planform,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    nearby: Option<&Solution>,
    progress: &Progress,
) -> Result<Solution, CouplingError> {
    progress.check()?;
    let wing = Wing::new(design, mesh, air_table)?;
    let near = nearby.map(|solution| Near {
        solution,
        step: None,
        care: Care::Full,
    });
    Ok(solve_wing(design, &wing, mesh, near.as_ref(), progress)?.0)
}

/// Where a solve starts.
#[derive(Debug)]
pub struct Near<'a> {
    /// A solution of a design nearby.
    pub solution: &'a Solution,
    /// Step by freedom from there to where the shape is expected, to first order.
    pub step: Option<Vec<f64>>,
    /// How much is asked of it.
    pub care: Care,
}

/// How much is asked of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Care {
    /// A shape to the tolerances of the design; where Newton's method does not settle, the slow fixed point is asked.
    #[default]
    Full,
    /// A trial that can be given up: the same by Newton's method alone.
    Trial,
    /// A trial whose shape is good to 0.015° of twist and 5 % of the load; a study leaves held-out cases as they are.
    Rough,
}

/// Largest change of twist in the last step of a rough solve, deg: a tenth of what a camera tells apart.
const ROUGH_DEG: f64 = 0.015;
/// Coupled residual of a rough solve, relative to the air load.
const ROUGH_RESIDUAL: f64 = 0.05;
/// Steps after which a rough solve is given up: one that settles takes five to ten.
const ROUGH_ITERATIONS: usize = 30;

impl Care {
    /// Whether it can be given up.
    pub fn is_trial(self) -> bool {
        self != Care::Full
    }

    /// Tolerances to which it is solved.
    fn tolerances(self, coupling: &Coupling) -> Coupling {
        let mut asked = coupling.clone();
        if self == Care::Rough {
            asked.twist_tolerance_deg = larger(asked.twist_tolerance_deg, ROUGH_DEG);
            asked.residual_tolerance = larger(asked.residual_tolerance, ROUGH_RESIDUAL);
            asked.max_iterations = asked.max_iterations.min(ROUGH_ITERATIONS);
        }
        asked
    }
}

/// As [`solve_from`], of the wing of a design that is set up already. Besides, the structure's tangent at the solution,
/// factorized.
///
/// # Errors
/// As [`solve`]; of a trial, if Newton's method does not settle on a stable shape.
pub fn solve_wing(
    design: &Design,
    wing: &Wing,
    mesh: &Mesh,
    near: Option<&Near>,
    progress: &Progress,
) -> Result<(Solution, Tangent), CouplingError> {
    let mut equilibrium = Equilibrium::new(&wing.model)?;
    if design.structure.factorization == Factorization::Parallel {
        equilibrium.spread();
    }
    let (rest, steps) = match near.filter(|near| near.care.is_trial()) {
        None => cure::cured(&wing.model, &mut equilibrium, progress)?,
        Some(near) => cure::cured_near(wing, &mut equilibrium, near, progress)?,
    };
    let mut coupled = couple(design, wing, &mut equilibrium, &rest, near, progress)?;
    coupled.newton_steps += steps;
    let air = wing.strip_air(&wing.strips.shapes(&coupled.state), false)?;
    if let Some(Air { law, .. }) = &wing.air {
        for strip in &air {
            law.check(strip.force.alpha)?;
        }
    }
    let air_force = wing.air_force(&air);
    let solution = Solution {
        mesh: mesh.clone(),
        strips: wing.strip_loads(&air),
        pressure_pa: wing.pressure(mesh, &air),
        beam_force: wing.beam_forces(&rest, &coupled.state),
        membrane_force_n_per_m: wing.membrane_forces(&rest, &coupled.state),
        report: report(wing, &equilibrium, &coupled),
        air_force_n: air_force.into_iter().map(Into::into).collect(),
        rest,
        state: coupled.state,
    };
    solution.refuse_not_finite()?;
    Ok((solution, equilibrium.into_tangent()))
}

/// By Newton's method where the design asks for it, from nearby and from rest; else, and where it does not settle on a stable
/// shape, by the fixed point.
fn couple(
    design: &Design,
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    near: Option<&Near>,
    progress: &Progress,
) -> Result<Coupled, CouplingError> {
    let Design {
        coupling, structure, ..
    } = design;
    let asked = near.map_or(Care::Full, |near| near.care).tolerances(coupling);
    let mut lost = 0;
    if coupling.accelerator == Accelerator::Newton && !wing.linear && structure.load_increments == 1 {
        let nearby = near.and_then(|near| {
            let shape = newton::carried(wing, &near.solution.mesh, &near.solution.state)?;
            Some((shape, near.step.as_deref()))
        });
        let nearby = nearby.iter().map(|(shape, step)| (shape, true, *step));
        for (shape, is_loaded, step) in nearby.chain([(rest, false, None)]) {
            let start = newton::Start {
                rest,
                shape,
                is_loaded,
                step,
            };
            match newton::iterate(wing, equilibrium, start, &asked, progress)? {
                Ok(mut found) => {
                    lost += found.newton_steps;
                    found.newton_steps = lost;
                    match fixed_point::stable(wing, equilibrium, rest, found) {
                        Ok(found) if found.negative_pivots == 0 => return Ok(found),
                        _ => {}
                    }
                }
                Err(steps) => lost += steps,
            }
        }
        if near.is_some_and(|near| near.care.is_trial()) {
            return Err(CouplingError::GivenUp { steps: lost });
        }
    }
    let mut found = fixed_point::iterate(wing, equilibrium, rest, coupling, structure, progress)?;
    found.newton_steps += lost;
    Ok(found)
}

/// Residuals of what has converged that are larger are rounding: there is next to no load to set them beside.
const UNLOADED: f64 = 1e-3;

fn report(wing: &Wing, equilibrium: &Equilibrium, coupled: &Coupled) -> SolveReport {
    let (force, moment) = wing.reaction(equilibrium, coupled);
    SolveReport {
        residual: (coupled.residual < UNLOADED).then_some(coupled.residual),
        twist_change_deg: coupled.twist_change_deg,
        iterations: coupled.iterations,
        newton_steps: coupled.newton_steps,
        negative_pivots: coupled.negative_pivots,
        critical_pressure_ratio: coupled.critical_ratio,
        dof: wing.model.free_freedoms(),
        reaction_force_n: force.into(),
        reaction_moment_n_m: moment.into(),
        twist_history_deg: coupled.twist_history_deg.clone(),
    }
}
