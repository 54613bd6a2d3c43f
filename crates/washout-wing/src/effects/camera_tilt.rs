//! A camera that does not look along the axis that the design states.

use super::card::{Card, Need, PICTURE_CHANNELS, Parameter, Seam};
use super::{Effect, Values, View};
use crate::input::design::Design;

/// See the module.
#[derive(Debug)]
pub struct CameraTilt;

const CARD: Card = Card {
    name: "camera-tilt",
    family: "camera",
    summary: "The camera looks askew: it is turned about the span against the axis that the design states.",
    formula: "d/d₀ = sin(α + s)/sin(α_root + s) along the stroke, cos(α + s)/cos(α_root + s) along the flapping axis; read as if s were 0: to first order \
              θ is wrong by (tan α/tan α_root − 1) s, or (tan α_root/tan α − 1) s",
    source: "definition, by projection: Hartley & Zisserman 2004, Multiple View Geometry in Computer Vision, 2nd ed., ch. 6 (affine cameras)",
    when_right: "twist read by a camera (observation.instrument, or rows with instrument = camera) that was set up by eye. It is nothing without twist and grows with it, whatever the load; \
                 a stop angle that is wrong by s reads the same, but changes the load as well. Twist of one wing at one load read in both half-strokes, between which its sign changes, \
                 shows it; or the same wing read along the span, which it does not touch in the first order",
    gets_wrong: "turns about the other line across the axis, which are of the second order, and roll, which changes no distance",
    case: "a_tilted_camera_reads_twist_wrong_by_its_share",
    seam: Seam::Picture,
    parameters: &[Parameter {
        name: "strength",
        unit: "deg",
        meaning: "angle by which the camera is turned about the span, positive the way washout turns a chord",
        default: 0.0,
        range: [-30.0, 30.0],
        plausible: [-5.0, 5.0],
    }],
    channels: PICTURE_CHANNELS,
    needs: &[Need::Flow, Need::Camera],
    has_switch: false,
};

impl Effect for CameraTilt {
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

    fn view(&self, values: &Values, _design: &Design, view: &mut View) {
        view.tilt_rad += values.strength().to_radians();
    }
}
