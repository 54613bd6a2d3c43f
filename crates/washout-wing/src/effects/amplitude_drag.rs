//! A driven wing of less drag sweeps further: its amplitude is not that of the rigid wing.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::SectionAir;

/// See the module.
#[derive(Debug)]
pub struct AmplitudeDrag;

const CARD: Card = Card {
    name: "amplitude-drag",
    family: "drive",
    summary: "Twist lowers the drag, and the drive then sweeps the wing further (or less far) than assumed.",
    formula: "Φ' = Φ (Q/Q₀)^−s, Q/Q₀: drag torque at mid-stroke over that of the untwisted wing",
    source: "balance of the drive: s = 1/2 at equal torque (Q ∝ Φ²), 1/3 at equal power (P ∝ Φ³)",
    when_right: "the amplitude of another wing on the same drive and voltage was taken over",
    gets_wrong: "spring, resonance and motor limits of the drive; the drag ratio is that of the wing at the assumed amplitude",
    case: "amplitude_grows_as_drag_falls",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "exponent: 0.5 holds the torque, 0.33 the power",
        default: 0.0,
        range: [-2.0, 2.0],
        plausible: [0.0, 0.6],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Motion],
    has_switch: false,
};

impl Effect for AmplitudeDrag {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        let ratio = place.motion.map_or(1.0, |motion| motion.drag_ratio);
        air.speed_squared *= ratio.powf(-2.0 * values.strength());
    }
}
