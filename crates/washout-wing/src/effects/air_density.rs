//! Air denser or thinner than the design says: weather, altitude, another gas.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct AirDensity;

const CARD: Card = Card {
    name: "air-density",
    family: "air-density",
    summary: "The air is denser or thinner than the design says, and its quasi-steady forces with it.",
    formula: "ρ' = (1 + s) ρ",
    source: "ideal gas: ρ = p / (R T) with R = 287 J/(kg K); 1.20 kg/m³ at 20 °C at sea level; −1 % for 3 K, −1.2 % for 100 m: −17 % at 1600 m, −24 % at 2300 m",
    when_right: "pressure and temperature of the test are not reported. A barometer shows it; in a campaign only readings with air beside readings without (bench) do",
    gets_wrong: "the mass of the moved air, which stays; within the quasi-steady load it cannot be told from coefficient-scale",
    case: "denser_air_scales_force_and_moment",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share by which the density grows",
        default: 0.0,
        range: [-1.0, 10.0],
        plausible: [-0.25, 0.05],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for AirDensity {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn is_error_of(&self) -> Option<&'static str> {
        Some("air.density_kg_m3")
    }

    fn coefficients(
        &self,
        values: &Values,
        _place: &StripPlace,
        _air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let factor = 1.0 + values.strength();
        now.cl *= factor;
        now.cd *= factor;
        now.normal_n_per_m *= factor;
        now.moment_n *= factor;
    }
}
