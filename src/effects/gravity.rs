//! Weight of the wing, for models that leave it out.

use super::card::{Card, Parameter, Seam, WING_CHANNELS};
use nalgebra::Vector3;

use super::{Effect, Structure, Values};
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
    formula: "dF = s g dm, g = 9.80665 m/s² × (sin β, cos β sin τ, −cos β cos τ), β slope of the span, τ nose-up pitch of the root",
    source: "Newton; CGPM 1901 for g",
    when_right: "bench tests and slow flight; at 20 Hz the wing's weight is small beside its air load",
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
            name: "pitch_deg",
            unit: "deg",
            meaning: "nose-up pitch of the wing's root against gravity; a flapping wing at its stop: the stop's angle",
            default: 45.0,
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
        let (sine, cosine) = values.at(1).to_radians().sin_cos();
        let (down, level) = values.at(2).to_radians().sin_cos();
        let direction = Vector3::new(down, level * sine, -level * cosine);
        let acceleration = direction * (values.strength() * STANDARD_M_S2);
        weigh(wing.model, &acceleration, loads);
    }
}
