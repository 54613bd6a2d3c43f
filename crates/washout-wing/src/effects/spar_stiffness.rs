//! Spars that bend and twist more or less easily than stated.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct SparStiffness;

const CARD: Card = Card {
    name: "spar-stiffness",
    family: "spar-stiffness",
    summary: "The spars are softer or stiffer than stated: width, plies, resin.",
    formula: "EI, GJ, EA' = EI, GJ, EA / (1 + s) of every spar",
    source: "definition; prepreg strips scatter by 10 to 20 % in thickness, and bending goes with its cube",
    when_right: "the same factor for all spars; prefer spar-joint-compliance if the joints give way",
    gets_wrong: "nothing in itself; it looks like soft joints",
    case: "a_spar_of_half_the_stiffness_bends_twice_as_far",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "compliance added, over that of the spars: 1 halves their stiffness",
        default: 0.0,
        range: [-0.95, 1000.0],
        plausible: [-0.4, 0.6],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Spars],
    has_switch: false,
};

impl Effect for SparStiffness {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for spar in 0..wing.mesh.spar_count() {
            for (beam, _) in wing.spar_elements(spar) {
                wing.model
                    .change_section(beam, |section| section.soften(values.strength()))?;
            }
        }
        Ok(())
    }
}
