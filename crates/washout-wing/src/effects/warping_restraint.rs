//! A rod whose clamped end cannot warp, and therefore hardly twists near it.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct WarpingRestraint;

const CARD: Card = Card {
    name: "warping-restraint",
    family: "rod-torsion-root",
    summary: "The clamp keeps the rod's section plane, so that its first millimetre or so does not twist.",
    formula: "1/GJ' = (1 − exp(−x/s)) / GJ, s = √(E C_w / GJ), averaged over each element",
    source: "Vlasov 1961; s = b √(E/(48 G)) for a thin strip of width b: 0.8 mm for a carbon strip of 1 mm",
    when_right: "sections that warp (half-round, strip, laminate) and fibres much stiffer than the resin; round rods do not warp",
    gets_wrong: "restraint at joints of two sections, and the bimoment's stress",
    case: "a_clamp_that_stops_warping_shortens_the_rod_by_its_decay_length",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "mm",
        meaning: "length over which the restraint decays; the tip twists as if the rod were shorter by as much",
        default: 0.0,
        range: [0.0, 1000.0],
        plausible: [0.0, 3.0],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::ShapedRod],
    has_switch: false,
};

impl Effect for WarpingRestraint {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let decay_m = 1e-3 * values.strength();
        for (beam, [from_m, to_m]) in wing.rod_elements() {
            let mean = decay_m * ((-from_m / decay_m).exp() - (-to_m / decay_m).exp()) / (to_m - from_m);
            wing.model
                .change_section(beam, |section| section.soften_torsion(-mean))?;
        }
        Ok(())
    }
}
