//! A rod whose shear modulus is not the assumed one: resin-rich, damp, or of another maker.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct RodShearModulus;

const CARD: Card = Card {
    name: "rod-shear-modulus",
    family: "rod-torsion",
    summary: "The rod twists more or less easily than its assumed shear modulus says.",
    formula: "GJ' = GJ / (1 + s)",
    source: "definition; pultruded carbon rods scatter between 3 and 6 GPa; 2 GPa with voids or a soft resin, 7 GPa measured on good laminates",
    when_right: "the same factor for all rods of one material, at any load",
    gets_wrong: "nothing in itself; it looks like every other cause that lets all rods twist in proportion to load",
    case: "a_rod_of_half_the_stiffness_twists_twice_as_far",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "torsional compliance added, over that of the rod: 1 doubles the twist",
        default: 0.0,
        range: [-0.9, 20.0],
        plausible: [-0.45, 1.0],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RodShearModulus {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, _) in wing.rod_elements() {
            wing.model
                .change_section(beam, |section| section.soften_torsion(values.strength()))?;
        }
        Ok(())
    }
}
