//! Smooth joins of a law to its symmetry at 0, 90 and 180°.

use std::f64::consts::PI;

use super::number::Number;

/// Width of the smoothing on each side of 0, 90 and 180°, rad (1°).
pub const SMOOTHING_RAD: f64 = PI / 180.0;

/// The odd cubic that has `value` and `slope` at `width`, taken at `x`.
pub fn odd_join<D: Number>(x: D, width: f64, value: f64, slope: f64) -> D {
    let linear = (3.0 * value - slope * width) / (2.0 * width);
    let cubic = (slope * width - value) / (2.0 * width.powi(3));
    x * (x * x * cubic + linear)
}

/// The even parabola that has `value` and `slope` at `width`, taken at `x`.
pub fn even_join<D: Number>(x: D, width: f64, value: f64, slope: f64) -> D {
    let square = slope / (2.0 * width);
    x * x * square + (value - square * width * width)
}
