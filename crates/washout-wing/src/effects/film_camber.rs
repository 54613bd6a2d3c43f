//! Bulge of the film under its load, as an airfoil would feel it: more lift, which acts at half the chord.

use num_dual::DualNum;

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct FilmCamber;

const CARD: Card = Card {
    name: "film-camber",
    family: "camber",
    summary: "The film bulges away from its load, which adds lift that acts at half of the chord; the bulge grows with the load and turns with its sign.",
    formula: "ΔC_L = 4π h cos²α at half the chord, h = s ∛2 u / (1 + u²)^⅓: height of the parabolic bulge over the chord, u = p/p₁, p = ½ρU² (C_L cos α + C_D sin α)",
    source: "Glauert 1926, thin-airfoil theory of the parabolic camber line (C_L = 4π h at α = 0, load symmetric fore and aft); cos²α as in the attached part \
             of Polhamus 1966, NASA TN D-3767. Bulge: Song et al. 2008, AIAA J. 46, 2096, and Waldman & Breuer 2017, J. Fluids Struct. 68, 390: h = p c/(8 N), N \
             tension; taut film: N stays, h ∝ p; slack film: N = E t (8/3) h², h = (3 p c/(64 E t))^⅓; between them u/(1 + u²)^⅓",
    when_right: "bays of film at small to moderate angles. Twist and lift at one angle and several speeds show it: they grow faster than ½ρU² while \
                 the film is taut, and slower beyond; a coefficient that is too small does neither",
    gets_wrong: "separated flow at large angles, where camber matters less than the formula says; the lift that the bulge adds does not \
                 make it bulge further; one chord and one film for the whole wing, however its bays lie",
    case: "the_bulge_of_the_film_goes_with_its_load_and_turns_with_it",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "height of the bulge over the chord at the pressure p₁",
            default: 0.0,
            range: [0.0, 0.3],
            plausible: [0.0, 0.08],
        },
        Parameter {
            name: "pressure_pa",
            unit: "Pa",
            meaning: "pressure p₁, about which a taut film becomes one that stretches",
            default: 50.0,
            range: [1e-3, 1e6],
            plausible: [5.0, 500.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flow, Need::Film],
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
        let (sin, cos) = air.alpha.sin_cos();
        let stagnation = air.speed_squared * (0.5 * place.density_kg_m3);
        let relative = stagnation * (now.cl * cos + now.cd * sin) / values.at(1);
        let bulge = relative / (relative * relative + 1.0).cbrt() * (values.strength() * 2f64.cbrt());
        let gain = cos.powi(2) * bulge * (2.0 * std::f64::consts::TAU);
        let load = stagnation * (place.chord_m * place.chord_m);
        now.moment_n += load * gain * cos * (-now.centre_of_pressure + 0.5);
        now.cl += gain;
    }
}
