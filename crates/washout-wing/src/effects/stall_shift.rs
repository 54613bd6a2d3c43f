//! The angle of the largest lift moved: stall comes later or earlier than the law says.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct StallShift;

const CARD: Card = Card {
    name: "stall-shift",
    family: "coefficients",
    summary: "The largest lift is reached at a larger (or smaller) angle of attack than the law says.",
    formula: "C_L' = C_L(α − s sin 2α): the maximum at 45 deg moves to 45 deg + s; 0, 90 and 180 deg stay",
    source: "definition; the angle of the largest lift of revolving wings lies between 40 and 55 deg (Usherwood & Ellington 2002, J. Exp. Biol. 205, 1547)",
    when_right: "a law with its maximum near 45 deg; the leading-edge vortex holds on longer or less long than where the law was measured",
    gets_wrong: "drag, which is left; the slope at 0 falls by the share 2s (s in rad) with it; a law without stall is stretched",
    case: "lift_at_an_angle_is_that_of_the_warped_angle",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "deg",
        meaning: "angle by which the maximum moves up",
        default: 0.0,
        range: [-25.0, 25.0],
        plausible: [-8.0, 8.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for StallShift {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let shift = values.strength().to_radians();
        let (moved, _) = place.law.coefficients.lift_and_drag(warped(air.alpha, shift));
        let (base, _) = place.law.coefficients.lift_and_drag(air.alpha);
        now.cl += moved - base;
    }
}

/// The angle at which the law is asked instead, rad.
fn warped(alpha: Dual, shift_rad: f64) -> Dual {
    use num_dual::DualNum;
    alpha - (alpha * 2.0).sin() * shift_rad
}
