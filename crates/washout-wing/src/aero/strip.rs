//! The air force on one strip of the deformed wing, per length of span (quasi-steady blade element).

use nalgebra::Vector3;

use super::law::AirLaw;
use super::number::{Number, angle_of};

/// The air as a section of the deformed wing meets it.
///
/// The section plane is spanned by the unit chord ĉ (leading to trailing edge) and the unit normal n̂ = ŝ × ĉ,
/// with ŝ the leading-edge tangent made perpendicular to ĉ. Velocity along ŝ does no work on the section and is
/// left out (independence principle).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionAir<D> {
    /// Angle of attack, rad in (−π, π]: positive when the air comes from below (−z) and loads toward n̂.
    pub alpha: D,
    /// Square of the speed in the section plane, m²/s².
    pub speed_squared: D,
    /// Unit normal n̂, wing frame.
    pub normal: Vector3<D>,
    /// Unit chord ĉ, wing frame.
    pub chord: Vector3<D>,
}

/// Force on a strip, per length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripForce<D> {
    /// Angle of attack, rad.
    pub alpha: D,
    /// Speed in the section plane, m/s.
    pub speed: D,
    /// Lift coefficient.
    pub cl: D,
    /// Drag coefficient.
    pub cd: D,
    /// Centre of pressure, fraction of the chord from the leading edge.
    pub centre_of_pressure: D,
    /// Moment about the span besides that of the pressure, N·m/m, positive: washout.
    pub moment_n: D,
    /// Force along the unit normal, N/m.
    pub normal_n_per_m: D,
    /// Force along the unit chord toward the trailing edge, N/m.
    pub tangential_n_per_m: D,
    /// Unit normal, wing frame.
    pub normal: Vector3<D>,
    /// Unit chord from leading to trailing edge, wing frame.
    pub chord: Vector3<D>,
    /// Force vector, N/m, wing frame.
    pub force_n_per_m: Vector3<D>,
}

/// Coefficients of a section, and what acts on it besides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionCoefficients<D> {
    /// Lift coefficient.
    pub cl: D,
    /// Drag coefficient.
    pub cd: D,
    /// Centre of pressure, fraction of the chord from the leading edge.
    pub centre_of_pressure: D,
    /// Force along the normal that is added, N/m, spread like the pressure.
    pub normal_n_per_m: D,
    /// Moment about the span that is added, N·m/m, positive: washout.
    pub moment_n: D,
}

impl<D: Number> SectionCoefficients<D> {
    /// Takes a share of the force across the chord at the angle of attack `alpha` (rad); that along the chord stays.
    pub fn lose_normal_force(&mut self, alpha: D, share: f64) {
        let (sin, cos) = alpha.sin_cos();
        let lost = (self.cl * cos + self.cd * sin) * share;
        self.cl -= lost * cos;
        self.cd -= lost * sin;
    }
}

/// Physics besides the laws: may change how a section meets the air, and what the laws give for it.
pub trait SectionChange<D> {
    /// Changes angle and speed.
    fn flow(&self, air: &mut SectionAir<D>);

    /// Changes coefficients, or adds force and moment.
    fn coefficients(&self, air: &SectionAir<D>, now: &mut SectionCoefficients<D>);
}

/// Nothing besides.
impl<D> SectionChange<D> for () {
    fn flow(&self, _air: &mut SectionAir<D>) {}

    fn coefficients(&self, _air: &SectionAir<D>, _now: &mut SectionCoefficients<D>) {}
}

/// How a section meets the air: `velocity` of the air (m/s), `chord` from leading to trailing edge and `span`
/// tangent of the leading edge (any length), all in the wing frame at rest.
///
/// A chord or span of zero length, or a span along the chord, has no section: it meets no air.
pub fn section_air<D: Number>(velocity: &Vector3<D>, chord: &Vector3<D>, span: &Vector3<D>) -> SectionAir<D> {
    let zero = D::from(0.0);
    let across = span.cross(chord);
    // a square that is not a number is no zero, and goes on to be seen
    if chord.dot(chord).re() == 0.0 || across.dot(&across).re() == 0.0 {
        return SectionAir {
            alpha: zero,
            speed_squared: zero,
            normal: Vector3::new(zero, zero, D::from(1.0)),
            chord: Vector3::new(zero, D::from(1.0), zero),
        };
    }
    let chord = unit(chord);
    let normal = unit(&across);
    let along_normal = velocity.dot(&normal);
    let along_chord = velocity.dot(&chord);
    let speed_squared = along_normal * along_normal + along_chord * along_chord;
    let alpha = if speed_squared.re() == 0.0 {
        zero
    } else {
        angle_of(along_normal, along_chord)
    };
    SectionAir {
        alpha,
        speed_squared,
        normal,
        chord,
    }
}

