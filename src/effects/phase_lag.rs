//! The air load of an earlier stroke phase: circulation, or a creeping wing, follows the stroke late.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{Flow, SectionAir};

/// See the module.
#[derive(Debug)]
pub struct PhaseLag;

const CARD: Card = Card {
    name: "phase-lag",
    family: "unsteady",
    summary: "The air load follows the stroke late, so that an earlier, slower (or faster) part of the stroke is felt.",
    formula: "U'(phase) = U(phase − s)",
    source: "delay of the load by build-up of circulation (Wagner 1925: half of it at once, 90 % after six half-chords); definition",
    when_right: "a lag that is short against the stroke; with twist read off mid-stroke it shows in the first order, at mid-stroke as 1 − s² only",
    gets_wrong: "the shape of the build-up; inertia, for which see twist-dynamics",
    case: "lagging_load_is_that_of_an_earlier_phase",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "deg",
        meaning: "stroke phase by which the load lags",
        default: 0.0,
        range: [-60.0, 60.0],
        plausible: [0.0, 25.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

impl Effect for PhaseLag {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        let Some(Flow::Flapping { phase_rad, .. }) = place.flow else {
            return;
        };
        let now = phase_rad.cos();
        if now.abs() > 1e-6 {
            let ratio = (phase_rad - values.strength().to_radians()).cos() / now;
            air.speed_squared *= ratio * ratio;
        }
    }
}
