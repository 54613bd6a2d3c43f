//! Tension that cooling from the cure leaves in the film, beyond what the design states.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct FilmCureTension;

const CARD: Card = Card {
    name: "film-cure-tension",
    family: "film-tension",
    summary: "The film is tighter than the design says: prepreg and film were cured hot and cooled together.",
    formula: "N' = N + s, alike in all directions, as an eigenstrain; the unloaded cured shape is solved first and twist counts from it",
    source: "thermal mismatch: E t Δα ΔT / (1 − ν), up to 74 N/m for 6 µm of Kapton cooled by 160 K",
    when_right: "a film cured on its frame; prefer film-slack if it sags by hand at rest",
    gets_wrong: "viscous relief of the tension after cure, and its loss where spars buckle finer than the mesh",
    case: "a_film_in_tension_deflects_by_p_b_squared_over_8_n",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "N/m",
        meaning: "tension added, alike in all directions",
        default: 0.0,
        range: [0.0, 1000.0],
        plausible: [0.0, 74.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Film],
    has_switch: false,
};

impl Effect for FilmCureTension {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // two models of one wing differ by half (46 to 57 %) of what the tension makes, bay by bay
    fn own_error(&self) -> f64 {
        0.5
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        wing.model
            .change_sheets(|sheet| sheet.pretension_n_per_m += values.strength())
    }
}
