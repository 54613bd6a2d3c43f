//! Lift and drag coefficients larger or smaller than the law, in proportion: another Reynolds number, another leading edge.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct CoefficientScale;

const CARD: Card = Card {
    name: "coefficient-scale",
    family: "coefficients",
    summary: "Lift and drag coefficients differ from the law by the same factor at every angle.",
    formula: "C_L' = (1 + s) C_L, C_D' = (1 + s) C_D",
    source: "definition; published coefficients of revolving wings at Re 1e2 to 1e4 scatter by 10 to 20 % (Lentink & Dickinson 2009, J. Exp. Biol. 212, 2705)",
    when_right: "the law was measured at another Reynolds number, on another planform or edge",
    gets_wrong: "a change that depends on the angle; it cannot be told from air-density without added mass",
    case: "scaled_coefficients_scale_force_and_moment",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share by which both coefficients grow",
        default: 0.0,
        range: [-0.9, 4.0],
        plausible: [-0.2, 0.2],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for CoefficientScale {
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
        now.cl *= 1.0 + values.strength();
        now.cd *= 1.0 + values.strength();
    }
}
