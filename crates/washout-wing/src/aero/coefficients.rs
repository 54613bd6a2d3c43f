//! Lift and drag coefficients against the angle of attack, by name.
//!
//! α in rad, (−π, π]. C_L is odd and C_D even in α. Beyond 90° the flow meets the trailing edge first; a thin
//! plate is alike from both ends, so C_L(180° − α) = −C_L(α) and C_D(180° − α) = C_D(α). Where a fit would leave
//! a step or a kink at 0, 90 or 180°, the last degree is replaced by the cubic (C_L) or parabola (C_D) of the
//! right symmetry that joins in value and slope, so that both are continuous with their first derivative.

use std::f64::consts::PI;

use super::join::{SMOOTHING_RAD, even_join, odd_join};
use super::number::Number;
use super::table::CoefficientTable;

/// A law of lift and drag coefficients.
#[derive(Debug, Clone, PartialEq)]
pub enum CoefficientLaw {
    /// Dickinson, Lehmann & Sane 1999 (α in degrees): C_L = 0.225 + 1.58 sin(2.13 α − 7.20°),
    /// C_D = 1.92 − 1.55 cos(2.04 α − 9.82°); measured for 0 to 90°, continued by symmetry.
    Dickinson,
    /// Whitney & Wood 2010: C_L = 1.8 sin 2α, C_D = 1.9 − 1.5 cos 2α; these carry all symmetries.
    WhitneyWood,
    /// C_L = slope · α at any α, C_D = 0: meant for small angles; no stall and no symmetry about 90°.
    ThinAirfoil {
        /// Lift-curve slope, 1/rad.
        lift_slope_per_rad: f64,
    },
    /// Values from a file.
    Table(CoefficientTable),
}

impl CoefficientLaw {
    /// Lift and drag coefficient at the angle of attack `alpha`, rad.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::aero::CoefficientLaw;
    ///
    /// let (cl, cd) = CoefficientLaw::WhitneyWood.lift_and_drag(45_f64.to_radians());
    /// assert!((cl - 1.8).abs() < 1e-12 && (cd - 1.9).abs() < 1e-12);
    /// ```
    pub fn lift_and_drag<D: Number>(&self, alpha: D) -> (D, D) {
        match self {
            CoefficientLaw::Dickinson => {
                let folded = Folded::new(alpha);
                let cl = symmetric(folded.angle, Symmetry::Odd, dickinson_lift);
                let cd = symmetric(folded.angle, Symmetry::Even, dickinson_drag);
                (cl * folded.lift_sign, cd)
            }
            CoefficientLaw::WhitneyWood => {
                let double = alpha * 2.0;
                (double.sin() * 1.8, -double.cos() * 1.5 + 1.9)
            }
            CoefficientLaw::ThinAirfoil { lift_slope_per_rad } => (alpha * *lift_slope_per_rad, alpha * 0.0),
            CoefficientLaw::Table(table) => table.lift_and_drag(alpha),
        }
    }
}

/// Raw fit and slope (per rad) of Dickinson's lift.
fn dickinson_lift<D: Number>(alpha: D) -> (D, D) {
    let (sin, cos) = (alpha * 2.13 - 7.20_f64.to_radians()).sin_cos();
    (sin * 1.58 + 0.225, cos * (1.58 * 2.13))
}

/// Raw fit and slope (per rad) of Dickinson's drag.
fn dickinson_drag<D: Number>(alpha: D) -> (D, D) {
    let (sin, cos) = (alpha * 2.04 - 9.82_f64.to_radians()).sin_cos();
    (-cos * 1.55 + 1.92, sin * (1.55 * 2.04))
}

/// An angle folded into the first quadrant.
struct Folded<D> {
    angle: D,
    lift_sign: f64,
}

impl<D: Number> Folded<D> {
    fn new(alpha: D) -> Self {
        let turns = (alpha.re() / (2.0 * PI)).round();
        let wrapped = alpha - turns * 2.0 * PI;
        let (size, mut lift_sign) = if wrapped.re() < 0.0 {
            (-wrapped, -1.0)
        } else {
            (wrapped, 1.0)
        };
        let angle = if size.re() > PI / 2.0 {
            lift_sign = -lift_sign;
            -size + PI
        } else {
            size
        };
        Folded { angle, lift_sign }
    }
}

/// How a curve continues across an end of the quadrant.
#[derive(Clone, Copy)]
enum Symmetry {
    Odd,
    Even,
}

/// A fit on [0, π/2] with both ends smoothed to the symmetry.
fn symmetric<D: Number>(angle: D, symmetry: Symmetry, fit: fn(D) -> (D, D)) -> D {
    let near_right = PI / 2.0 - SMOOTHING_RAD;
    let (distance, sign) = if angle.re() < SMOOTHING_RAD {
        (angle, 1.0)
    } else if angle.re() > near_right {
        (-angle + PI / 2.0, -1.0)
    } else {
        return fit(angle).0;
    };
    let join = D::from(if sign > 0.0 { SMOOTHING_RAD } else { near_right });
    let (value, slope) = fit(join);
    match symmetry {
        Symmetry::Odd => odd_join(distance, SMOOTHING_RAD, value.re(), slope.re() * sign),
        Symmetry::Even => even_join(distance, SMOOTHING_RAD, value.re(), slope.re() * sign),
    }
}

