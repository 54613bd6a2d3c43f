//! Inertia of the wing that twists and bends over the stroke: it is still on its way when it is looked at.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, MotionNumbers, Structure, Values};
use crate::structure::Loads;

/// See the module.
#[derive(Debug)]
pub struct TwistDynamics;

const CARD: Card = Card {
    name: "twist-dynamics",
    family: "inertia",
    summary: "The wing twists back and forth with every stroke, and its own mass with the air that moves with it drives it beyond, or holds it back from, the shape that would stand still.",
    formula: "dF = −s (M + M_air) ü at the phase of the design; u: odd harmonics to 13 of 8 modes about the loaded shape, driven by sweep, flip (raised cosine over the share F of the stroke) and load, damped by the air and by the share ζ of the critical damping",
    source: "harmonic balance (Nayfeh & Mook 1979); added mass ρ(π/4)c² (Ellington 1984, part II)",
    when_right: "a mode lies near an odd harmonic of the stroke, or the flip is hard. Frequencies in small steps at one f Φ show it: the twist swings with \
                 the distance of the third harmonic from a mode, where all that is quasi-steady stays",
    gets_wrong: "length of the flip and damping are assumed, and near a harmonic decide the sign: try the ends of their plausible ranges; the \
                 other effects of the motion take them from here while this one is on, and 0.2 and 0.02 else; stiffness is that of the loaded shape, also while the film is slack; the motion is that of the wing without this effect, so that it does not see its own change of stiffness",
    case: "twist_with_its_inertia_is_that_of_the_periodic_motion",
    seam: Seam::Load,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the inertia of the deforming wing: 1 is all of it",
            default: 0.0,
            range: [-2.0, 3.0],
            plausible: [0.0, 1.3],
        },
        Parameter {
            name: "damping",
            unit: "1",
            meaning: "damping ζ of the structure over the critical one, in every mode",
            default: 0.02,
            range: [0.0, 0.5],
            plausible: [0.005, 0.05],
        },
        Parameter {
            name: "flip",
            unit: "1",
            meaning: "share F of the stroke that each flip between the stops takes",
            default: 0.2,
            range: [0.02, 0.5],
            plausible: [0.1, 0.35],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Motion],
    has_switch: false,
};

impl Effect for TwistDynamics {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn motion(&self, values: &Values) -> Option<MotionNumbers> {
        Some(MotionNumbers {
            damping_ratio: values.at(1),
            flip_share: values.at(2),
        })
    }

    fn load(&self, values: &Values, wing: &Structure, loads: &mut Loads) {
        let Some(motion) = wing.motion else {
            return;
        };
        for (node, (a, b)) in motion.inertia.iter().zip(&motion.moved_air).enumerate() {
            loads.force_n[node] += (a.force_n + b.force_n) * values.strength();
            loads.moment_n_m[node] += (a.moment_n_m + b.moment_n_m) * values.strength();
        }
    }
}
