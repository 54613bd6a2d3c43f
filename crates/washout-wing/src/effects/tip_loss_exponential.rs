//! Tip loss that fades inward within a stated part of the chord: the rival of Prandtl's factor.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, Places, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct TipLossExponential;

const CARD: Card = Card {
    name: "tip-loss-exponential",
    family: "tip-loss",
    summary: "Air flows around the tip, so that the load falls there, and recovers inward within a part of the mean chord.",
    formula: "C' = C (1 − s exp(−(R − r) / (k c̄)))",
    source: "the tip correction of slender-wing practice, as a fade of free length; k c̄ about half a chord fits lifting-line results of rectangular wings of aspect ratio 3 to 8",
    when_right: "a flapping wing whenever the reach of the loss is to be stated; prefer tip-loss-prandtl for a fast turning one, and finite-span-downwash in a straight \
                 stream",
    gets_wrong: "the shape of the fade; the part of the load that a tip vortex adds at low aspect ratio",
    case: "exponential_tip_loss_fades_inward_within_half_a_chord",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the load that is lost at the very tip: 1 is all of it; more turns it round there",
            default: 0.0,
            range: [0.0, 1.5],
            plausible: [0.0, 1.0],
        },
        Parameter {
            name: "reach",
            unit: "1",
            meaning: "length over which the loss fades to 37 %, in mean chords",
            default: 0.5,
            range: [0.05, 5.0],
            plausible: [0.2, 1.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

impl Effect for TipLossExponential {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // how the loss falls off inboard is assumed: Prandtl's loss in another model of the wing is met to 12 to 16 % of what it makes
    fn own_error(&self) -> f64 {
        0.12
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.3, 0.7],
            reach: 0.2,
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
        let reach_m = values.at(1) * place.mean_chord_m;
        let loss = if reach_m > 0.0 {
            (-(place.tip_m - place.r_m).max(0.0) / reach_m).exp()
        } else {
            0.0
        };
        let factor = 1.0 - values.strength() * loss;
        now.cl *= factor;
        now.cd *= factor;
    }
}
