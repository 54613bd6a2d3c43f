//! A frame that was taken earlier or later in the stroke than the design says.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values, View};
use crate::aero::{Flow, SectionAir};
use crate::input::design::Design;

/// See the module.
#[derive(Debug)]
pub struct FrameTiming;

const CARD: Card = Card {
    name: "frame-timing",
    family: "unsteady",
    summary: "The frame was taken late (or early): it shows the shape under the load of that phase, and the wing where it has swung by then.",
    formula: "U'(phase) = U(phase + s); a camera sees the wing swung on by Φ (sin(phase + s) − sin phase) about the flapping axis, Φ half of the stroke",
    source: "definition, for the sinusoidal stroke of the model; one frame at 1000 frames/s is 7.9 deg of a stroke at 22 Hz",
    when_right: "frames that were picked by eye, or triggered without a mark on the drive. At mid-stroke both parts are even in s: the load falls by 1 − s², and a camera along the stroke \
                 shows d² = c² (sin² α + cos² α sin² ψ), less twist even where there is none. By the load alone, and so along the span and the flapping axis, it is phase-lag by another \
                 name, which is of its family. Frames at several known steps about mid-stroke show it: the true middle is where the reading is even about; so does another frequency, which changes \
                 the share of the load and not that of the swing",
    gets_wrong: "inertia of that phase (twist-dynamics, inertia-off-mid-stroke), which it takes at the phase of the design; lift, drag and power, which no frame reads: their \
                 means are taken with the twist of the frame, that of the instant is of its load; frames of different conditions that are off by different phases",
    case: "a_late_frame_shows_the_load_and_the_place_of_its_phase",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "deg",
        meaning: "stroke phase by which the frame is late; negative: early",
        default: 0.0,
        range: [-60.0, 60.0],
        plausible: [0.0, 15.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

impl Effect for FrameTiming {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn depends_on_stroke(&self) -> bool {
        true
    }

    fn is_of_picture(&self) -> bool {
        true
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        let Some(Flow::Flapping { phase_rad, .. }) = place.flow else {
            return;
        };
        let stated = phase_rad.cos();
        if stated.abs() > 1e-6 {
            let ratio = (phase_rad + values.strength().to_radians()).cos() / stated;
            air.speed_squared *= ratio * ratio;
        }
    }

    fn view(&self, values: &Values, design: &Design, view: &mut View) {
        if let Some(Flow::Flapping {
            half_amplitude_rad,
            phase_rad,
            ..
        }) = Flow::from_design(design)
        {
            let late = phase_rad + values.strength().to_radians();
            view.swing_rad += half_amplitude_rad * (late.sin() - phase_rad.sin());
        }
    }
}
