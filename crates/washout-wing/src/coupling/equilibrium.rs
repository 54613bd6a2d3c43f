//! The equilibrium of structure and air.

use crate::input::design::{Accelerator, Coupling, Design, Factorization};
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, StructureError, Tangent};

use super::air::Air;
use super::error::CouplingError;
use super::fixed_point::Coupled;
use super::near::{Care, Near};
use super::overload::overload;
use super::solution::{Solution, SolveReport};
use super::wing::Wing;
use super::{cure, cure_near, fixed_point, newton, pseudo_time};

/// As [`super::solve_from`], of the wing of a design that is set up already. Besides, the structure's tangent at the solution,
/// factorized.
///
/// # Errors
/// As [`super::solve()`]; of a trial, if Newton's method does not settle on a stable shape.
pub fn solve_wing(
    design: &Design,
    wing: &Wing,
    mesh: &Mesh,
    near: Option<&Near>,
    progress: &Progress,
) -> Result<(Solution, Tangent), CouplingError> {
    let mut equilibrium = wing.equilibrium()?;
    if design.structure.factorization == Factorization::Parallel {
        equilibrium.spread();
    }
    let (rest, steps) = match near.filter(|near| near.care.is_trial()) {
        None => cure::cured(&wing.model, &mut equilibrium, progress)?,
        Some(near) => cure_near::cured_near(wing, &mut equilibrium, near, progress)?,
    };
    let mut coupled = couple(design, wing, &mut equilibrium, &rest, near, progress)?;
    coupled.newton_steps += steps;
    let solution = solution(wing, mesh, &equilibrium, rest, coupled)?;
    Ok((solution, equilibrium.into_tangent()))
}

/// What is read off a shape that was found.
///
/// # Errors
/// If a strip stands outside of the range of the air's law, or a number is not finite.
pub(super) fn solution(
    wing: &Wing,
    mesh: &Mesh,
    equilibrium: &Equilibrium,
    rest: State,
    coupled: Coupled,
) -> Result<Solution, CouplingError> {
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
        report: report(wing, equilibrium, &coupled),
        air_force_n: air_force.into_iter().map(Into::into).collect(),
        rest,
        state: coupled.state,
    };
    solution.refuse_not_finite()?;
    Ok(solution)
}

/// By Newton's method where the design asks for it, from nearby and from rest; where it does not settle on a stable shape, in
/// pseudo-time, and where that does not settle either, by the fixed point. A design that asks for the fixed point has it first.
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
    let is_joint =
        coupling.accelerator == Accelerator::Newton && !wing.linear && structure.load_increments == 1;
    let (mut lost, mut told) = (0, None);
    if is_joint {
        match jointly(coupling, wing, equilibrium, rest, near, progress)? {
            Ok(found) => return Ok(found),
            Err(missed) => (lost, told) = (missed.steps, missed.verdict),
        }
    }
    // the fixed point solves the whole structure in each of its steps: where the design does not ask for it, it comes last
    let ways = match is_joint {
        _ if wing.linear => vec![Way::FixedPoint],
        true => vec![Way::PseudoTime, Way::FixedPoint],
        false => vec![Way::FixedPoint, Way::PseudoTime],
    };
    for way in ways {
        let found = match way {
            // the slow path is not for a wing of which it is known why it does not come to rest
            Way::FixedPoint if told.is_some() => break,
            Way::FixedPoint => fixed_point::iterate(wing, equilibrium, rest, coupling, structure, progress),
            Way::PseudoTime => match pseudo_time::settle(wing, equilibrium, rest, coupling, progress)? {
                Ok(found) => fixed_point::stable(wing, equilibrium, rest, found, Care::Full),
                Err(steps) => {
                    lost += steps;
                    if told.as_ref().is_none_or(is_unsettled) {
                        let too_far = overload(wing, !design.spar.is_empty(), equilibrium, rest);
                        told = too_far.map(CouplingError::Overloaded).or(told);
                    }
                    continue;
                }
            },
        };
        match found {
            Ok(mut found) => {
                found.newton_steps += lost;
                return Ok(found);
            }
            Err(error) if !(is_unsettled(&error) || is_verdict(&error)) => return Err(error),
            // a verdict on what was found says more than that nothing was
            Err(error) if told.as_ref().is_none_or(is_unsettled) => told = Some(error),
            Err(_) => {}
        }
    }
    Err(told.expect("each way that finds nothing leaves a word, the fixed point at the least"))
}

/// What Newton's method has left where it did not settle on a stable shape.
struct Missed {
    steps: usize,
    /// Of a shape that it settled on and the wing would leave.
    verdict: Option<CouplingError>,
}

/// By Newton's method on air and structure together, from nearby and from rest.
///
/// # Errors
/// If the user asks to stop, or a trial does not settle.
fn jointly(
    coupling: &Coupling,
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    near: Option<&Near>,
    progress: &Progress,
) -> Result<Result<Coupled, Missed>, CouplingError> {
    let care = near.map_or(Care::Full, |near| near.care);
    let asked = care.tolerances(coupling);
    let mut missed = Missed {
        steps: 0,
        verdict: None,
    };
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
                missed.steps += found.newton_steps;
                found.newton_steps = missed.steps;
                match fixed_point::stable(wing, equilibrium, rest, found, care) {
                    Ok(found) if found.negative_pivots == 0 => return Ok(Ok(found)),
                    Err(error) if is_verdict(&error) => missed.verdict = Some(error),
                    _ => {}
                }
            }
            Err(steps) => missed.steps += steps,
        }
    }
    if care.is_trial() {
        return Err(CouplingError::GivenUp { steps: missed.steps });
    }
    Ok(Err(missed))
}

/// A way to the equilibrium where Newton's method does not lead there.
enum Way {
    FixedPoint,
    PseudoTime,
}

/// Whether an equilibrium was found that the wing would leave.
fn is_verdict(error: &CouplingError) -> bool {
    matches!(
        error,
        CouplingError::Diverged { .. } | CouplingError::Unstable { .. }
    )
}

/// Whether nothing was found, as opposed to a verdict on what was.
fn is_unsettled(error: &CouplingError) -> bool {
    matches!(
        error,
        CouplingError::OutOfPatience { .. } | CouplingError::Structure(StructureError::NoEquilibrium { .. })
    )
}

/// Residuals of what has converged that are larger are rounding: there is next to no load to set them beside.
const UNLOADED: f64 = 1e-3;

fn report(wing: &Wing, equilibrium: &Equilibrium, coupled: &Coupled) -> SolveReport {
    let (force, moment) = wing.reaction(equilibrium, &coupled.state, &coupled.loads);
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
