//! Camber of the film between its spars, as an airfoil would feel it: more lift, and a load at half the chord.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};
use num_dual::DualNum;

/// See the module.
#[derive(Debug)]
pub struct FilmCamber;

const CARD: Card = Card {
    name: "film-camber",
    family: "camber",
    summary: "The film bulges into the suction side, which adds lift that acts at half of the chord.",
    formula: "ΔC_L = 4π h cos²α at half the chord (h = s: height of the parabolic bulge over the chord)",
    source: "Glauert 1926, thin-airfoil theory of the parabolic camber line (C_L = 4π h at α = 0, load symmetric fore and aft); cos²α as in the attached part of Polhamus 1966, NASA TN D-3767",
    when_right: "bulging bays of film at small to moderate angles; shape of the bulge as measured or as the film model gives it",
    gets_wrong: "separated flow at large angles, where camber matters less than the formula says; the bulge does not depend on the load",
    case: "camber_adds_lift_at_half_the_chord",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "height of the bulge over the chord, positive toward the suction side",
        default: 0.0,
        range: [-0.2, 0.2],
        plausible: [-0.05, 0.08],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flow],
    has_switch: false,
};

impl Effect for FilmCamber {
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
        let gain = (air.alpha.cos()).powi(2) * (2.0 * std::f64::consts::TAU * values.strength());
        let load = air.speed_squared * (0.5 * place.density_kg_m3 * place.chord_m * place.chord_m);
        now.moment_n += load * gain * air.alpha.cos() * (-now.centre_of_pressure + 0.5);
        now.cl += gain;
    }
}
