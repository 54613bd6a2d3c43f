//! The leading-edge vortex does not stay attached beyond some chords from the axis, and lift falls there.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, Places, StripPlace, Values};
use crate::aero::{Flow, SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct LeadingEdgeVortexLoss;

const CARD: Card = Card {
    name: "leading-edge-vortex-loss",
    family: "leading-edge-vortex",
    summary: "Beyond about four chords from the flapping axis the leading-edge vortex sheds, and sections carry less across their chord: less lift and less drag.",
    formula: "C_N' = C_N (1 − s ½(1 + tanh((r'/c̄ − n) / 0.5))), r' = r + r₀, n = 4; C_N = C_L cos α + C_D sin α, the force along the chord stays",
    source: "Kruyt, van Heijst, Altshuler & Lentink 2015, J. R. Soc. Interface 12, 20150051: stall delay ends near four chords from the axis; Lentink & Dickinson 2009; force across the chord: Usherwood & Ellington 2002, J. Exp. Biol. 205, 1547, and \
             Dickson & Dickinson 2004, J. Exp. Biol. 207, 4269",
    when_right: "slender or far offset wings that revolve or sweep many chords; laws measured on stubby wings. Drag beside lift shows it: both fall, where \
                 stall-shift and coefficients that are too large in lift leave the drag",
    gets_wrong: "a law without drag (thin-airfoil), whose pull along the chord is left and would drive the wing; strokes too short for the vortex to shed",
    case: "sections_beyond_four_chords_lose_force_across_their_chord",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the force across the chord that is lost far outside",
            default: 0.0,
            range: [0.0, 1.0],
            plausible: [0.0, 0.4],
        },
        Parameter {
            name: "chords",
            unit: "1",
            meaning: "distance from the axis at which half of that is lost, in mean chords",
            default: 4.0,
            range: [0.5, 20.0],
            plausible: [3.0, 5.5],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

/// Half width of the passage from attached to shed, in mean chords.
const FADE_CHORDS: f64 = 0.5;

impl Effect for LeadingEdgeVortexLoss {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // assumed, as for a tip loss: where the vortex sheds is a round number, and so is the shape of the loss beyond
    fn own_error(&self) -> f64 {
        0.12
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[3.2, 4.0, 5.0],
            reach: 0.4,
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
        let Some(Flow::Flapping { root_offset_m, .. }) = place.flow else {
            return;
        };
        if place.mean_chord_m > 0.0 {
            let chords = (place.r_m + root_offset_m) / place.mean_chord_m;
            let beyond = 0.5 * (1.0 + ((chords - values.at(1)) / FADE_CHORDS).tanh());
            now.lose_normal_force(air.alpha, values.strength() * beyond);
        }
    }
}
