//! A film that is longer than its frame: it hangs loose until it is stretched.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::structure::{Compression, StructureError};

/// See the module.
#[derive(Debug)]
pub struct FilmSlack;

const CARD: Card = Card {
    name: "film-slack",
    family: "film-tension",
    summary: "The film is longer than its frame, so that it billows freely before it carries.",
    formula: "ε' = ε − s in both directions: a negative eigenstrain of the tension field",
    source: "relaxed tension field with eigenstrain (Pipkin 1986); Kapton grows by 0.2 % from dry to humid (DuPont data sheet) and 0.3 % by creep",
    when_right: "a film laid on loose, swollen or crept; prefer film-cure-tension for one that was cured hot",
    gets_wrong: "wrinkles as rest shape (the flat film stands for all of them), and slack in one direction only",
    case: "a_slack_film_carries_the_strain_beyond_its_slack",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "strain by which the film is longer than its frame",
        default: 0.0,
        range: [0.0, 0.1],
        plausible: [0.0, 0.005],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::WrinklingFilm],
    has_switch: true,
};

impl Effect for FilmSlack {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // assumed, as for a film under tension, whose bays decide
    fn own_error(&self) -> f64 {
        0.5
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        wing.model.change_sheets(|sheet| {
            if let Compression::TensionField { slack, .. } = &mut sheet.compression {
                *slack += values.strength();
            }
        })
    }
}
