//! The leading-edge vortex does not stay attached beyond some chords from the axis, and lift falls there.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{Flow, SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct LeadingEdgeVortexLoss;

const CARD: Card = Card {
    name: "leading-edge-vortex-loss",
    family: "leading-edge-vortex",
    summary: "Beyond about four chords from the flapping axis the leading-edge vortex sheds, and sections lift less.",
    formula: "C_L' = C_L (1 − s ½(1 + tanh((r'/c̄ − n) / 0.5))), r' = r + r₀, n = 4",
    source: "Kruyt, van Heijst, Altshuler & Lentink 2015, J. R. Soc. Interface 12, 20150051: stall delay ends near four chords from the axis; Lentink & Dickinson 2009",
    when_right: "slender or far offset wings that revolve or sweep many chords; laws measured on stubby wings",
    gets_wrong: "the drag of the stalled part, which is left; strokes too short for the vortex to shed",
    case: "sections_beyond_four_chords_lose_lift",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the lift that is lost far outside",
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

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        _air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let Some(Flow::Flapping { root_offset_m, .. }) = place.flow else {
            return;
        };
        if place.mean_chord_m > 0.0 {
            let chords = (place.r_m + root_offset_m) / place.mean_chord_m;
            let beyond = 0.5 * (1.0 + ((chords - values.at(1)) / FADE_CHORDS).tanh());
            now.cl *= 1.0 - values.strength() * beyond;
        }
    }
}
