//! What is not finite on the way to equilibrium and in what is found there: which number, where, with which effect.

use nalgebra::Vector3;

use super::air::Air;
use super::error::CouplingError;
use super::solution::Solution;
use super::strip_air::StripAir;
use super::strips::{Strip, StripShape};
use crate::structure::finite::each;
use crate::structure::{NotFinite, refuse_not_finite};

/// Cure of a number that no effect is at fault for.
pub(super) const OF_DESIGN: &str = "correct the numbers of the design that it is made from";
const RAN_AWAY: &str =
    "the search ran away; try a smaller load, structure.load_increments = 10, or a finer mesh";

/// The air on strips that are asked for in one shape: a force, moment or derivative that is not finite is refused.
///
/// # Errors
/// What it is, on which strip, and with which effect it comes.
pub(super) fn refuse_air(
    strip: &Strip,
    air: &Air,
    velocity: &Vector3<f64>,
    shape: &StripShape,
    found: &StripAir,
) -> Result<(), CouplingError> {
    let Err(fault) = numbers(strip, found) else {
        return Ok(());
    };
    let place = || format!("of the strip at r = {:.2} mm", strip.r_m * 1e3);
    if let Err(fault) = refuse_not_finite(place, each("the shape (m)", shape.iter())) {
        return Err(because(fault, RAN_AWAY));
    }
    let again = |air: &Air| match found.by_shape.is_empty() {
        true => strip.air_at(air, velocity, shape),
        false => strip.air_and_derivative(air, shape),
    };
    let plain = again(&air.with_first(0)).force;
    let met = format!(
        "{} (angle of attack {:.2} deg, {:.3} m/s)",
        fault.place,
        plain.alpha.to_degrees(),
        plain.speed
    );
    let fault = NotFinite { place: met, ..fault };
    let names = air.effects();
    let culprit = (0..=names.len()).find(|&count| numbers(strip, &again(&air.with_first(count))).is_err());
    Err(match culprit.and_then(|count| names.get(count.checked_sub(1)?)) {
        Some(name) => by_effect(name)(fault),
        None => because(fault, OF_DESIGN),
    })
}

/// Cure of a number that comes with an effect.
pub(super) fn with_effect(name: &str) -> String {
    format!("it comes with effects.{name}: correct its numbers or its formula, or set its strength to 0")
}

/// An error that names the effect with which a number is not finite.
pub(super) fn by_effect(name: &str) -> impl Fn(NotFinite) -> CouplingError {
    move |found| because(found, &with_effect(name))
}

fn because(found: NotFinite, cure: &str) -> CouplingError {
    CouplingError::NotFinite {
        found,
        cure: cure.to_string(),
    }
}

impl From<NotFinite> for CouplingError {
    fn from(found: NotFinite) -> Self {
        because(found, OF_DESIGN)
    }
}

fn numbers(strip: &Strip, air: &StripAir) -> Result<(), NotFinite> {
    let force = &air.force;
    let section = [
        ("the angle of attack (rad)", force.alpha),
        ("the speed (m/s)", force.speed),
        ("the lift coefficient", force.cl),
        ("the drag coefficient", force.cd),
        ("the centre of pressure (chords)", force.centre_of_pressure),
        ("the moment (N·m/m)", force.moment_n),
        ("the normal force (N/m)", force.normal_n_per_m),
        ("the tangential force (N/m)", force.tangential_n_per_m),
    ];
    let spread = each("the force (N)", air.total_n.iter())
        .chain(each("the couple (N)", air.couple_n.iter()))
        .chain(each("the share of a point", &air.weights));
    let by_shape = air.by_shape.iter().flat_map(|by| by.iter());
    let slopes = each("the change of force with the shape (N/m)", by_shape);
    let place = || format!("of the strip at r = {:.2} mm", strip.r_m * 1e3);
    refuse_not_finite(place, section.into_iter().chain(spread).chain(slopes))
}

impl Solution {
    /// Refuses a solution of which a number is not finite.
    ///
    /// # Errors
    /// What it is and where.
    pub(super) fn refuse_not_finite(&self) -> Result<(), CouplingError> {
        let node = |node: usize| {
            let [x, y, _] = self.mesh.nodes[node];
            format!("at r = {:.2} mm, y = {:.2} mm", x * 1e3, y * 1e3)
        };
        for (index, force) in self.air_force_n.iter().enumerate() {
            refuse_not_finite(|| node(index), each("the force of the air (N)", force))?;
        }
        for state in [&self.rest, &self.state] {
            let nodes = state.displacement.iter().zip(&state.rotation);
            for (index, (moved, turned)) in nodes.enumerate() {
                let numbers = each("the displacement (m)", moved.iter())
                    .chain(each("the rotation", turned.coords.iter()));
                refuse_not_finite(|| node(index), numbers)?;
            }
        }
        for (index, force) in self.beam_force.iter().enumerate() {
            let place = || format!("of the beam element {}", node(self.mesh.beams[index].nodes[0]));
            refuse_not_finite(place, each("the force or moment (N, N·m)", force))?;
        }
        let triangles = self.mesh.triangles.iter().zip(&self.pressure_pa);
        for (index, (corners, pressure)) in triangles.enumerate() {
            let tension = self.membrane_force_n_per_m.get(index).into_iter().flatten();
            let numbers = each("the tension (N/m)", tension).chain([("the pressure (Pa)", *pressure)]);
            refuse_not_finite(|| format!("of the film {}", node(corners[0])), numbers)?;
        }
        let report = &self.report;
        let numbers = each("the reaction (N)", &report.reaction_force_n)
            .chain(each("the reaction (N·m)", &report.reaction_moment_n_m))
            .chain(each("the residual", &report.residual))
            .chain(each("the critical pressure", &report.critical_pressure_ratio))
            .chain(each(
                "the twist of a strip (deg)",
                report.twist_history_deg.iter().flatten(),
            ))
            .chain([("the change of twist (deg)", report.twist_change_deg)]);
        refuse_not_finite(|| "of the wing", numbers)?;
        Ok(())
    }
}
