//! Lift coefficient that grows with the local twist, in proportion: the paper's shape factor in its plainest form.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct LiftGainLinear;

const CARD: Card = Card {
    name: "lift-gain-linear",
    family: "lift-gain",
    summary: "A twisted wing lifts more than its blade elements alone, in proportion to the local twist.",
    formula: "C_L' = C_L (1 + s θ), θ = α_root − α",
    source: "Colmenares et al.: effective lift coefficients of twisted wings 13 to 64 % above blade elements; their formula is not published, this one is an assumption",
    when_right: "twist up to about 20 deg; the rival lift-gain-saturating where larger twist is within the data",
    gets_wrong: "what the rest of the span does to a section; drag, which is left; it has no bound at large twist",
    case: "lift_grows_with_local_twist_in_proportion",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1/rad",
        meaning: "gain of the lift coefficient per radian of twist",
        default: 0.0,
        range: [-1.5, 6.0],
        plausible: [0.0, 2.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for LiftGainLinear {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // the formula is assumed: gains with the local twist, or with its rate along the span, differ by 16 to 21 % in what they make.
    fn own_error(&self) -> f64 {
        0.15
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let twist = -air.alpha + place.root_angle_rad;
        now.cl *= twist * values.strength() + 1.0;
    }
}
