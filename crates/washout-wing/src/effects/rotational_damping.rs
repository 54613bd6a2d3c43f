//! Drag of a section against its own turning, with the square of the rate.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct RotationalDamping;

const CARD: Card = Card {
    name: "rotational-damping",
    family: "unsteady",
    summary: "The chord sweeps through air as it turns about the rod, which resists with the square of the rate.",
    formula: "dM = −s ½ρ C_rd θ̇|θ̇| ∫ y³ dy = −s ½ρ C_rd θ̇|θ̇| c⁴/4, force likewise with c³/3; C_rd = 5; θ̇ from the periodic motion at the phase of the design",
    source: "Whitney & Wood 2010, J. Fluid Mech. 660, 197 (C_rd = 5)",
    when_right: "fast turning against a slow stream: near the reversals",
    gets_wrong: "turning within a fast stream, where the cross terms are rotational-lift; the rates are frozen: they come from the periodic motion of the wing without this effect",
    case: "turning_sections_are_damped_by_the_square_of_the_rate",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the damping of Whitney and Wood: 1 is all of it",
            default: 0.0,
            range: [-1.0, 5.0],
            plausible: [0.0, 1.5],
        },
        Parameter {
            name: "coefficient",
            unit: "1",
            meaning: "C_rd",
            default: 5.0,
            range: [0.0, 20.0],
            plausible: [2.0, 8.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Motion],
    has_switch: false,
};

impl Effect for RotationalDamping {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        _air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let rate = place.twist_rate_rad_s();
        let square = 0.5 * place.density_kg_m3 * values.at(1) * rate * rate.abs() * values.strength();
        let force = square * place.chord_m.powi(3) / 3.0;
        let moment = square * place.chord_m.powi(4) / 4.0;
        now.normal_n_per_m -= force;
        now.moment_n += now.centre_of_pressure * (force * place.chord_m) - moment;
    }
}
