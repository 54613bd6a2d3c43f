//! A skin or coating that helps the rod to bend out of the wing's plane until it gives way.

use super::card::{Card, Parameter, Places, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::structure::{Skin, StructureError};

/// See the module.
#[derive(Debug)]
pub struct SkinYielding;

const CARD: Card = Card {
    name: "skin-yielding",
    family: "skin",
    summary: "A skin adds flapwise bending stiffness until it gives way: it buckles where it is pressed, slips on its glue, or yields.",
    formula: "M = EI_flap [κ + s (k κ + (1 − k) κ₀ tanh(κ/κ₀))], κ₀ = from / length of the rod, k = kept",
    source: "definition: skins that are elastic until they give way on both sides, smoothed, because fibres at different heights give way \
             one after the other; on the Pre-Pazy wing the stiffness that the skin adds falls from 14 ± 4 % under 0.6 kg to 3 ± 1 \
             % under 3.2 kg (masses of equal deflection with and without it, Zenodo 4299868)",
    when_right: "films and coatings on thick sections, which go slack where they are pressed by more than they were shrunk; prefer \
                 skin-bending while the strain is small",
    gets_wrong: "that what yielded does not come back when the load goes; with linear kinematics it never gives way; the forces of the \
                 section that are written are those of the rod alone",
    case: "a_skin_that_gives_way_carries_its_moment_and_no_more",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "flapwise stiffness added while it holds, over that of the rod",
            default: 0.0,
            range: [0.0, 20.0],
            plausible: [0.0, 0.3],
        },
        Parameter {
            name: "from",
            unit: "rad",
            meaning: "bend at which it gives way, as the angle by which the whole rod turns if it is bent so all along",
            default: 0.75,
            range: [0.001, 100.0],
            plausible: [0.1, 3.0],
        },
        Parameter {
            name: "kept",
            unit: "1",
            meaning: "share of its stiffness that it keeps: 0.5 where the stretched side goes on, 0 where both sides give way",
            default: 0.0,
            range: [0.0, 1.0],
            plausible: [0.0, 0.5],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for SkinYielding {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.25, 0.75, 1.5],
            reach: 0.25,
            spar: None,
            of_one_wing: true,
        })
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let rod = wing.rod_elements();
        let length_m = rod.last().map_or(0.0, |(_, [_, end_m])| *end_m);
        for (beam, _) in rod {
            wing.model.change_section(beam, |section| {
                section.skin = Some(Skin {
                    flap_n_m2: values.strength() * section.ei_flap_n_m2(),
                    gives_way_per_m: values.at(1) / length_m,
                    kept: values.at(2),
                });
            })?;
        }
        Ok(())
    }
}
