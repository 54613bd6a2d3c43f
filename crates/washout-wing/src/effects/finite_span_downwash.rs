//! Downwash of a wing of finite span in a straight stream, by Prandtl's lifting line.

use num_dual::Dual64;

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{CoefficientLaw, SectionAir};

/// See the module.
#[derive(Debug)]
pub struct FiniteSpanDownwash;

const CARD: Card = Card {
    name: "finite-span-downwash",
    family: "inflow",
    summary: "In a straight stream the wing flies in the downwash of its own trailing vortices, the more the shorter it is and the nearer the tip.",
    formula: "α' = α − φ, φ = s k(r) C_L(α − φ), U' = U; k: downwash over lift coefficient of the untwisted wing, Σ A_n sin nθ (n μ + sin θ) = μ sin θ, μ = \
              c a₀/(4b), a₀ = 2π, k = φ₁/(a₀ (1 − φ₁)), φ₁ = Σ n A_n sin nθ / sin θ; k = 1/(π A) all along an ellipse, so that \
              a = a₀/(1 + a₀/(π A)) there",
    source: "Prandtl 1918, Tragflügeltheorie; series: Glauert 1926, The Elements of Aerofoil and Airscrew Theory, ch. XI; slope: Anderson, Fundamentals of \
             Aerodynamics, §5.3; downwash by the local lift: modified strip theory, Yates 1958, NACA RM L57L10",
    when_right: "section coefficients (thin airfoil, tables of airfoils) on a wing in a tunnel; near 0 where the lift slope is stated for the finite wing \
                 already. Twist and deflection at two root angles and two speeds show it: it takes a share of the lift that is the same at each, \
                 most of it near the tip, where a softer rod or thinner air take it in proportion everywhere",
    gets_wrong: "of twist it knows the local lift only: with a tip washed out by 60 % of the root's angle at aspect ratio 8 the lift is right to \
                 0.2 %, the root moment 4 % low; sweep; aspect ratios below about 3; stall; tunnel walls other than that at the root",
    case: "an_elliptic_wing_in_a_stream_has_the_lift_slope_of_prandtl",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the downwash: 1 is that of the lifting line",
            default: 0.0,
            range: [0.0, 2.0],
            plausible: [0.0, 1.2],
        },
        Parameter {
            name: "wall",
            unit: "1",
            meaning: "1: the root stands on a wall, in which the wing is mirrored; 0: air flows around the root as around the tip",
            default: 1.0,
            range: [0.0, 1.0],
            plausible: [0.0, 1.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Stream],
    has_switch: false,
};

impl Effect for FiniteSpanDownwash {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &["steady.speed_m_s=8.0", "steady.root_angle_deg=10.0"]
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        let Some([on_wall, free]) = place.lifting_lines else {
            return;
        };
        let wall = values.at(1);
        let per_lift =
            wall * on_wall.downwash_per_lift(place.r_m) + (1.0 - wall) * free.downwash_per_lift(place.r_m);
        air.alpha -= downwash(&place.law.coefficients, values.strength() * per_lift, air.alpha);
    }
}

/// φ of φ = k C_L(α − φ) with its derivatives, of the sign of α; 0 from 90 deg on and where the law does not lift.
fn downwash(law: &CoefficientLaw, per_lift: f64, alpha: Dual) -> Dual {
    if alpha.re < 0.0 {
        return -downwash(law, per_lift, -alpha);
    }
    let excess = |angle: f64| angle - per_lift * law.lift_and_drag(alpha.re - angle).0;
    let (mut low, mut high) = (0.0, alpha.re);
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
    let gradient = 1.0 + per_lift * slope;
    let excess = -law.lift_and_drag(alpha - angle).0 * per_lift + angle;
    if gradient > 0.0 {
        -excess / gradient + angle
    } else {
        Dual::from(angle)
    }
}
