//! A rod that has lost bending stiffness over a stretch of its length, and kept its torsional stiffness.

use super::card::{Card, Parameter, Places, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct RodBendingLoss;

const CARD: Card = Card {
    name: "rod-bending-loss",
    family: "rod-bending-damage",
    summary: "From one station to another the rod has lost bending stiffness, both ways, and kept its torsional stiffness: broken or kinked fibres.",
    formula: "EI' = (1 − s) EI flapwise and edgewise between the stations, EA and GJ as they were; an element that a station cuts is softened by the \
              covered share",
    source: "definition, after Euler and Bernoulli: fibres along the rod carry EI = Σ E_f A_f z², those at ±45° around it carry GJ (laminate theory, Jones 1999, \
             Mechanics of Composite Materials, ch. 4), so that broken ones of the first kind cost bending alone",
    when_right: "braided or wrapped rods that were bent too far, and kinks. A force and a torque at the tip on the bench show it: the \
                 deflection grows from the station on, the twist under a torque does not. In flight the leading edge bends more at nearly the same twist",
    gets_wrong: "the stretching stiffness, which broken fibres lose too and a rod that is bent hardly feels; kinks that close under load \
                 the other way; a rod of fibres along it alone keeps some torsion only",
    case: "a_rod_that_lost_bending_between_two_stations_bends_more_there_and_twists_as_before",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the bending stiffness that is lost",
            default: 0.0,
            range: [0.0, 0.999],
            plausible: [0.0, 0.95],
        },
        Parameter {
            name: "from",
            unit: "1",
            meaning: "station from which it is lost, as a fraction of the rod's length",
            default: 0.5,
            range: [0.0, 1.0],
            plausible: [0.0, 0.95],
        },
        Parameter {
            name: "to",
            unit: "1",
            meaning: "station to which it is lost; nothing is, unless it lies beyond the first",
            default: 1.0,
            range: [0.0, 1.0],
            plausible: [0.05, 1.0],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RodBendingLoss {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9],
            reach: 0.05,
            spar: None,
            of_one_wing: true,
        })
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let lost = values.strength();
        for (beam, share) in wing.rod_between(values.at(1), values.at(2)) {
            let softer = share * lost / (1.0 - lost);
            wing.model
                .change_section(beam, |section| section.soften_bending(softer, softer))?;
        }
        Ok(())
    }
}
