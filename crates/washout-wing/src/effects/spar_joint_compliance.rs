//! Joints at which the spars hinge on the rod.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct SparJointCompliance;

const CARD: Card = Card {
    name: "spar-joint-compliance",
    family: "spar-stiffness",
    summary: "The joints of spars and rod give way, so that the spars rotate against the rod.",
    formula: "φ = C M at each joint, C = s L/EI_flap of the spar, spread over its first element",
    source: "definition; lap joints in thin resin: Volkersen 1938 for the shear of the glue",
    when_right: "glued or lashed joints; all joints alike",
    gets_wrong: "torsion and edgewise bending of the joint; on coarse meshes the hinge sits half an element off the rod",
    case: "a_joint_as_soft_as_its_spar_adds_three_deflections",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "flapwise compliance of each joint, over L/EI of its spar",
        default: 0.0,
        range: [0.0, 1000.0],
        plausible: [0.0, 0.5],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Spars],
    has_switch: false,
};

impl Effect for SparJointCompliance {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // the joint's place in the mesh decides
    fn own_error(&self) -> f64 {
        0.1
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for spar in 0..wing.mesh.spar_count() {
            let elements = wing.spar_elements(spar);
            let (Some((beam, [from_m, to_m])), Some((_, [_, length_m]))) =
                (elements.first(), elements.last())
            else {
                continue;
            };
            let share = values.strength() * length_m / (to_m - from_m);
            wing.model
                .change_section(*beam, |section| section.soften_bending(share, 0.0))?;
        }
        Ok(())
    }
}
