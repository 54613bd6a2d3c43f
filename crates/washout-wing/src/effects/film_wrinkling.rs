//! A film that gives way in wrinkles instead of carrying compression.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::structure::{Compression, StructureError};

/// Share of compression that a tension field keeps, for the solver's sake.
const KEPT: f64 = 1e-4;

/// See the module.
#[derive(Debug)]
pub struct FilmWrinkling;

const CARD: Card = Card {
    name: "film-wrinkling",
    family: "film-compression",
    summary: "The film wrinkles where it is compressed, finer than the mesh, and carries nothing across its wrinkles.",
    formula: "share of compression kept: k' = (1 − s) k + s 1e-4; s = 1 is the relaxed tension field",
    source: "Reissner 1938; Pipkin 1986, IMA J. Appl. Math. 36, 85",
    when_right: "films of a few micrometres, which buckle at 1e-8 of the load; a model that lets them carry compression is too stiff",
    gets_wrong: "the amplitude and the bending stiffness of the wrinkles; between 0 and 1 it is a path from one film to the other",
    case: "a_sheared_film_that_wrinkles_keeps_half_of_its_stiffness_times_one_plus_nu",
    seam: Seam::Structure,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share of the compression that is given up: 1 is the tension field",
        default: 0.0,
        range: [0.0, 1.0],
        plausible: [0.0, 1.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::CarryingFilm],
    has_switch: false,
};

impl Effect for FilmWrinkling {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &["film.compression=\"carries\""]
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let share = values.strength();
        wing.model.change_sheets(|sheet| {
            if let Compression::TensionField { residual, .. } = &mut sheet.compression {
                *residual = (1.0 - share) * *residual + share * KEPT;
            }
        })
    }
}
