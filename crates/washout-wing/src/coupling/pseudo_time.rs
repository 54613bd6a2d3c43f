//! Air and structure in pseudo-time: a damped motion of the wing under its air, from rest to where it stands still.
//!
//! Where Newton's method does not settle: loose films swing through many shapes, and a whole step leaps from one to
//! another. Here every step (K + D/τ − A S) d = −F is short enough that no node turns far, so that the wing moves as one that is held
//! back would ([`super::pace`]). Toward rest the steps grow to those of Newton's method. The residual, which alone tells equilibrium, has no damping.

use super::error::CouplingError;
use super::feedback::Feedback;
use super::fixed_point::{Coupled, twists};
use super::pace::Pace;
use super::recycled::Recycled;
use super::wing::Wing;
use crate::input::design::Coupling;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Mixed, larger};

/// Steps after which it is given up, for each step that the design allows the fixed point: one of those solves the whole structure.
const PATIENCE: usize = 7;
/// A wing that leaves less than this of its load creeps to rest: it is granted as many steps again.
const NEARLY: f64 = 1e-3;
/// Steps since it was so near last, after which it is not granted any more: triangles that switch make the residual jump in between.
const LAST: usize = 60;
/// Residual of the linear solve over that of the step.
const TOLERANCE: f64 = 1e-4;

/// Moves on from the shape `rest`; the inner error is the number of steps that did not come to rest.
///
/// # Errors
/// If the user asks to stop.
pub fn settle(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    coupling: &Coupling,
    progress: &Progress,
) -> Result<Result<Coupled, usize>, CouplingError> {
    let rest_twist = twists(&wing.strips.shapes(rest));
    let mut coupled = Coupled::at(rest.clone(), Loads::none(wing.model.nodes.len()));
    let mut way = Mixed::new();
    let mut known = Recycled::new();
    let mut shapes = wing.strips.shapes(rest);
    let mut pace: Option<Pace> = None;
    let patience = PATIENCE * coupling.max_iterations;
    let mut last_near = 0;
    while coupled.newton_steps < patience
        || (coupled.newton_steps < 2 * patience && coupled.newton_steps < last_near + LAST)
    {
        progress.check()?;
        let Ok(loads) = wing.loads(&shapes) else { break };
        let distance = equilibrium.assemble_mixed(&coupled.state, &loads, &way);
        coupled.residual = distance.relative;
        if coupled.residual < NEARLY {
            last_near = coupled.newton_steps;
        }
        let scale = equilibrium.scale(&coupled.state, &loads);
        let pace = pace.get_or_insert_with(|| Pace::new(equilibrium, scale.0));
        let (turn, rate) = pace.turn_and_rate();
        progress.say(format_args!(
            "pseudo-time {}: turn {turn:.1e}, rate {rate:.1e} N/m, twist changes by {:.1e} deg, residual {:.1e}",
            coupled.newton_steps, coupled.twist_change_deg, coupled.residual
        ));
        let allowed = larger(coupling.residual_tolerance, 2.0 * distance.rounding);
        if coupled.residual <= allowed && coupled.twist_change_deg <= coupling.twist_tolerance_deg {
            coupled.loads = loads;
            return Ok(Ok(coupled));
        }
        if !coupled.residual.is_finite() {
            break;
        }
        if !pace.factorize(equilibrium, &distance, scale) {
            break;
        }
        known.change();
        let found = match Feedback::new(wing, equilibrium, &shapes) {
            Ok(mut feedback) => feedback.solve(&distance.right, TOLERANCE, &mut known),
            Err(_) => None,
        };
        let Some(mut step) = found else { break };
        let state = pace.step(
            equilibrium,
            &coupled.state,
            &distance,
            scale,
            (&mut step, &mut way),
        );
        shapes = coupled.step_to(wing, state, &shapes, &rest_twist);
    }
    Ok(Err(coupled.newton_steps))
}
