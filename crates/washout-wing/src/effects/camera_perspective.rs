//! A camera that stands near: what is nearer to it is shown larger.

use super::card::{Card, Need, PICTURE_CHANNELS, Parameter, Seam};
use super::{Effect, Values, View};
use crate::input::design::Design;

/// See the module.
#[derive(Debug)]
pub struct CameraPerspective;

const CARD: Card = Card {
    name: "camera-perspective",
    family: "camera",
    summary: "The camera stands near, so that it shows larger what comes nearer to it.",
    formula: "A point at h toward the camera, seen from the place that the camera is aimed at, is shown 1/(1 − s h) as far from it, s = 1/distance; d/d₀ of the edges \
              shown so is read as if s were 0",
    source: "pinhole: Hartley & Zisserman 2004, Multiple View Geometry in Computer Vision, 2nd ed., ch. 6",
    when_right: "twist read by a camera (observation.instrument, or rows with instrument = camera) that stands within some ten lengths of the wing; a telecentric lens has \
                 none of it, nor has an angle read along the span. It grows with twist and with the distance from where the camera is aimed, whatever the load. The same wing \
                 filmed from half and from double the distance shows it; or, with a camera along the stroke, from both half-strokes, between which its sign changes",
    gets_wrong: "the lens (distortion); a camera that is not aimed at the leading edge: one that stands H beside its axis and looks along it sees as one that is turned \
                 by H/distance (camera-tilt); displacements, which are read as they are",
    case: "a_near_camera_shows_what_comes_nearer_larger",
    seam: Seam::Picture,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1/m",
            meaning: "one over the distance of the camera from where it is aimed: 4 is 250 mm. Positive above the wing, on the side of lift, or, along the stroke, downstream of it; \
                      negative on the other side",
            default: 0.0,
            range: [-10.0, 10.0],
            plausible: [-4.0, 4.0],
        },
        Parameter {
            name: "aim",
            unit: "1",
            meaning: "where along the leading edge it is aimed, over the length of the wing",
            default: 0.5,
            range: [-5.0, 5.0],
            plausible: [0.0, 1.0],
        },
    ],
    channels: PICTURE_CHANNELS,
    needs: &[Need::Flow, Need::Camera],
    has_switch: false,
};

impl Effect for CameraPerspective {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &[
            "observation.instrument=\"camera\"",
            "observation.camera_axis=\"stroke\"",
        ]
    }

    fn is_of_picture(&self) -> bool {
        true
    }

    fn view(&self, values: &Values, design: &Design, view: &mut View) {
        view.nearness_per_m += values.strength();
        view.aim_m += values.at(1) * 1e-3 * design.planform.length_mm.value();
    }
}
