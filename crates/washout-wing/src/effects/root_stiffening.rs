//! A flexure at the root that stiffens as it turns.

use super::card::{Card, Need, Parameter, Places, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::input::Design;
use crate::structure::{Stiffening, StructureError};

/// See the module.
#[derive(Debug)]
pub struct RootStiffening;

const CARD: Card = Card {
    name: "root-stiffening",
    family: "root-stiffening",
    summary: "The flexure at the root stiffens as it turns: a short hinge, or one that runs onto its stops.",
    formula: "T = k θ (1 + s |θ/θ₁|ᵖ), k = root.pitch_stiffness_n_m_per_rad, θ₁ = at, p = power",
    source: "definition; p = 2 is the first term that any stiffness which is alike both ways can have (G. Duffing 1918), a large p a stop",
    when_right: "hinges that turn by tens of degrees. Several amplitudes show it: twist grows more slowly with the load than a spring lets \
                 it, the more so the larger it is, whatever makes the load",
    gets_wrong: "hinges that give way, creep or lag, or are not alike both ways; with linear kinematics it does nothing",
    case: "a_root_that_stiffens_turns_until_its_torque_is_that_of_the_load",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "torque added at the angle `at`, over that of the spring there",
            default: 0.0,
            range: [0.0, 1000.0],
            plausible: [0.0, 2.0],
        },
        Parameter {
            name: "at",
            unit: "deg",
            meaning: "angle for which the strength counts",
            default: 30.0,
            range: [0.1, 180.0],
            plausible: [5.0, 90.0],
        },
        Parameter {
            name: "power",
            unit: "1",
            meaning: "power of the angle with which the stiffness grows",
            default: 2.0,
            range: [0.5, 40.0],
            plausible: [1.0, 20.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::SoftRoot],
    has_switch: false,
};

impl Effect for RootStiffening {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn stands_for(&self, values: &Values, _: &Design) -> Option<(f64, &'static str)> {
        let doubled = values.at(1) * values.strength().powf(-1.0 / values.at(2));
        doubled.is_finite().then_some((
            doubled,
            "deg, the turn at which the torque of the root has doubled",
        ))
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 2,
            at: &[2.0, 6.0, 12.0],
            reach: 3.0,
            spar: None,
            of_one_wing: false,
        })
    }

    // stops and short hinges stiffen by laws of their own
    fn own_error(&self) -> f64 {
        0.15
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &["root.pitch_stiffness_n_m_per_rad=0.005"]
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let base = wing.mesh.rod_nodes().first().copied();
        let roots = wing.model.springs.iter_mut();
        for root in roots.filter(|own| Some(own.node) == base && own.rotation_n_m_rad[0] > 0.0) {
            root.stiffening = Stiffening {
                growth: values.strength() / values.at(1).to_radians().powf(values.at(2)),
                power: values.at(2),
            };
        }
        Ok(())
    }
}