/// The force of the air on a strip of rest chord `chord_rest_m` (m), for the arguments of [`section_air`].
///
/// Normal ½ρU²c (C_L cos α + C_D sin α), tangential ½ρU²c (C_D cos α − C_L sin α): lift across the stream,
/// drag along it. `change`: what acts besides the laws.
pub fn strip_force<D: Number>(
    law: &AirLaw,
    velocity: &Vector3<D>,
    chord: &Vector3<D>,
    span: &Vector3<D>,
    chord_rest_m: f64,
    change: &impl SectionChange<D>,
) -> StripForce<D> {
    let mut air = section_air(velocity, chord, span);
    let coefficients = law.section(&mut air, change);
    air.force(law.density_kg_m3, chord_rest_m, &coefficients)
}

impl AirLaw {
    /// What the laws give for a section, and `change` makes of it.
    pub fn section<D: Number>(
        &self,
        air: &mut SectionAir<D>,
        change: &impl SectionChange<D>,
    ) -> SectionCoefficients<D> {
        change.flow(air);
        let (cl, cd) = self.coefficients.lift_and_drag(air.alpha);
        let mut now = SectionCoefficients {
            cl,
            cd,
            centre_of_pressure: self.centre_of_pressure.fraction(air.alpha),
            normal_n_per_m: D::from(0.0),
            moment_n: D::from(0.0),
        };
        change.coefficients(air, &mut now);
        now
    }
}

impl<D: Number> SectionAir<D> {
    /// The force for given coefficients: what [`strip_force`] does after the laws.
    pub(super) fn force(
        &self,
        density_kg_m3: f64,
        chord_rest_m: f64,
        now: &SectionCoefficients<D>,
    ) -> StripForce<D> {
        let SectionCoefficients {
            cl,
            cd,
            centre_of_pressure,
            moment_n,
            ..
        } = *now;
        let load = self.speed_squared * (0.5 * density_kg_m3 * chord_rest_m);
        let (sin, cos) = self.alpha.sin_cos();
        let normal_n_per_m = load * (cl * cos + cd * sin) + now.normal_n_per_m;
        let tangential_n_per_m = load * (cd * cos - cl * sin);
        StripForce {
            alpha: self.alpha,
            speed: speed(self.speed_squared),
            cl,
            cd,
            centre_of_pressure,
            moment_n,
            normal_n_per_m,
            tangential_n_per_m,
            normal: self.normal,
            chord: self.chord,
            force_n_per_m: self.normal * normal_n_per_m + self.chord * tangential_n_per_m,
        }
    }
}

/// Square root that has a finite derivative in still air.
pub(super) fn speed<D: Number>(speed_squared: D) -> D {
    if speed_squared.re() <= 0.0 {
        D::from(0.0)
    } else {
        speed_squared.sqrt()
    }
}

fn unit<D: Number>(vector: &Vector3<D>) -> Vector3<D> {
    vector * vector.dot(vector).sqrt().recip()
}

#[cfg(test)]
mod tests {
    use super::{section_air, strip_force};
    use crate::aero::centre_of_pressure::CentreOfPressureLaw;
    use crate::aero::coefficients::CoefficientLaw;
    use crate::aero::law::AirLaw;
    use nalgebra::{SVector, Vector3};
    use num_dual::{Dual64, DualNum, DualSVec64};
    use proptest::prelude::{prop, prop_assume, proptest};

    fn law() -> AirLaw {
        AirLaw {
            density_kg_m3: 1.2,
            coefficients: CoefficientLaw::Dickinson,
            centre_of_pressure: CentreOfPressureLaw::Dickson,
        }
    }

    fn chord_at(twist_rad: f64) -> Vector3<f64> {
        Vector3::new(0.0, twist_rad.cos(), twist_rad.sin()) * 0.02
    }

    #[test]
    fn washout_reduces_the_angle_of_attack_one_to_one() {
        let velocity = Vector3::new(0.0, 45.0_f64.to_radians().cos(), 45.0_f64.to_radians().sin()) * 9.0;
        for degrees in [-10.0_f64, 0.0, 20.0, 44.5] {
            let strip = strip_force(
                &law(),
                &velocity,
                &chord_at(degrees.to_radians()),
                &Vector3::x(),
                0.02,
                &(),
            );
            assert!((strip.alpha.to_degrees() - (45.0 - degrees)).abs() < 1e-12);
            assert!((strip.speed - 9.0).abs() < 1e-12);
            assert!(strip.normal_n_per_m > 0.0);
        }
    }

    #[test]
    fn force_at_45_degrees_by_hand() {
        // ½ · 1.2 · 81 · 0.02 = 0.972 N/m; C_L 1.804561, C_D 1.703746; along and across the stream.
        let velocity = Vector3::new(0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt()) * 9.0;
        let strip = strip_force(&law(), &velocity, &chord_at(0.0), &Vector3::x(), 0.02, &());
        let stream = velocity / 9.0;
        let lift = Vector3::new(0.0, -stream.z, stream.y);
        assert!((strip.force_n_per_m.dot(&lift) - 0.972 * 1.804561).abs() < 1e-6);
        assert!((strip.force_n_per_m.dot(&stream) - 0.972 * 1.703746).abs() < 1e-6);
        assert!((strip.normal_n_per_m - 0.972 * (1.804561 + 1.703746) / 2.0_f64.sqrt()).abs() < 1e-6);
        assert!((strip.tangential_n_per_m - 0.972 * (1.703746 - 1.804561) / 2.0_f64.sqrt()).abs() < 1e-6);
        assert!((strip.centre_of_pressure - 0.255).abs() < 1e-14);
    }

