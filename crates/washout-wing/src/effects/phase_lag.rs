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
    source: "definition, for a delay of the load of whatever cause; that of circulation by Wagner 1925 is wagner-lag",
    when_right: "a lag that is short against the stroke. With twist read before and after mid-stroke it shows in the first order, with opposite signs, at mid-stroke \
                 as 1 − s² only; a reading whose clock is off looks the same",
    gets_wrong: "a lag that differs along the span: in chords travelled that of circulation is the longer the nearer the base (wagner-lag); inertia, for which see \
                 twist-dynamics",
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

    fn depends_on_stroke(&self) -> bool {
        true
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