#[cfg(test)]
mod tests {
    use super::{CoefficientLaw, SMOOTHING_RAD};
    use num_dual::Dual64;
    use std::f64::consts::PI;

    const LAWS: [CoefficientLaw; 2] = [CoefficientLaw::Dickinson, CoefficientLaw::WhitneyWood];

    #[test]
    fn dickinson_at_45_degrees_is_1_805_and_1_704() {
        let (cl, cd) = CoefficientLaw::Dickinson.lift_and_drag(PI / 4.0);
        // By hand: 0.225 + 1.58 sin 88.65°, 1.92 − 1.55 cos 81.98°.
        assert!((cl - 1.804561).abs() < 1e-6, "{cl}");
        assert!((cd - 1.703746).abs() < 1e-6, "{cd}");
    }

    #[test]
    fn whitney_wood_at_45_and_90_degrees() {
        let (cl, cd) = CoefficientLaw::WhitneyWood.lift_and_drag(PI / 4.0);
        assert!((cl - 1.8).abs() < 1e-14 && (cd - 1.9).abs() < 1e-14);
        assert!((CoefficientLaw::WhitneyWood.lift_and_drag(PI / 2.0).1 - 3.4).abs() < 1e-14);
    }

    #[test]
    fn thin_airfoil_is_its_slope_without_drag() {
        let law = CoefficientLaw::ThinAirfoil {
            lift_slope_per_rad: 5.7,
        };
        assert_eq!(law.lift_and_drag(-0.1), (-0.1 * 5.7, 0.0 * -0.1));
    }

    #[test]
    fn lift_is_odd_and_drag_even_about_0_and_both_mirror_about_90() {
        for law in LAWS {
            for step in 0..=1800 {
                let alpha = f64::from(step) * 0.1_f64.to_radians();
                let (cl, cd) = law.lift_and_drag(alpha);
                let (cl_minus, cd_minus) = law.lift_and_drag(-alpha);
                let (cl_back, cd_back) = law.lift_and_drag(PI - alpha);
                assert!(
                    (cl + cl_minus).abs() < 1e-12 && (cd - cd_minus).abs() < 1e-12,
                    "{law:?} {alpha}"
                );
                assert!(
                    (cl + cl_back).abs() < 1e-12 && (cd - cd_back).abs() < 1e-12,
                    "{law:?} {alpha}"
                );
                assert!(cl.is_finite() && cd > 0.0);
            }
        }
    }

    #[test]
    fn coefficients_are_continuous_with_their_first_derivative_at_every_joint() {
        let tiny = 1e-9;
        for law in LAWS {
            for degrees in [
                -179.0, -91.0, -90.0, -89.0, -1.0, 0.0, 1.0, 45.0, 89.0, 90.0, 91.0, 179.0,
            ] {
                let joint = f64::to_radians(degrees);
                let below = law.lift_and_drag(Dual64::new(joint - tiny, 1.0));
                let above = law.lift_and_drag(Dual64::new(joint + tiny, 1.0));
                for (left, right) in [(below.0, above.0), (below.1, above.1)] {
                    assert!((left.re - right.re).abs() < 1e-7, "{law:?} step at {degrees}");
                    assert!((left.eps - right.eps).abs() < 1e-4, "{law:?} kink at {degrees}");
                }
            }
            let (turn_up, turn_down) = (law.lift_and_drag(PI - tiny), law.lift_and_drag(-PI + tiny));
            assert!((turn_up.0 - turn_down.0).abs() < 1e-7 && (turn_up.1 - turn_down.1).abs() < 1e-7);
        }
    }

    #[test]
    fn smoothing_leaves_the_measured_range_untouched() {
        let alpha = SMOOTHING_RAD * 1.0001;
        let raw = 0.225 + 1.58 * (2.13 * alpha - 7.2_f64.to_radians()).sin();
        assert!((CoefficientLaw::Dickinson.lift_and_drag(alpha).0 - raw).abs() < 1e-15);
        assert_eq!(CoefficientLaw::Dickinson.lift_and_drag(0.0).0, 0.0);
    }

    #[test]
    fn dual_derivatives_equal_central_differences() {
        let step = 1e-6;
        for law in LAWS {
            for degrees in [
                -170.0, -95.3, -44.0, -0.4, 0.3, 0.7, 12.0, 45.0, 89.6, 90.2, 133.0, 179.5,
            ] {
                let alpha = f64::to_radians(degrees);
                let (cl, cd) = law.lift_and_drag(Dual64::new(alpha, 1.0));
                let (up, down) = (law.lift_and_drag(alpha + step), law.lift_and_drag(alpha - step));
                assert!(
                    (cl.eps - (up.0 - down.0) / (2.0 * step)).abs() < 1e-7,
                    "{law:?} C_L at {degrees}"
                );
                assert!(
                    (cd.eps - (up.1 - down.1) / (2.0 * step)).abs() < 1e-7,
                    "{law:?} C_D at {degrees}"
                );
            }
        }
    }
}
