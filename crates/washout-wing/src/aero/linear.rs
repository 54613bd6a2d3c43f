//! The air force on a strip in linear kinematics: small turns about the undeformed wing.
//!
//! The force keeps the rest directions (normal ẑ, chord ŷ) and the speed of the rest section; only the angle of
//! attack follows the shape, to first order. With the chord at rest c ŷ moved to c ŷ + Δ and the leading edge at
//! rest x̂ turned to x̂ + s, the unit vectors change by δĉ = (Δ_x, 0, Δ_z)/c and δn̂ = (−s_z, −Δ_z/c, 0), so with
//! α₀ = atan2(V_z, V_y) and U² = V_y² + V_z²
//!
//! α = α₀ − Δ_z/c − (V_x/U) (s_z cos α₀ + (Δ_x/c) sin α₀):
//!
//! twist θ = Δ_z/c washes out one to one, and on a swept-aft wing (V_x > 0) upward bending s_z washes out too.
//!
//! For the named coefficient laws the normal force is ½ρU²c (C_L cos α + C_D sin α) as at large rotation. The
//! thin airfoil is itself a small-angle law: there C_N = C_L = slope · α exactly and no chordwise force, since
//! cos α − 1 and the suction slope · α² are of second order. Uniform wing, dynamic pressure q, centre of pressure a
//! distance e ahead of the elastic axis: the washout moment per length is −q c e · slope · (α₀ − θ), so
//! GJ θ″ = q c e · slope · (α₀ − θ) exactly, which diverges at q_D = (π/2L)² GJ/(e c · slope).

use nalgebra::Vector3;

use super::coefficients::CoefficientLaw;
use super::law::AirLaw;
use super::number::Number;
use super::strip::{SectionAir, SectionChange, StripForce};

/// Angle of attack to first order in the shape, rad: `velocity` of the air in m/s, `chord` the moved chord vector
/// in m, `span` the leading-edge tangent per unit rest length, wing frame at rest, `chord_rest_m` along ŷ.
///
/// Still air and a chord of zero length give 0.
pub fn alpha_linear<D: Number>(
    velocity: &Vector3<f64>,
    chord: &Vector3<D>,
    span: &Vector3<D>,
    chord_rest_m: f64,
) -> D {
    let speed = velocity.y.hypot(velocity.z);
    if speed == 0.0 || chord_rest_m == 0.0 {
        return D::from(0.0);
    }
    let (sin, cos) = (velocity.z / speed, velocity.y / speed);
    let outward = velocity.x / speed;
    -chord.z / chord_rest_m - span.z * (outward * cos) - chord.x * (outward * sin / chord_rest_m)
        + velocity.z.atan2(velocity.y)
}

/// The force on a strip at the angle of attack `alpha` (rad) in linear kinematics, per length; `velocity` of the
/// air in m/s, wing frame at rest; `change`: what acts besides the laws.
pub fn strip_force_linear<D: Number>(
    law: &AirLaw,
    velocity: &Vector3<f64>,
    alpha: D,
    chord_rest_m: f64,
    change: &impl SectionChange<D>,
) -> StripForce<D> {
    let (zero, one) = (D::from(0.0), D::from(1.0));
    let mut air = SectionAir {
        alpha,
        speed_squared: D::from(velocity.y * velocity.y + velocity.z * velocity.z),
        normal: Vector3::new(zero, zero, one),
        chord: Vector3::new(zero, one, zero),
    };
    let now = law.section(&mut air, change);
    let mut force = air.force(law.density_kg_m3, chord_rest_m, &now);
    if matches!(law.coefficients, CoefficientLaw::ThinAirfoil { .. }) {
        force.normal_n_per_m =
            air.speed_squared * (0.5 * law.density_kg_m3 * chord_rest_m) * now.cl + now.normal_n_per_m;
        force.tangential_n_per_m = zero;
        force.force_n_per_m = air.normal * force.normal_n_per_m;
    }
    force
}

#[cfg(test)]
mod tests {
    use super::{alpha_linear, strip_force_linear};
    use crate::aero::centre_of_pressure::CentreOfPressureLaw;
    use crate::aero::coefficients::CoefficientLaw;
    use crate::aero::law::AirLaw;
    use crate::aero::strip::{section_air, strip_force};
    use nalgebra::Vector3;
    use num_dual::Dual64;

    fn law(coefficients: CoefficientLaw) -> AirLaw {
        AirLaw {
            density_kg_m3: 1.225,
            coefficients,
            centre_of_pressure: CentreOfPressureLaw::Fixed { fraction: 0.25 },
        }
    }

    #[test]
    fn alpha_is_the_tangent_of_the_exact_angle_at_rest() {
        // Any small shape, with sweep: compare with the exact section at a size where squares vanish.
        let velocity = Vector3::new(3.0, 20.0, 6.0);
        let (chord_shift, span_shift) = (Vector3::new(0.3, -0.2, 0.5), Vector3::new(0.1, 0.4, -0.6));
        let chord_m = 0.2;
        let slope_of = |size: Dual64| {
            let lift = |vector: Vector3<f64>| vector.map(Dual64::from);
            let chord = lift(Vector3::y() * chord_m) + lift(chord_shift * chord_m) * size;
            let span = lift(Vector3::x()) + lift(span_shift) * size;
            (
                section_air(&lift(velocity), &chord, &span).alpha,
                alpha_linear(&velocity, &chord, &span, chord_m),
            )
        };
        let (exact, linear) = slope_of(Dual64::new(0.0, 1.0));
        assert!((exact.re - linear.re).abs() < 1e-14);
        assert!(
            (exact.eps - linear.eps).abs() < 1e-14,
            "{} {}",
            exact.eps,
            linear.eps
        );
    }

