//! Large rotation, for models that are run linear.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Values};

/// See the module.
#[derive(Debug)]
pub struct LargeRotation;

const CARD: Card = Card {
    name: "large-rotation",
    family: "large-rotation",
    summary: "The wing turns so far that its loads and its stiffness turn with it.",
    formula: "F = (1 − s) F_linear + s F_large",
    source: "geometrically exact statics of the same elements: corotational frames, Felippa & Haugen 2005",
    when_right: "always: s = 1 is the truth, 0 the linear idealisation",
    gets_wrong: "between 0 and 1 it is a path from one model to the other, not physics",
    case: "a_linear_model_with_all_of_large_rotation_is_the_large_rotation_model",
    seam: Seam::Kinematics,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share of large rotation: 1 is all of it",
        default: 0.0,
        range: [0.0, 1.0],
        plausible: [0.0, 1.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Linear],
    has_switch: false,
};

impl Effect for LargeRotation {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        // in linear kinematics a film without tension sags by many chords
        &[
            "structure.kinematics=\"linear\"",
            "film.compression=\"carries\"",
            "film.pretension_n_per_m=74",
        ]
    }

    fn is_all_or_none(&self) -> bool {
        true
    }

    fn kinematics(&self, values: &Values) -> Option<f64> {
        Some(values.strength())
    }
}
