//! A strip of prepreg along the leading edge that works with the rod.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::section::BeamMaterial;
use crate::structure::{Section, StructureError};

/// Thickness of a ply, m.
const PLY_M: f64 = 40e-6;

/// M60J with epoxy at 60 % of fibre, along the fibre.
const PREPREG: BeamMaterial = BeamMaterial {
    e_pa: 354e9,
    g_pa: 4.5e9,
    density_kg_m3: 1650.0,
};

/// See the module.
#[derive(Debug)]
pub struct LeadingEdgeFrame;

const CARD: Card = Card {
    name: "leading-edge-frame",
    family: "rod-stiffness",
    summary: "The prepreg frame runs along the leading edge too, and stiffens the rod that it is bonded to.",
    formula: "EA, GJ, EI' = EA, GJ, EI + s × those of a strip b × 40 µm n (E 354 GPa, G 4.5 GPa), mass likewise",
    source: "mixture rule for M60J at 60 % fibre; J of the rectangle by its series, Timoshenko & Goodier, torsion",
    when_right: "wings cut from one sheet of prepreg; it matters where the rod is thin",
    gets_wrong: "the strip lies with its middle on the rod's axis: no coupling by its offset",
    case: "a_frame_adds_its_own_stiffness_to_that_of_the_rod",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the strip that works: 1 is all of it",
            default: 0.0,
            range: [0.0, 10.0],
            plausible: [0.0, 2.0],
        },
        Parameter {
            name: "width_mm",
            unit: "mm",
            meaning: "width of the strip",
            default: 1.0,
            range: [0.01, 1000.0],
            plausible: [0.5, 3.0],
        },
        Parameter {
            name: "plies",
            unit: "1",
            meaning: "plies of 40 µm",
            default: 2.0,
            range: [0.5, 100.0],
            plausible: [1.0, 4.0],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::ShapedRod],
    has_switch: false,
};

impl Effect for LeadingEdgeFrame {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let (share, width_m, thickness_m) = (values.strength(), 1e-3 * values.at(1), PLY_M * values.at(2));
        let strip = Section::rectangle(width_m, thickness_m, &PREPREG);
        for (beam, _) in wing.rod_elements() {
            wing.model.change_section(beam, |section| {
                section.stiffen(
                    share * strip.axial_stiffness_n(),
                    share * strip.gj_n_m2(),
                    share * strip.ei_flap_n_m2(),
                    share * strip.ei_edge_n_m2(),
                );
                section.mass_kg_m += share * strip.mass_kg_m;
                section.inertia_kg_m += share * strip.inertia_kg_m;
            })?;
        }
        Ok(())
    }
}
