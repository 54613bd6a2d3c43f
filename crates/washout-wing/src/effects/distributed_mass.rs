//! A wing that is heavier than its design: glue, paint, moisture, thicker plies.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct DistributedMass;

const CARD: Card = Card {
    name: "distributed-mass",
    family: "mass",
    summary: "Every part weighs more than the design says: glue, paint, moisture.",
    formula: "m' = (1 + s) m of rods, spars and film",
    source: "definition; Kapton takes up 2 % of water, glue adds 10 to 30 % to hand-made wings",
    when_right: "weigh the wing: this is the difference",
    gets_wrong: "mass that sits in one place (tip-mass)",
    case: "a_wing_of_twice_the_mass_weighs_twice_as_much",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "mass added, over the wing's own",
        default: 0.0,
        range: [-0.9, 50.0],
        plausible: [-0.1, 0.3],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Gravity],
    has_switch: false,
};

impl Effect for DistributedMass {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &["effects.centrifugal-load.strength=1"]
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let factor = 1.0 + values.strength();
        for section in &mut wing.model.sections {
            section.mass_kg_m *= factor;
            section.inertia_kg_m *= factor;
        }
        for sheet in &mut wing.model.sheets {
            sheet.density_kg_m3 *= factor;
        }
        Ok(())
    }
}
