//! A film that is softer than its data sheet: warm, damp or creeping.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct FilmSoftening;

const CARD: Card = Card {
    name: "film-softening",
    family: "film-stiffness",
    summary: "The film stretches more than its data sheet says: heat, moisture and creep lower its modulus.",
    formula: "E' = E / (1 + s); the pre-tension stays",
    source: "DuPont Kapton HN data sheet: 2.5 GPa at 23 °C, 2.0 GPa at 200 °C",
    when_right: "the same film everywhere, at any load; it shows where the film's stretch, not the rod, sets the twist",
    gets_wrong: "creep that grows with time and with the stress of each place",
    case: "a_film_of_half_the_modulus_sags_by_the_cube_root_of_two_more",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "compliance added, over that of the film: 1 halves its modulus",
        default: 0.0,
        range: [-0.9, 50.0],
        plausible: [-0.2, 0.4],
    }],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Film],
    has_switch: false,
};

impl Effect for FilmSoftening {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        wing.model
            .change_sheets(|sheet| sheet.e_pa /= 1.0 + values.strength())
    }
}
