//! Downwash from the balance of lift and momentum in each ring that the wing sweeps (blade-element momentum theory).

use num_dual::{Dual64, DualNum};

use super::card::{Card, Need, Parameter, Places, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{CoefficientLaw, Flow, SectionAir};

/// See the module.
#[derive(Debug)]
pub struct InflowMomentum;

const CARD: Card = Card {
    name: "inflow-momentum",
    family: "inflow",
    summary: "The wing flies in its own downwash, in each ring as strong as the lift there demands.",
    formula: "tan φ = s √(σ C_L(α − φ)), σ = c / (16 Φₙ r'), r' = r + r₀, Φₙ = Φⁿ (π/4)¹⁻ⁿ; α' = α − φ, U'² = U² (1 + tan²φ). From 2ρw²·2Φr' = ½ρ c C_L ⟨U²⟩, ⟨U²⟩ = ½U²",
    source: "Rankine-Froude momentum theory per ring: Leishman 2006, Principles of Helicopter Aerodynamics, §3.3 (there λ = σa/16 (√(1 + 32θr/σa) − 1)), with the rings of Ellington 1984, part V",
    when_right: "hover with coefficients of wing sections in a straight stream; prefer it to inflow-uniform, whose downwash does not follow the local lift",
    gets_wrong: "coefficients measured on a revolving wing contain its inflow already, so that a strength near 0 is right with Dickinson's law in hover; forward flight; angles beyond 90 deg are left alone",
    case: "momentum_balances_lift_in_every_ring",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "downwash over the ideal one: 1 is Rankine and Froude's, 1.1 to 1.2 with losses",
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

/// Half-angle of the sector of air that carries the lift where it does not follow the stroke. Assumed: the middle of the amplitudes that flapping
/// wings have; a strength stands for any other width.
const FIXED_RAD: f64 = std::f64::consts::FRAC_PI_4;
/// How the area of the air that carries the lift follows the stroke.
pub(super) const AREA_EXPONENT: Parameter = Parameter {
    name: "area_exponent",
    unit: "1",
    meaning: "n, how the area of the air that carries the lift follows the stroke: 1 is the sector that the wing sweeps (Ellington 1984, part V); \
              0 is a sector of 45 deg to either side whatever the stroke, as the disc of a rotor (Leishman 2006, §2.2: its inflow ratio is √(C_T/2)), so that the downwash is the same share of the \
              tip speed at every amplitude",
    default: 1.0,
    range: [0.0, 1.0],
    plausible: [0.0, 1.0],
};
/// Which of the two a wing follows is not known: how wide its wake is was not measured.
pub(super) const SWEPT_OR_FIXED: Places = Places {
    parameter: 1,
    at: &[1.0, 0.0],
    reach: 0.25,
    spar: None,
    of_one_wing: false,
};

/// Half-angle of the sector of air that carries the lift, rad.
pub(super) fn sector_rad(half_amplitude_rad: f64, values: &Values) -> f64 {
    FIXED_RAD * (half_amplitude_rad / FIXED_RAD).powf(values.at(1))
}

impl Effect for InflowMomentum {
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
            half_amplitude_rad,
            root_offset_m,
            phase_rad,
            ..
        }) = place.flow
        else {
            return;
        };
        let ring_m = 16.0
            * sector_rad(*half_amplitude_rad, values)
            * (place.r_m + root_offset_m)
            * phase_rad.cos().powi(2);
        if ring_m <= 1e-9 * place.chord_m {
            return;
        }
        let solidity = place.chord_m / ring_m * values.strength().powi(2);
        let angle = inflow_angle(&place.law.coefficients, solidity, air.alpha);
        air.alpha -= angle;
        air.speed_squared *= angle.tan().powi(2) + 1.0;
    }
}

/// φ of tan²φ = σ C_L(α − φ) with its derivatives, of the sign of α; 0 from 90 deg on and where the law does not lift.
fn inflow_angle(law: &CoefficientLaw, solidity: f64, alpha: Dual) -> Dual {
    if alpha.re < 0.0 {
        return -inflow_angle(law, solidity, -alpha);
    }
    let (mut low, mut high) = (0.0, alpha.re);
    let excess = |angle: f64| angle.tan().powi(2) - solidity * law.lift_and_drag(alpha.re - angle).0;
    if alpha.re >= std::f64::consts::FRAC_PI_2 || excess(low) > 0.0 {
        return Dual::from(0.0);
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if excess(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    let angle = 0.5 * (low + high);
    // one step of Newton's method with the derivatives of α: exact to first order
    let slope = law.lift_and_drag(Dual64::new(alpha.re - angle, 1.0)).0.eps;
    let gradient = 2.0 * angle.tan() / angle.cos().powi(2) + solidity * slope;
    let excess = -law.lift_and_drag(alpha - angle).0 * solidity + angle.tan().powi(2);
    if gradient.abs() > 0.0 {
        -excess / gradient + angle
    } else {
        Dual::from(angle)
    }
}
