//! A skin or coating that helps the rod to resist bending out of the wing's plane.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct SkinBending;

const CARD: Card = Card {
    name: "skin-bending",
    family: "rod-stiffness",
    summary: "A skin, coating or glue around the beam adds flapwise bending stiffness.",
    formula: "EI_flap' = EI_flap (1 + s)",
    source: "definition; on the Pre-Pazy wing the skin adds 9 to 24 % (slopes with and without it, Zenodo 4299868)",
    when_right: "a skin along the whole beam; compare wings with and without it",
    gets_wrong: "skins that buckle on the compressed side and so stiffen less under larger load",
    case: "a_beam_of_twice_the_bending_stiffness_bends_half_as_far",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "flapwise stiffness added, over that of the rod",
        default: 0.0,
        range: [0.0, 20.0],
        plausible: [0.0, 0.3],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for SkinBending {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, _) in wing.rod_elements() {
            wing.model.change_section(beam, |section| {
                let more = values.strength() * section.ei_flap_n_m2();
                section.stiffen(0.0, 0.0, more, 0.0);
            })?;
        }
        Ok(())
    }
}
