//! A spar that is cracked or broken at one place.

use super::card::{Card, Need, Parameter, Places, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// Length over which the hinge is spread, as a fraction of the spar's.
const WIDTH: f64 = 0.1;

/// See the module.
#[derive(Debug)]
pub struct BrokenSpar;

const CARD: Card = Card {
    name: "broken-spar",
    family: "spar-damage",
    summary: "One spar is cracked, so that it hinges there.",
    formula: "φ = C M at the crack, C = s/(1 − s) L/EI_flap of the spar, spread over a tenth of its length",
    source: "rotational spring for a crack: Dimarogonas 1996, Eng. Fract. Mech. 55, 831",
    when_right: "one spar; compare its neighbours, which take over its load",
    gets_wrong: "which faces of the crack close: it hinges alike both ways; torsion of the broken spar",
    case: "a_spar_cracked_in_the_middle_hinges_there",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "0.5: as compliant as the whole spar; near 1: broken",
            default: 0.0,
            range: [0.0, 0.9999],
            plausible: [0.0, 0.99],
        },
        Parameter {
            name: "spar",
            unit: "1",
            meaning: "which spar, counted from 0 as in the design",
            default: 0.0,
            range: [0.0, 1000.0],
            plausible: [0.0, 8.0],
        },
        Parameter {
            name: "place",
            unit: "1",
            meaning: "where, as a fraction of the spar's length from the leading edge",
            default: 0.25,
            range: [0.0, 1.0],
            plausible: [0.05, 0.95],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Spars],
    has_switch: false,
};

impl Effect for BrokenSpar {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 2,
            at: &[0.4],
            reach: 0.2,
            spar: Some(1),
            of_one_wing: true,
        })
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let count = wing.mesh.spar_count();
        let spar = values.at(1).round() as usize;
        let elements = wing.spar_elements(spar);
        let Some((_, [_, length_m])) = elements.last() else {
            return Err(StructureError::NoSuchSpar { index: spar, count });
        };
        let (share, place) = (values.strength(), values.at(2));
        let compliance = share / (1.0 - share);
        let (low, high) = ((place - 0.5 * WIDTH).max(0.0), (place + 0.5 * WIDTH).min(1.0));
        for &(beam, [from_m, to_m]) in &elements {
            let (from, to) = (from_m / length_m, to_m / length_m);
            let covered = (to.min(high) - from.max(low)).max(0.0);
            if covered > 0.0 {
                let share = compliance * covered / ((high - low) * (to - from));
                wing.model
                    .change_section(beam, |section| section.soften_bending(share, 0.0))?;
            }
        }
        Ok(())
    }
}
