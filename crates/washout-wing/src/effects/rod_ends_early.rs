//! A rod that ends, or is much thinner, before the tip.

use super::card::{Card, Parameter, Places, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct RodEndsEarly;

const CARD: Card = Card {
    name: "rod-ends-early",
    family: "rod-damage",
    summary: "From a station on the rod is missing or thinner than stated.",
    formula: "EA, GJ, EI, mass' = (1 − s) of the rod's outboard of the station; an element that it cuts is softened by the covered share",
    source: "definition",
    when_right: "a rod cut short, sanded down or broken off; prefer rod-split if bending across the wing's plane stays",
    gets_wrong: "s = 1 cannot be: film and glue leave something, so at most 0.999; a taper is a step here",
    case: "a_rod_that_is_half_as_stiff_from_the_middle_on_twists_by_half_more",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the rod's stiffness that is missing outboard",
            default: 0.0,
            range: [0.0, 0.999],
            plausible: [0.0, 0.95],
        },
        Parameter {
            name: "from",
            unit: "1",
            meaning: "station from which it is missing, as a fraction of the rod's length",
            default: 0.7,
            range: [0.0, 1.0],
            plausible: [0.3, 0.95],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RodEndsEarly {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // an independent model answers with 1.07 of this
    fn own_error(&self) -> f64 {
        0.1
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.2, 0.4, 0.6, 0.8],
            reach: 0.1,
            spar: None,
            of_one_wing: true,
        })
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let missing = values.strength();
        for (beam, outboard) in wing.rod_between(values.at(1), 1.0) {
            wing.model.change_section(beam, |section| {
                section.soften(outboard * missing / (1.0 - missing));
                section.mass_kg_m *= 1.0 - missing * outboard;
                section.inertia_kg_m *= 1.0 - missing * outboard;
            })?;
        }
        Ok(())
    }
}
