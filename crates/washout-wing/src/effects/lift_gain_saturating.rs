//! Lift coefficient that grows with the local twist up to a bound: a rival form of the paper's shape factor.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, Places, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};
use num_dual::DualNum;

/// See the module.
#[derive(Debug)]
pub struct LiftGainSaturating;

const CARD: Card = Card {
    name: "lift-gain-saturating",
    family: "lift-gain",
    summary: "A twisted wing lifts more than its blade elements alone; the gain levels off at large twist.",
    formula: "C_L' = C_L (1 + s tanh(θ / θ_s)), θ = α_root − α",
    source: "Colmenares et al.: effective lift coefficients of twisted wings 13 to 64 % above blade elements; their formula is not published, this one is an assumption",
    when_right: "twist reaches tens of degrees; prefer lift-gain-linear while twist stays small against θ_s, where only s / θ_s shows",
    gets_wrong: "what the rest of the span does to a section; drag, which is left",
    case: "lift_gain_levels_off_at_its_scale",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "largest gain of the lift coefficient",
            default: 0.0,
            range: [-0.9, 4.0],
            plausible: [0.0, 0.8],
        },
        Parameter {
            name: "scale_deg",
            unit: "deg",
            meaning: "twist at which three quarters of the gain are reached",
            default: 15.0,
            range: [1.0, 90.0],
            plausible: [5.0, 40.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for LiftGainSaturating {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // the formula is assumed: gains with the local twist, or with its rate along the span, differ by 16 to 21 % in what they make.
    fn own_error(&self) -> f64 {
        0.15
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[8.0, 20.0],
            reach: 6.0,
            spar: None,
            of_one_wing: false,
        })
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let twist = -air.alpha + place.root_angle_rad;
        let share = (twist / values.at(1).to_radians()).tanh();
        now.cl *= share * values.strength() + 1.0;
    }
}
