//! Play of the pitch stop: the root turns freely until the stop is met.

use super::card::{Card, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::aero::Flow;
use crate::structure::{BeamTwist, Loads};

/// See the module.
#[derive(Debug)]
pub struct StopBacklash;

const CARD: Card = Card {
    name: "stop-backlash",
    family: "stop-play",
    summary: "The pitch stop has play, which the load closes: the whole wing turns by it.",
    formula: "θ_root = s toward the load; the first rod element is without torque at that twist",
    source: "definition; free play of hinges: Woolston et al. 1957, J. Aeronaut. Sci. 24, 57",
    when_right: "an offset in twist that is there at the first station and does not grow with load; prefer root-flexure if it does",
    gets_wrong: "the load that closes the play (any load does), loads that change sign, and the knock at the stop",
    case: "play_at_the_stop_turns_the_wing_by_itself",
    seam: Seam::Load,
    parameters: &[Parameter {
        name: "strength",
        unit: "deg",
        meaning: "angle by which the root turns before the stop is met",
        default: 0.0,
        range: [0.0, 45.0],
        plausible: [0.0, 5.0],
    }],
    channels: WING_CHANNELS,
    needs: &[],
    has_switch: true,
};

impl Effect for StopBacklash {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn load(&self, values: &Values, wing: &Structure, loads: &mut Loads) {
        if let Some(&(beam, _)) = wing.rod_elements().first() {
            let angle_rad = values.strength().to_radians() * toward_load(wing, loads);
            loads.twists.push(BeamTwist { beam, angle_rad });
        }
    }
}

/// 1 if the load turns the wing toward washout, −1 if the other way: the air's if there is any, else the bench's.
fn toward_load(wing: &Structure, loads: &Loads) -> f64 {
    if let Some(flow) = Flow::from_design(wing.design) {
        return if flow.root_angle_rad() < 0.0 { -1.0 } else { 1.0 };
    }
    let at = |node: usize| wing.model.nodes[node];
    let nodal = loads.force_n.iter().zip(&loads.moment_n_m).enumerate();
    let nodal = nodal.map(|(node, (force, moment))| at(node).cross(force).x + moment.x);
    let arms = loads.arms.iter();
    let arms = arms.map(|arm| (at(arm.node) + arm.arm_m).cross(&arm.force_n).x);
    if nodal.sum::<f64>() + arms.sum::<f64>() < 0.0 {
        -1.0
    } else {
        1.0
    }
}
