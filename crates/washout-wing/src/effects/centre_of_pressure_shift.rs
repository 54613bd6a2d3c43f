//! A centre of pressure that lies further aft (or forward) than the law says.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct CentreOfPressureShift;

const CARD: Card = Card {
    name: "centre-of-pressure-shift",
    family: "centre-of-pressure",
    summary: "The air load acts further behind the leading edge than the law says (negative: further forward), by the same share of the chord everywhere.",
    formula: "x' = x + s",
    source: "definition; the laws of Dickson 2006 and of the Purdue robot differ by up to 0.1",
    when_right: "camber or separation moves the load along the chord at all angles alike",
    gets_wrong: "a shift that depends on the angle of attack; the centre stays within 2 to 98 % of the chord",
    case: "twist_of_a_stiff_chord_goes_with_the_lever_of_the_centre_of_pressure",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "chord",
        meaning: "shift toward the trailing edge from where the design's law has it (air.centre_of_pressure)",
        default: 0.0,
        range: [-0.3, 0.5],
        plausible: [-0.08, 0.08],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for CentreOfPressureShift {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn is_of_moment(&self) -> bool {
        true
    }

    fn coefficients(
        &self,
        values: &Values,
        _place: &StripPlace,
        _air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let moved = now.centre_of_pressure + values.strength();
        now.centre_of_pressure = match moved.re {
            x if x < 0.02 => Dual::from(0.02),
            x if x > 0.98 => Dual::from(0.98),
            _ => moved,
        };
    }
}
