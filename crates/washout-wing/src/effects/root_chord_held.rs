//! A root edge of the film that is glued or tied instead of free.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::{Spring, Stiffening, StructureError};

/// See the module.
#[derive(Debug)]
pub struct RootChordHeld;

const CARD: Card = Card {
    name: "root-chord-held",
    family: "root",
    summary: "The film's root edge is held by the hub instead of hanging free.",
    formula: "springs of s E t b/c at each node of the root edge, b its share of the root chord c, in all directions",
    source: "definition; s = 0 is root.chord = free, s → ∞ root.chord = clamped as to displacements",
    when_right: "wings whose film is glued along the root; it holds the trailing edge near the root",
    gets_wrong: "rotation of the edge, which stays free",
    case: "a_held_root_edge_carries_what_its_springs_carry",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "stiffness of the hold, over that of a square of the film",
        default: 0.0,
        range: [0.0, 1000000.0],
        plausible: [0.0, 10.0],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Film],
    has_switch: false,
};

impl Effect for RootChordHeld {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let Some(sheet) = wing.model.sheets.first() else {
            return Ok(());
        };
        let stretching = sheet.e_pa * sheet.thickness_m;
        let root = &wing.mesh.root;
        let y_m = |place: usize| wing.model.nodes[root[place]].y;
        let last = root.len().saturating_sub(1);
        let chord_m = y_m(last) - y_m(0);
        for (place, &node) in root.iter().enumerate() {
            let (before, after) = (place.saturating_sub(1), (place + 1).min(last));
            let share = 0.5 * (y_m(after) - y_m(before)) / chord_m;
            wing.model.springs.push(Spring {
                node,
                displacement_n_m: [values.strength() * stretching * share; 3],
                rotation_n_m_rad: [0.0; 3],
                stiffening: Stiffening::NONE,
            });
        }
        Ok(())
    }
}
