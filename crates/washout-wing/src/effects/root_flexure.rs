//! A root that turns about the span under the wing's torque.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::input::Design;
use crate::structure::{StructureError, innermost_rod, rod_length_m};

/// See the module.
#[derive(Debug)]
pub struct RootFlexure;

const CARD: Card = Card {
    name: "root-flexure",
    family: "root",
    summary: "The root gives way in pitch: stop, flexure or glue.",
    formula: "θ_root = C T, C = s L/GJ, spread over the first element of the rod",
    source: "definition; adds to root.pitch_stiffness_n_m_per_rad if the design has one",
    when_right: "an offset in twist that goes with load and is there at the first station already",
    gets_wrong: "a stop that turns by play, not by load (stop-backlash); bending of the root",
    case: "a_root_as_soft_as_the_rod_doubles_the_twist_of_its_tip",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "compliance of the root, over that of a rod as long as the wing",
            default: 0.0,
            range: [0.0, 1000.0],
            plausible: [0.0, 0.3],
        },
        Parameter {
            name: "gj_n_m2",
            unit: "N m^2",
            meaning: "torsional stiffness of that rod; 0: the innermost section of the wing, in studies of their first wing, for one \
                      mount holds all",
            default: 0.0,
            range: [0.0, 1e9],
            plausible: [0.0, 1e9],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RootFlexure {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn common_numbers(&self, first: &Design) -> Result<Vec<(&'static str, f64)>, StructureError> {
        let section = innermost_rod(first)?;
        Ok(section
            .iter()
            .map(|section| ("gj_n_m2", section.gj_n_m2()))
            .collect())
    }

    fn stands_for(&self, values: &Values, design: &Design) -> Option<(f64, &'static str)> {
        let stated = Some(values.at(1)).filter(|stated| *stated > 0.0);
        let own = || Some(innermost_rod(design).ok()??.gj_n_m2());
        let stiffness = stated.or_else(own)? / (values.strength() * rod_length_m(design));
        stiffness
            .is_finite()
            .then_some((1e3 * stiffness, "mN·m/rad, the stiffness of the root in pitch"))
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let rod = wing.rod_elements();
        if let (Some((beam, [from_m, to_m])), Some((_, [_, length_m]))) = (rod.first(), rod.last()) {
            let share = values.strength() * length_m / (to_m - from_m);
            let gj_n_m2 = values.at(1);
            wing.model.change_section(*beam, |section| {
                section.compliance[(3, 3)] += match gj_n_m2 > 0.0 {
                    true => share / gj_n_m2,
                    false => share * section.compliance[(3, 3)],
                };
            })?;
        }
        Ok(())
    }
}
