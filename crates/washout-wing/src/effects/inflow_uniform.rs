//! Downwash of the same speed everywhere, from the mean lift over the area that the wing sweeps.

use num_dual::DualNum;

use super::card::{Card, Need, Parameter, Places, Seam, WING_CHANNELS};
use super::inflow_momentum::{AREA_EXPONENT, SWEPT_OR_FIXED, sector_rad};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{Flow, SectionAir};

/// See the module.
#[derive(Debug)]
pub struct InflowUniform;

const CARD: Card = Card {
    name: "inflow-uniform",
    family: "inflow",
    summary: "The wing flies in its own downwash, taken as one speed over the whole swept area.",
    formula: "w = s √(L/(2ρA)), L = ¼ρ C_L(α_root) Ω² c̄ ((R+r₀)³ − r₀³)/3, A = Φₙ ((R+r₀)² − r₀²), Φₙ = Φⁿ (π/4)¹⁻ⁿ, α' = α − atan(w/U), U'² = U² + w²",
    source: "Rankine-Froude momentum theory of the partial actuator disc; Ellington 1984, part V",
    when_right: "a quick estimate where the spread of the lift along the span is unknown; prefer inflow-momentum elsewhere",
    gets_wrong: "inflow that follows the local lift; coefficients measured on a revolving wing contain its inflow already, so that a strength near 0 is right with Dickinson's law in hover",
    case: "uniform_downwash_of_an_actuator_disc",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the ideal downwash: 1 is Rankine and Froude's",
            default: 0.0,
            range: [0.0, 2.0],
            plausible: [0.0, 1.2],
        },
        AREA_EXPONENT,
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

impl Effect for InflowUniform {
    fn card(&self) -> Card<'_> {
        CARD
    }

    // the shape of the downwash along the span is that of no wing: two models of one wing differ by a tenth in what it makes.
    fn own_error(&self) -> f64 {
        0.1
    }

    fn places(&self) -> Option<Places> {
        Some(SWEPT_OR_FIXED)
    }

    fn depends_on_stroke(&self) -> bool {
        true
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        let Some(Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            root_offset_m,
            ..
        }) = place.flow
        else {
            return;
        };
        let (cl, _) = place.law.coefficients.lift_and_drag(place.root_angle_rad);
        let rate = std::f64::consts::TAU * frequency_hz * half_amplitude_rad;
        let (inner, outer) = (*root_offset_m, place.tip_m + root_offset_m);
        // mean lift over density, m⁴/s², and swept area, m²
        let lift = 0.25 * cl * rate * rate * place.mean_chord_m * (outer.powi(3) - inner.powi(3)) / 3.0;
        let area = sector_rad(*half_amplitude_rad, values) * (outer * outer - inner * inner);
        if lift > 0.0 && area > 0.0 && air.speed_squared.re > 0.0 {
            let ratio = air.speed_squared.sqrt().recip() * (values.strength() * (lift / (2.0 * area)).sqrt());
            air.alpha -= ratio.atan();
            air.speed_squared *= ratio * ratio + 1.0;
        }
    }
}