    #[test]
    fn upward_bending_of_a_swept_aft_wing_washes_out() {
        let velocity = Vector3::new(5.0, 20.0, 1.0);
        let bent = Vector3::new(1.0, 0.0, 0.1);
        let chord = Vector3::new(0.0, 0.2, 0.0);
        let straight = alpha_linear(&velocity, &chord, &Vector3::x(), 0.2);
        assert!(alpha_linear(&velocity, &chord, &bent, 0.2) < straight);
        let twisted = Vector3::new(0.0, 0.2, 0.2 * 0.01);
        let washed: f64 = straight - alpha_linear(&velocity, &twisted, &Vector3::x(), 0.2);
        assert!((washed - 0.01).abs() < 1e-15);
    }

    #[test]
    fn thin_airfoil_gives_exactly_the_slope_and_no_chordwise_force() {
        let law = law(CoefficientLaw::ThinAirfoil {
            lift_slope_per_rad: std::f64::consts::TAU,
        });
        let velocity = Vector3::new(0.0, 20.0, 0.0);
        let force = strip_force_linear(&law, &velocity, 0.3, 0.2, &());
        let expected = 0.5 * 1.225 * 400.0 * 0.2 * std::f64::consts::TAU * 0.3;
        assert!((force.normal_n_per_m - expected).abs() < 1e-12 * expected);
        assert_eq!(force.tangential_n_per_m, 0.0);
        assert_eq!(force.force_n_per_m, Vector3::new(0.0, 0.0, force.normal_n_per_m));
    }

    #[test]
    fn at_rest_the_named_laws_give_the_force_of_large_rotation() {
        let velocity = Vector3::new(0.0, 6.0, 6.0);
        let chord = Vector3::new(0.0, 0.02, 0.0);
        let law = law(CoefficientLaw::Dickinson);
        let exact = strip_force(&law, &velocity, &chord, &Vector3::x(), 0.02, &());
        let alpha = alpha_linear(&velocity, &chord, &Vector3::x(), 0.02);
        let linear = strip_force_linear(&law, &velocity, alpha, 0.02, &());
        assert!((exact.force_n_per_m - linear.force_n_per_m).norm() < 1e-13);
        assert!((exact.speed - linear.speed).abs() < 1e-13);
    }

    #[test]
    fn still_air_gives_no_force_and_no_nan() {
        let still = Vector3::zeros();
        let alpha = alpha_linear(&still, &Vector3::new(0.0, 0.02, 0.0), &Vector3::x(), 0.02);
        let force = strip_force_linear(
            &law(CoefficientLaw::Dickinson),
            &still,
            Dual64::new(alpha, 1.0),
            0.02,
            &(),
        );
        assert_eq!(force.force_n_per_m.map(|part| part.re), Vector3::zeros());
        assert!(force.speed.eps.is_finite());
    }

    /// Washout θ (rad) at the tip of a uniform cantilever under its strips: GJ θ″ = −m with the moment of the normal
    /// force about an axis 0.05 m behind its centre, by Runge-Kutta from the root and shooting on θ′ there.
    fn tip_washout_rad(speed_m_s: f64, alpha_rad: f64) -> f64 {
        let law = law(CoefficientLaw::ThinAirfoil {
            lift_slope_per_rad: std::f64::consts::TAU,
        });
        let velocity = Vector3::new(0.0, speed_m_s * alpha_rad.cos(), speed_m_s * alpha_rad.sin());
        let bend = |twist: f64| {
            let chord = Vector3::new(0.0, 0.2, 0.2 * twist);
            let alpha = alpha_linear(&velocity, &chord, &Vector3::x(), 0.2);
            0.05 * strip_force_linear(&law, &velocity, alpha, 0.2, &()).normal_n_per_m / 10.0
        };
        let shoot = |rate: f64| {
            let (mut y, h) = ([0.0, rate], 1e-3);
            for _ in 0..1000 {
                let slope = |y: [f64; 2]| [y[1], bend(y[0])];
                let step = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
                let k1 = slope(y);
                let k2 = slope(step(k1, h / 2.0));
                let k3 = slope(step(k2, h / 2.0));
                let k4 = slope(step(k3, h));
                y = [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            }
            y
        };
        let (start, unit) = (shoot(0.0), shoot(1.0));
        let rate = -start[1] / (unit[1] - start[1]);
        start[0] + rate * (unit[0] - start[0])
    }

    #[test]
    fn a_uniform_wing_follows_the_closed_form_toward_divergence() {
        // GJ = 10 N·m², L = 1 m, c = 0.2 m, e = 0.05 m, slope 2π, 1.225 kg/m³: q_D = 392.699 Pa (Bisplinghoff);
        // twist at the tip over the root angle (nose up, so washout is negative).
        for (share, expected) in [(0.1, 0.137468), (0.5, 1.252172), (0.9, 11.419148)] {
            let speed_m_s = (2.0 * share * 392.699 / 1.225_f64).sqrt();
            let ratio = -tip_washout_rad(speed_m_s, 0.01) / 0.01;
            assert!((ratio / expected - 1.0).abs() < 5e-5, "{share}: {ratio}");
        }
    }
}
