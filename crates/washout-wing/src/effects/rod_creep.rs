//! A rod whose resin creeps: the longer a load lasts, the further it twists.

use super::card::{Card, Parameter, STRUCTURE_CHANNELS, Seam};
use super::{Effect, Structure, Values};
use crate::structure::StructureError;

/// See the module.
#[derive(Debug)]
pub struct RodCreep;

const CARD: Card = Card {
    name: "rod-creep",
    family: "rod-torsion",
    summary: "The resin of the rod creeps, so that it twists further under a load that lasts than under one that comes and goes.",
    formula: "GJ' = GJ / (1 + s (t/t₁)^n), t = 1/(2πf) where the wing flaps, t₁ = 100 s on the bench and in a steady stream, where the load is held",
    source: "Findley, Lai & Onaran 1976, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 3: power law of the creep compliance, n = 0.1 to 0.3 for \
             resins in shear",
    when_right: "bench and wind readings beside flapping ones: the bench twists further than flapping says by 1 + s to 1 + 0.15 s at 20 Hz with n = 0.2. \
                 Among flapping conditions alone, or steady ones alone, it is rod-shear-modulus by another name, which is of its family",
    gets_wrong: "bending, in which the fibres hardly creep; loads held for other times than 100 s, for which s is the share at 100 s times (t/100 s)^n; \
                 the mean load of a stroke that is not symmetric; frequencies of modes, for which it takes the time of the load",
    case: "a_rod_that_creeps_twists_further_the_longer_the_load_lasts",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "torsional compliance added after 100 s, over that of the rod",
            default: 0.0,
            range: [0.0, 5.0],
            plausible: [0.0, 0.3],
        },
        Parameter {
            name: "exponent",
            unit: "1",
            meaning: "exponent n of the time",
            default: 0.2,
            range: [0.01, 1.0],
            plausible: [0.1, 0.3],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[],
    has_switch: false,
};

/// How long a load is held, s.
const HELD_S: f64 = 100.0;

impl Effect for RodCreep {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let lasts_s = (wing.design.flapping.as_ref()).map_or(HELD_S, |flapping| {
            let rate_rad_s = std::f64::consts::TAU * flapping.frequency_hz.value();
            (1.0 / rate_rad_s).min(HELD_S)
        });
        let softer = values.strength() * (lasts_s / HELD_S).powf(values.at(1));
        for (beam, _) in wing.rod_elements() {
            wing.model
                .change_section(beam, |section| section.soften_torsion(softer))?;
        }
        Ok(())
    }
}
