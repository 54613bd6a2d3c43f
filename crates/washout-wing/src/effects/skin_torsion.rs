//! A skin or coating that helps the rod to resist torsion.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct SkinTorsion;

const CARD: Card = Card {
    name: "skin-torsion",
    family: "rod-stiffness",
    summary: "A skin, coating or glue around the beam adds torsional stiffness.",
    formula: "GJ' = GJ (1 + s)",
    source: "definition; a closed skin of thickness t around the area A adds 4 A² G t / perimeter (Bredt 1896)",
    when_right: "a skin along the whole beam; prefer rod-shear-modulus if rods of one material differ alike",
    gets_wrong: "skins that wrinkle under torsion",
    case: "a_beam_of_twice_the_torsional_stiffness_twists_half_as_far",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "torsional stiffness added, over that of the rod",
        default: 0.0,
        range: [0.0, 20.0],
        plausible: [0.0, 0.3],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for SkinTorsion {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, _) in wing.rod_elements() {
            wing.model.change_section(beam, |section| {
                let more = values.strength() * section.gj_n_m2();
                section.stiffen(0.0, more, 0.0, 0.0);
            })?;
        }
        Ok(())
    }
}
