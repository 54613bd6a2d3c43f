//! A rod that twists when it bends, because its fibres run at an angle.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct BendTwistCoupling;

const CARD: Card = Card {
    name: "bend-twist-coupling",
    family: "rod-coupling",
    summary: "The rod's fibres run at an angle, so that bending twists it.",
    formula: "K = s √(GJ EI_flap) between twist rate and flapwise curvature; s > 0: bending toward +z washes out",
    source: "Weisshaar 1981, J. Aircraft 18, 669; Minguet & Dugundji 1990 for strips with s up to 0.5",
    when_right: "off-axis plies, a spiral in a pultruded rod, spars laid at an angle",
    gets_wrong: "coupling of stretch with twist, which off-axis plies have too",
    case: "a_coupled_rod_twists_under_a_bending_moment",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "coupling stiffness over √(GJ EI)",
        default: 0.0,
        range: [-0.95, 0.95],
        plausible: [-0.4, 0.4],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

impl Effect for BendTwistCoupling {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, _) in wing.rod_elements() {
            wing.model
                .change_section(beam, |section| section.couple_bend_twist(values.strength()))?;
        }
        Ok(())
    }
}
