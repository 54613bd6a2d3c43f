//! A rod that has split along its length, so that its strips slide on each other.

use std::f64::consts::PI;

use super::card::{Card, Need, Parameter, Places, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::input::design::{Flat, Section};
use crate::mesh::BeamPart;
use crate::structure::StructureError;
use crate::structure::section::rectangle_torsion_factor;

/// See the module.
#[derive(Debug)]
pub struct RodSplit;

const CARD: Card = Card {
    name: "rod-split",
    family: "rod-damage",
    summary: "From a station on a solid rod is split along the wing's plane into strips that slide on each other, or two half-rods glued to one have debonded.",
    formula: "1/GJ' = (1 + k s) / GJ, 1/EI_flap' = (1 + m s) / EI_flap outboard of the station; s = (n² − 1)/3 for n strips; k, m: those of two halves, \
              1.640, 2.578 of a round rod, 2.007, 2.617 of a half-round flat in the wing's plane, 0.807, 2.578 of one across it, 4 β(b/t)/β(2b/t) − 1, 3 of a \
              rectangle b × t with J = β b t³",
    source: "St Venant torsion and Bernoulli bending of the parts, Timoshenko & Goodier, Theory of Elasticity, torsion (half circle: J = 0.2976 a⁴; \
             quarter: 0.0823 a⁴; slices of the half: finite differences). Many thin strips keep 1/n² of both: with 3, 4, 6 strips of a round rod \
             the law is 9, 16, 24 % too soft in torsion, 5, 7, 10 % in bending",
    when_right: "pultruded rods split along their fibres, glue lines between half-rods that failed. EA and edgewise bending stay: prefer \
                 rod-ends-early if they are lost too, and rod-torsion-loss if flapwise bending stays as well",
    gets_wrong: "friction between the strips; splits at another angle; tubes and sections that are given as stiffnesses, which it leaves alone",
    case: "a_split_rod_twists_by_the_ratio_of_two_halves_to_the_whole",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "compliance added, over that of two halves: 1 two strips, 2.7 three, 5 four",
            default: 0.0,
            range: [0.0, 12.0],
            plausible: [0.0, 2.7],
        },
        Parameter {
            name: "from",
            unit: "1",
            meaning: "station from which it is split, as a fraction of the rod's length",
            default: 0.5,
            range: [0.0, 1.0],
            plausible: [0.0, 0.95],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::SolidRod],
    has_switch: false,
};

impl Effect for RodSplit {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // an independent model answers with 1.24 of this where the film decides
    fn own_error(&self) -> f64 {
        0.15
    }

    fn places(&self) -> Option<Places> {
        Some(Places {
            parameter: 1,
            at: &[0.2, 0.4, 0.6, 0.8],
            reach: 0.1,
            spar: None,
            of_one_wing: true,
        })
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        for (beam, outboard) in wing.rod_between(values.at(1), 1.0) {
            let BeamPart::Rod(piece) = wing.mesh.beams[beam].part else {
                continue;
            };
            let Some([torsion, bending]) = wing.design.rod.get(piece).and_then(|rod| in_halves(&rod.section))
            else {
                continue;
            };
            let share = outboard * values.strength();
            wing.model.change_section(beam, |section| {
                section.soften_torsion(torsion * share);
                section.soften_bending(bending * share, 0.0);
            })?;
        }
        Ok(())
    }
}

/// What two sliding halves, cut along the wing's plane, add to the compliance of a section in torsion and in flapwise bending, over
/// its own; none of one that is no solid.
fn in_halves(section: &Section) -> Option<[f64; 2]> {
    // second moments of half a circle about its flat and about its centroid
    let (whole, half) = (PI / 8.0, PI / 8.0 - 8.0 / (9.0 * PI));
    match section {
        Section::Round { .. } => Some([PI / 2.0 / (PI - 8.0 / PI) - 1.0, whole / half - 1.0]),
        Section::HalfRound {
            flat: Flat::InPlane, ..
        } => Some([2.007, 2.617]),
        Section::HalfRound { .. } => Some([0.807, whole / half - 1.0]),
        Section::Rectangle {
            width_mm,
            thickness_mm,
        } => {
            let [width, thickness] = [width_mm.value(), thickness_mm.value()];
            let torsion = |width: f64, thickness: f64| {
                let (long, short) = (width.max(thickness), width.min(thickness));
                rectangle_torsion_factor(long / short) * long * short.powi(3)
            };
            let halves = 2.0 * torsion(width, 0.5 * thickness);
            Some([torsion(width, thickness) / halves - 1.0, 3.0])
        }
        Section::Laminate { .. } => Some([3.0, 3.0]),
        Section::Tube { .. } | Section::Given { .. } => None,
    }
}
