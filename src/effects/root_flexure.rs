//! A root that turns about the span under the wing's torque.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct RootFlexure;

const CARD: Card = Card {
    name: "root-flexure",
    family: "root",
    summary: "The root gives way in pitch: stop, flexure or glue.",
    formula: "θ_root = C T, C = s L/GJ of the innermost rod, spread over its first element",
    source: "definition; adds to root.pitch_stiffness_n_m_per_rad if the design has one",
    when_right: "an offset in twist that goes with load and is there at the first station already",
    gets_wrong: "a stop that turns by play, not by load (stop-backlash); bending of the root",
    case: "a_root_as_soft_as_the_rod_doubles_the_twist_of_its_tip",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "compliance of the root, over that of a rod of the innermost section as long as the wing",
        default: 0.0,
        range: [0.0, 1000.0],
        plausible: [0.0, 0.3],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for RootFlexure {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let rod = wing.rod_elements();
        if let (Some((beam, [from_m, to_m])), Some((_, [_, length_m]))) = (rod.first(), rod.last()) {
            let share = values.strength() * length_m / (to_m - from_m);
            wing.model.change_section(*beam, |section| {
                section.compliance[(3, 3)] *= 1.0 + share;
            })?;
        }
        Ok(())
    }
}
