//! Lift of a section that turns while it moves: twisting up adds circulation, washing out takes it away.

use num_dual::DualNum;

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct RotationalLift;

const CARD: Card = Card {
    name: "rotational-lift",
    family: "unsteady",
    summary: "A section that washes out while it moves meets less load, one that turns back more, in proportion to the rate of turning.",
    formula: "ΔF_n = −s π (0.75 − x₀) ρ U c² θ̇ per length, spread like the pressure; θ̇ from the periodic motion at the phase of the design",
    source: "Sane & Dickinson 2002, J. Exp. Biol. 205, 1087, eq. 3 (C_rot = π(0.75 − x₀)); Fung 1955 for its origin",
    when_right: "twist is read while it changes: off mid-stroke, or with a lag of inertia at mid-stroke",
    gets_wrong: "angles beyond stall, where measured rotational coefficients fall with α; the rates are frozen: they come from the periodic motion of the wing without this effect",
    case: "turning_sections_carry_rotational_lift",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the force of Sane and Dickinson: 1 is all of it",
            default: 0.0,
            range: [-1.0, 5.0],
            plausible: [0.0, 1.2],
        },
        Parameter {
            name: "axis",
            unit: "1",
            meaning: "axis of rotation, fraction of the chord from the leading edge",
            default: 0.0,
            range: [0.0, 1.0],
            plausible: [0.0, 0.3],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Motion],
    has_switch: false,
};

impl Effect for RotationalLift {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let rate = place.twist_rate_rad_s();
        if air.speed_squared.re > 0.0 {
            let coefficient = std::f64::consts::PI * (0.75 - values.at(1));
            let load = coefficient * place.density_kg_m3 * place.chord_m * place.chord_m * rate;
            now.normal_n_per_m -= air.speed_squared.sqrt() * (load * values.strength());
        }
    }
}
