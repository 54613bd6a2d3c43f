//! Tip loss by Prandtl's factor: the load falls to nothing at the tip, where the air flows around it.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, Places, StripPlace, Values};
use crate::aero::{Flow, SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct TipLossPrandtl;

const CARD: Card = Card {
    name: "tip-loss-prandtl",
    family: "tip-loss",
    summary: "Air flows around the tip, so that the load falls to nothing there.",
    formula: "C' = C (1 − s (1 − F)), F = (2/π) acos(exp(−(B/2) (R − r) / (r' sin φ))), r' = r + r₀, B = 2, tan φ = λ",
    source: "Prandtl 1919, appendix to Betz; B = 2 half-strokes as blades, inflow ratio as for a hovering wing",
    when_right: "a hovering or turning wing; prefer tip-loss-exponential if the reach of the loss is to be stated, and finite-span-downwash in a straight stream. \
                 Twist at several stations shows it: the load is missing over the last half chord alone, at every speed alike",
    gets_wrong: "the strength of the leading-edge vortex near the tip; the inflow ratio is fixed, and so is B: a single wing over both half-strokes is \
                 something between one blade and two",
    case: "prandtl_factor_scales_the_load_of_every_strip",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of Prandtl's loss that acts: 1 is his whole factor; more: a stronger one, which turns the load of the last strips round",
            default: 0.0,
            range: [0.0, 1.5],
            plausible: [0.0, 1.0],
        },
        Parameter {
            name: "inflow_ratio",
            unit: "1",
            meaning: "λ, the tangent of the angle at which the air comes in: how far the loss reaches inboard; one blade instead of two is \
                      twice the ratio",
            default: 0.2,
            range: [0.02, 2.0],
            plausible: [0.1, 0.6],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

/// Blades over two.
const HALF_BLADES: f64 = 1.0;

impl Effect for TipLossPrandtl {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // how far the loss reaches is that of a propeller: two models of one wing differ by 11 to 15 % in what it makes.
    fn own_error(&self) -> f64 {
        0.12
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.2, 0.4],
            reach: 0.1,
            spar: None,
            of_one_wing: false,
        })
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        _air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let factor = 1.0 - values.strength() * (1.0 - prandtl(place, values.at(1)));
        now.cl *= factor;
        now.cd *= factor;
    }
}

/// Prandtl's factor at a strip, for an inflow ratio.
pub fn prandtl(place: &StripPlace, inflow_ratio: f64) -> f64 {
    let offset_m = match place.flow {
        Some(Flow::Flapping { root_offset_m, .. }) => *root_offset_m,
        _ => 0.0,
    };
    let arm_m = place.r_m + offset_m;
    let exponent = -HALF_BLADES * (place.tip_m - place.r_m).max(0.0) / (arm_m * inflow_ratio.atan().sin());
    exponent.exp().acos() * std::f64::consts::FRAC_2_PI
}