    #[test]
    fn velocity_along_the_span_does_not_matter() {
        let (chord, span) = (chord_at(0.2), Vector3::new(1.0, 0.1, -0.2));
        let air = section_air(&Vector3::new(1.0, 5.0, 4.0), &chord, &span);
        let along = air.chord.cross(&air.normal);
        let more = section_air(&(Vector3::new(1.0, 5.0, 4.0) + along * 7.0), &chord, &span);
        assert!((air.alpha - more.alpha).abs() < 1e-14);
        assert!((air.speed_squared - more.speed_squared).abs() < 1e-12);
    }

    #[test]
    fn still_air_and_collapsed_sections_carry_nothing_and_give_no_nan() {
        let dual = |vector: Vector3<f64>| vector.map(|part| Dual64::new(part, 1.0));
        let (velocity, chord, span) = (Vector3::new(0.0, 5.0, 5.0), chord_at(0.1), Vector3::x());
        let nil = Vector3::zeros();
        for (v, c, s) in [
            (nil, chord, span),
            (velocity, nil, span),
            (velocity, chord, nil),
            (velocity, chord, chord),
        ] {
            let still = v.map(|part| Dual64::new(part, 0.0));
            let strip = strip_force(&law(), &still, &dual(c), &dual(s), 0.02, &());
            assert_eq!(strip.force_n_per_m.map(|part| part.re), nil);
            assert!(
                strip.force_n_per_m.iter().all(|part| part.eps.is_finite()) && strip.speed.eps.is_finite()
            );
        }
        let empty = section_air(&velocity, &Vector3::zeros(), &span);
        assert_eq!(empty.speed_squared, 0.0);
    }

    #[test]
    fn the_angle_turns_through_90_degrees_without_a_gap() {
        // The stream exactly along the normal, where a plain quotient has no derivative.
        let chord = Vector3::new(Dual64::from(0.0), Dual64::from(0.02), Dual64::new(0.0, 0.02));
        let span = Vector3::<f64>::x().map(Dual64::from);
        let velocity = Vector3::new(0.0, 0.0, 4.0).map(Dual64::from);
        let alpha = section_air(&velocity, &chord, &span).alpha;
        assert_eq!((alpha.re, alpha.eps), (std::f64::consts::FRAC_PI_2, -1.0));
    }

    /// Normal and tangential force and the force vector from one vector of velocity, chord and span.
    fn outputs<D: DualNum<Primitive = f64> + Copy>(x: &SVector<D, 9>) -> [D; 6] {
        let vector = |at: usize| Vector3::new(x[at], x[at + 1], x[at + 2]);
        let strip = strip_force(&law(), &vector(0), &vector(3), &vector(6), 0.02, &());
        let force = strip.force_n_per_m;
        [
            strip.normal_n_per_m,
            strip.tangential_n_per_m,
            strip.centre_of_pressure,
            force.x,
            force.y,
            force.z,
        ]
    }

    proptest! {
        #[test]
        fn dual_derivatives_equal_central_differences_at_random_shapes(
            spread in prop::array::uniform9(-0.4..0.4_f64),
            alpha in -3.1..3.1_f64,
        ) {
            let mut x = SVector::<f64, 9>::from_column_slice(&spread);
            x[1] += 6.0 * alpha.cos();
            x[2] += 6.0 * alpha.sin();
            for i in 3..6 {
                x[i] *= 0.02;
            }
            x[4] += 0.02;
            x[6] += 1.0;
            // Where the curvature of the laws jumps, at the ends of their joins, the difference is spoilt, not the derivative.
            let [velocity, chord, span] = [0, 3, 6].map(|at| Vector3::new(x[at], x[at + 1], x[at + 2]));
            let met = section_air(&velocity, &chord, &span).alpha.to_degrees().rem_euclid(90.0);
            prop_assume!([1.0, 89.0].iter().all(|join| (met - join).abs() > 0.01));
            let base = outputs(&x);
            let dual: SVector<DualSVec64<9>, 9> = SVector::from_fn(|i, _| {
                DualSVec64::<9>::from_re(x[i]).derivative(i)
            });
            let exact = outputs(&dual);
            for i in 0..9 {
                let step = if (3..6).contains(&i) { 2e-8 } else { 1e-6 };
                let (mut up, mut down) = (x, x);
                up[i] += step;
                down[i] -= step;
                let (up, down) = (outputs(&up), outputs(&down));
                for k in 0..6 {
                    let slope = (up[k] - down[k]) / (2.0 * step);
                    let given = exact[k].eps.unwrap_generic(nalgebra::Const::<9>, nalgebra::Const::<1>)[i];
                    assert!((given - slope).abs() < 1e-5 * (1.0 + slope.abs()), "d{k}/d{i}: {given} {slope}");
                }
            }
            assert!(base.iter().all(|value| value.is_finite()));
        }
    }
}
