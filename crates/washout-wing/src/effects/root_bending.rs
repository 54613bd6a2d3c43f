//! A root that gives way in flapwise bending.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::input::Design;
use crate::structure::{StructureError, innermost_rod, rod_length_m};

/// See the module.
#[derive(Debug)]
pub struct RootBending;

const CARD: Card = Card {
    name: "root-bending",
    family: "root",
    summary: "The root gives way in bending out of the wing's plane: socket, glue or bench clamp.",
    formula: "φ_root = C M, C = s L/EI_flap, spread over the first element of the rod",
    source: "definition; clamps that give way are the common reason for cantilevers that seem too soft",
    when_right: "bench tests of beams in a clamp; the deflection gains a part that is linear in span",
    gets_wrong: "bending in the wing's plane",
    case: "a_root_as_soft_in_bending_as_the_rod_adds_three_deflections",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "bending compliance of the root, over L/EI of a rod as long as the wing",
            default: 0.0,
            range: [0.0, 1000.0],
            plausible: [0.0, 0.1],
        },
        Parameter {
            name: "ei_n_m2",
            unit: "N m^2",
            meaning: "flapwise bending stiffness of that rod; 0: the innermost section of the wing, in studies of their first wing, for \
                      one mount holds all",
            default: 0.0,
            range: [0.0, 1e9],
            plausible: [0.0, 1e9],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RootBending {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn common_numbers(&self, first: &Design) -> Result<Vec<(&'static str, f64)>, StructureError> {
        let section = innermost_rod(first)?;
        Ok(section
            .iter()
            .map(|section| ("ei_n_m2", section.ei_flap_n_m2()))
            .collect())
    }

    fn stands_for(&self, values: &Values, design: &Design) -> Option<(f64, &'static str)> {
        let stated = Some(values.at(1)).filter(|stated| *stated > 0.0);
        let own = || Some(innermost_rod(design).ok()??.ei_flap_n_m2());
        let stiffness = stated.or_else(own)? / (values.strength() * rod_length_m(design));
        stiffness
            .is_finite()
            .then_some((1e3 * stiffness, "mN·m/rad, the stiffness of the root in bending"))
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let rod = wing.rod_elements();
        if let (Some((beam, [from_m, to_m])), Some((_, [_, length_m]))) = (rod.first(), rod.last()) {
            let share = values.strength() * length_m / (to_m - from_m);
            let ei_n_m2 = values.at(1);
            wing.model.change_section(*beam, |section| {
                let own = if ei_n_m2 > 0.0 {
                    section.ei_flap_n_m2() / ei_n_m2
                } else {
                    1.0
                };
                section.soften_bending(share * own, 0.0);
            })?;
        }
        Ok(())
    }
}
