//! Weight of the wing, for models that leave it out.

use super::card::{Card, Parameter, Seam, WING_CHANNELS};
use nalgebra::Vector3;

use super::{Effect, Structure, Values};
use crate::aero::Flow;
use crate::structure::{Loads, weigh};

/// Standard acceleration of free fall, m/s².
const STANDARD_M_S2: f64 = 9.80665;

/// See the module.
#[derive(Debug)]
pub struct Gravity;

const CARD: Card = Card {
    name: "gravity",
    family: "inertia",
    summary: "The wing's own weight bends and twists it.",
    formula: "dF = s g dm, g = 9.80665 m/s² × (sin β, cos β sin τ, −cos β cos τ), β slope of the span, τ = angle of the design + tilt: stop angle of a flapping wing with a level \
              stroke plane, root angle in a level stream (turned by its sweep), 0 on the bench",
    source: "Newton; CGPM 1901 for g",
    when_right: "bench tests and slow flight; at 20 Hz the wing's weight is small beside its air load. The same load with the wing upside down shows it: \
                 what changes is twice the weight",
    gets_wrong: "a body that accelerates",
    case: "a_wing_in_gravity_hangs_with_its_weight",
    seam: Seam::Load,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the acceleration on Earth: 1 is all of it",
            default: 0.0,
            range: [-10.0, 10.0],
            plausible: [0.0, 1.0],
        },
        Parameter {
            name: "tilt_deg",
            unit: "deg",
            meaning: "nose-up pitch of stroke plane, stream or bench against level",
            default: 0.0,
            range: [-360.0, 360.0],
            plausible: [-90.0, 90.0],
        },
        Parameter {
            name: "slope_deg",
            unit: "deg",
            meaning: "angle by which the span points down",
            default: 0.0,
            range: [-90.0, 90.0],
            plausible: [-90.0, 90.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for Gravity {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn load(&self, values: &Values, wing: &Structure, loads: &mut Loads) {
        let (own_rad, sweep_rad) = match Flow::from_design(wing.design) {
            Some(Flow::Flapping { stop_angle_rad, .. }) => (stop_angle_rad, 0.0),
            Some(Flow::Steady {
                root_angle_rad,
                sweep_rad,
                ..
            }) => (root_angle_rad, sweep_rad),
            None => (0.0, 0.0),
        };
        let (sine, cosine) = (own_rad + values.at(1).to_radians()).sin_cos();
        let (down, level) = values.at(2).to_radians().sin_cos();
        let (aft, along) = sweep_rad.sin_cos();
        let (x, y) = (down, level * sine);
        let direction = Vector3::new(x * along + y * aft, y * along - x * aft, -level * cosine);
        let acceleration = direction * (values.strength() * STANDARD_M_S2);
        weigh(wing.model, &acceleration, loads);
    }
}
