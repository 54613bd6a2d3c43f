//! A rod that has lost torsional stiffness over a stretch of its length, and kept its bending stiffness.

use super::card::{Card, Parameter, Places, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct RodTorsionLoss;

const CARD: Card = Card {
    name: "rod-torsion-loss",
    family: "rod-torsion-damage",
    summary: "From one station to another the rod has lost torsional stiffness and kept its bending stiffness: cracked resin, debonded fibres, splinters.",
    formula: "GJ' = (1 − s) GJ between the stations, EA and EI as they were; an element that a station cuts is softened by the covered share",
    source: "definition, after St Venant; the shear modulus of a fibre rod is its resin's, G = G_m / (1 − √V_f (1 − G_m/G_f)), Chamis 1983, NASA \
             TM-83320, while EI is its fibres': cracks along the fibres take the first, and the second as long as the resin bridges \
             them here and there, as slender bending hardly shears it",
    when_right: "fibre rods after over-twisting, a crash or too tight a clamp. A torque and a force at the tip on the bench show it: the twist \
                 grows outboard of the station alone, the deflection does not. In flight the twist rate steps up there, in \
                 proportion to the load",
    gets_wrong: "splinters that are loose all along bend more easily across the wing's plane, too (rod-split); friction between them, which makes \
                 the loss smaller under small loads; a loss that begins gradually is a step here",
    case: "a_rod_that_lost_torsion_between_two_stations_twists_more_there_and_bends_as_before",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the torsional stiffness that is lost",
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

impl Effect for RodTorsionLoss {
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
            wing.model.change_section(beam, |section| {
                section.soften_torsion(share * lost / (1.0 - lost));
            })?;
        }
        Ok(())
    }
}
