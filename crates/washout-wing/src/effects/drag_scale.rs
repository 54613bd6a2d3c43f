//! A drag coefficient larger or smaller than the law at the same lift.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct DragScale;

const CARD: Card = Card {
    name: "drag-scale",
    family: "coefficients",
    summary: "The drag coefficient differs from the law by a factor, the lift does not.",
    formula: "C_D' = (1 + s) C_D",
    source: "definition; drag laws of Dickinson 1999 and of Whitney & Wood 2010 differ by 12 % at 45 deg",
    when_right: "thick spars, ribs or a rough edge add drag; or the drag law was measured on a smoother wing",
    gets_wrong: "drag that acts elsewhere than the pressure does",
    case: "scaled_drag_leaves_lift",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share by which drag grows",
        default: 0.0,
        range: [-0.9, 4.0],
        plausible: [-0.2, 0.3],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for DragScale {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn coefficients(
        &self,
        values: &Values,
        _place: &StripPlace,
        _air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        now.cd *= 1.0 + values.strength();
    }
}
