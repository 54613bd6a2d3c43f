//! A rod that has split along its length, so that its halves slide on each other.

use std::f64::consts::PI;

use super::card::{Card, Parameter, Places, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// What two sliding halves add to the compliance of a round rod in bending, over its own: I of the whole over twice
/// that of a half about its own centroid, less 1.
const BENDING: f64 = PI / 4.0 / (PI / 4.0 - 16.0 / (9.0 * PI)) - 1.0;

/// The same in torsion.
const TORSION: f64 = PI / 2.0 / (PI - 8.0 / PI) - 1.0;

/// See the module.
#[derive(Debug)]
pub struct RodSplit;

const CARD: Card = Card {
    name: "rod-split",
    family: "rod-damage",
    summary: "From a station on the rod is split along the wing's plane, or two half-rods glued to one have debonded; the halves slide on each other.",
    formula: "1/GJ' = (1 + 1.640 s) / GJ, 1/EI_flap' = (1 + 2.578 s) / EI_flap outboard of the station (two half-rounds, J = 2 × 0.2976 a⁴, I = 2 × 0.1098 a⁴)",
    source: "St Venant torsion of the half circle, Timoshenko & Goodier, Theory of Elasticity, torsion",
    when_right: "pultruded rods split along their fibres, glue lines between half-rods that failed; prefer rod-ends-early if edgewise bending is lost too",
    gets_wrong: "friction between the halves; rods that are not round; partial cracks are smeared",
    case: "a_split_rod_twists_by_the_ratio_of_two_halves_to_the_whole",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "1: fully split; compliance added, as a share of that of two halves",
            default: 0.0,
            range: [0.0, 1.5],
            plausible: [0.0, 1.0],
        },
        Parameter {
            name: "from",
            unit: "1",
            meaning: "station from which it is split, as a fraction of the rod's length",
            default: 0.5,
            range: [0.0, 1.0],
            plausible: [0.0, 0.95],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RodSplit {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.2, 0.4, 0.6, 0.8],
            reach: 0.1,
            spar: None,
        })
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, outboard) in wing.rod_between(values.at(1), 1.0) {
            let share = outboard * values.strength();
            wing.model.change_section(beam, |section| {
                section.soften_torsion(TORSION * share);
                section.soften_bending(BENDING * share, 0.0);
            })?;
        }
        Ok(())
    }
}
