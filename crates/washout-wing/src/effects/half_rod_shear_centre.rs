//! A shear centre of the half-round rod that lies further off than the ideal section's.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct HalfRodShearCentre;

const CARD: Card = Card {
    name: "half-rod-shear-centre",
    family: "rod-torsion",
    summary: "The film pulls on the half rod beside its shear centre, and further beside it than the ideal section has it.",
    formula: "e' = (1 + s) e, e = (8/(5π) − 4/(3π)) a from the centroid",
    source: "Timoshenko & Goodier, Theory of Elasticity, bending of bars: 8 a (3 + 4ν)/(15π(1 + ν)) from the flat, so s = 0.46 at ν = 0.3 and s = 5 for a film glued to the flat",
    when_right: "half rods whose film or glue sits off the centroid; it turns the rod by the film's pull, not by the air's lever",
    gets_wrong: "the same lever for the film's pull along the chord and for shear along the rod; glue fillets",
    case: "a_force_beside_the_shear_centre_twists_by_its_lever",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "offset added, over that of the ideal section: 1 doubles it, -1 takes it away",
        default: 0.0,
        range: [-20.0, 20.0],
        plausible: [-1.0, 5.0],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::HalfRound],
    has_switch: false,
};

impl Effect for HalfRodShearCentre {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, _) in wing.rod_elements() {
            wing.model.change_section(beam, |section| {
                section.scale_shear_centre(1.0 + values.strength())
            })?;
        }
        Ok(())
    }
}
