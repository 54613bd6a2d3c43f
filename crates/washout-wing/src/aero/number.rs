//! The numbers that the air laws compute with: `f64`, or dual numbers over it for exact derivatives.

use num_dual::DualNum;

/// A number with or without derivatives: `f64`, `num_dual::Dual64`, `num_dual::DualSVec64<N>`, …
pub trait Number: DualNum<Primitive = f64> + Copy {}

impl<T: DualNum<Primitive = f64> + Copy> Number for T {}

/// Angle of the vector (x, y) from the x axis, rad in (−π, π], with derivatives that exist for every non-zero
/// vector (the dual `atan2` of num-dual divides by x and fails on the y axis).
pub(crate) fn angle_of<D: Number>(y: D, x: D) -> D {
    let half_turn = if y.re() < 0.0 {
        -std::f64::consts::PI
    } else {
        std::f64::consts::PI
    };
    if x.re().abs() >= y.re().abs() {
        let angle = (y / x).atan();
        if x.re() >= 0.0 { angle } else { angle + half_turn }
    } else {
        -(x / y).atan() + half_turn * 0.5
    }
}

#[cfg(test)]
mod tests {
    use super::angle_of;
    use num_dual::Dual64;

    #[test]
    fn angle_agrees_with_atan2_and_has_a_derivative_in_every_direction() {
        for step in 0..72 {
            let (y, x) = (f64::from(step) * 5.0_f64).to_radians().sin_cos();
            assert!((angle_of(y, x) - y.atan2(x)).abs() < 1e-15, "step {step}");
            // Turning the vector at unit rate turns the angle at unit rate.
            let turned = angle_of(Dual64::new(y, x), Dual64::new(x, -y));
            assert!((turned.eps - 1.0).abs() < 1e-14, "step {step}: {}", turned.eps);
        }
        let upright = angle_of(Dual64::new(1.0, 0.0), Dual64::new(0.0, -1.0));
        assert_eq!((upright.re, upright.eps), (std::f64::consts::FRAC_PI_2, 1.0));
    }
}
