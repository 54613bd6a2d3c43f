//! Air and structure in pseudo-time: a damped motion of the wing under its air, from rest to where it stands still.
//!
//! Where Newton's method does not settle: loose films swing through many shapes, and a whole step leaps from one to
//! another. Here every step (K + D/τ − A S) d = −F is short enough that no node turns far, so that the wing moves as one that is held
//! back would. Toward rest the steps grow to those of Newton's method. The residual, which alone tells equilibrium, has no damping.

use super::error::CouplingError;
use super::feedback::Feedback;
use super::fixed_point::{Coupled, twists};
use super::recycled::Recycled;
use super::wing::Wing;
use crate::input::design::Coupling;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Damper, Equilibrium, Loads, Mixed, larger};

/// Steps after which it is given up, for each step that the design allows the fixed point: one of those solves the whole structure.
const PATIENCE: usize = 7;
/// A wing that leaves less than this of its load creeps to rest: it is granted as many steps again.
const NEARLY: f64 = 1e-3;
/// Steps since it was so near last, after which it is not granted any more: triangles that switch make the residual jump in between.
const LAST: usize = 60;
/// Residual of the linear solve over that of the step.
const TOLERANCE: f64 = 1e-4;
/// Turn of a node in a step beyond which steps are made shorter, rad.
const LONG: f64 = 0.3;
/// The first rate over that at which the load would move the wing by its own length.
const FIRST: f64 = 30.0;
/// Factors of the rate: where steps are too long, where they are calm, and where they do not come to rest.
const HARDER: f64 = 3.0;
const SOFTER: f64 = 0.5;
const AGAIN: f64 = 300.0;
/// Where the rate has fallen by this and the turn neither fell nor grew with it, the wing does not come to rest: triangles switch to and fro.
const IDLE: f64 = 50.0;
/// The softening after that, steps being longer only slowly.
const SLOWLY: f64 = 0.85;

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
    let damper = Damper::new(equilibrium);
    let mut shapes = wing.strips.shapes(rest);
    let mut rate = 0.0;
    let mut turn = f64::INFINITY;
    // turn and rate since which the turn is alike
    let mut mark = (turn, rate);
    let mut softer = SOFTER;
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
        if coupled.newton_steps == 0 {
            rate = FIRST * equilibrium.scale(&coupled.state, &loads).0 / wing.model.extent_m();
        }
        let mut tries = 0;
        while !equilibrium.factorize_damped(&damper, rate) {
            tries += 1;
            if tries > 40 {
                return Ok(Err(coupled.newton_steps));
            }
            rate *= HARDER;
        }
        known.change();
        let found = match Feedback::new(wing, equilibrium, &shapes) {
            Ok(mut feedback) => feedback.solve(&distance.right, TOLERANCE, &mut known),
            Err(_) => None,
        };
        let Some(mut step) = found else { break };
        turn = equilibrium.largest_turn(&step);
        let state = equilibrium.move_mixed(&coupled.state, &mut step, &mut way);
        shapes = coupled.step_to(wing, state, &shapes, &rest_twist);
        if turn < 0.5 * mark.0 || turn > 5.0 * mark.0 {
            mark = (turn, rate);
        }
        if turn > LONG {
            rate *= HARDER;
        } else if IDLE * rate < mark.1 {
            rate *= AGAIN;
            softer = if softer < SLOWLY { SLOWLY } else { softer.sqrt() };
            mark = (turn, rate);
        } else if turn < 0.5 * LONG {
            rate *= softer;
        }
    }
    Ok(Err(coupled.newton_steps))
}
