//! The functions of formulas, finite with their derivatives wherever mathematics has them so.
//!
//! Dual numbers compute some of them through parts that overflow (tanh as sinh over cosh) or vanish (a power through another that is three
//! less). Where such a part spoils the result it is put together anew from value and slope, to first order; elsewhere it stays.

use num_dual::DualNum;

/// Functions, with the number of their arguments.
pub const FUNCTIONS: &[(&str, usize)] = &[
    ("sin", 1),
    ("cos", 1),
    ("tan", 1),
    ("atan", 1),
    ("tanh", 1),
    ("exp", 1),
    ("ln", 1),
    ("sqrt", 1),
    ("abs", 1),
    ("min", 2),
    ("max", 2),
];

/// Size from which on a number, and with it its derivative, may have overflowed: what levels off there has no slope.
const HUGE: f64 = 1e290;
/// Size from which on the square of a number may overflow.
const LARGE: f64 = 1e100;
/// Argument from which on tanh is 1 to the last digit, and the square of cosh nears overflow.
const FLAT: f64 = 300.0;

pub(super) fn call<D: DualNum<Primitive = f64> + Copy>(name: &str, a: D, b: D) -> D {
    let size = a.re().abs();
    match name {
        "sin" => a.sin(),
        "cos" => a.cos(),
        "tan" => a.tan(),
        "atan" if size > HUGE => D::from(a.re().atan()),
        "atan" => a.atan(),
        "tanh" if size > FLAT => D::from(a.re().tanh()),
        "tanh" => a.tanh(),
        "exp" if a.re() < -HUGE => D::from(0.0),
        "exp" => a.exp(),
        "ln" => a.ln(),
        "sqrt" => a.sqrt(),
        "abs" if a.re() < 0.0 => -a,
        "min" if b.re() < a.re() || b.re().is_nan() => b,
        "max" if b.re() > a.re() || b.re().is_nan() => b,
        _ => a,
    }
}

/// a / b; 0 over a divisor that has overflowed. The inverse of a divisor next to 0 overflows.
pub(super) fn divide<D: DualNum<Primitive = f64> + Copy>(a: D, b: D) -> D {
    let quotient = a.re() / b.re();
    match b.re().abs() {
        size if size > HUGE && quotient.abs() < 1.0 / HUGE => D::from(quotient),
        size if size > 0.0 && size < 1.0 / HUGE => D::from(quotient),
        size if size > 0.0 && size < 1.0 / LARGE => (a - b * quotient) / b.re() + quotient,
        size if size > LARGE && size.is_finite() => (a - b * quotient) / b.re() + quotient,
        _ => a / b,
    }
}

/// a^b; for whole b also for negative a. Positive whole powers are products: the derivative of `powi` is no number at 0.
pub(super) fn power<D: DualNum<Primitive = f64> + Copy>(a: D, b: f64) -> D {
    if b.fract() == 0.0 && b.abs() <= 64.0 {
        let product = |b: f64| (1..b as usize).fold(a, |product, _| product * a);
        return match b {
            _ if b > 0.0 => product(b),
            0.0 => D::from(1.0),
            _ => kept(a.powi(b as i32)).unwrap_or_else(|| divide(D::from(1.0), product(-b))),
        };
    }
    let value = a.re().powf(b);
    if value.is_nan() {
        // exponents next to 0, 1 and 2 are taken as these by the library of dual numbers, also where there is no power
        return D::from(value);
    }
    kept(a.powf(b)).unwrap_or_else(|| {
        match a.re() {
            0.0 if b > 1.0 => D::from(value),
            // an infinite slope
            0.0 if b > 0.0 => a.sqrt(),
            _ if value.abs() < 1.0 / HUGE || !value.is_finite() => D::from(value),
            size => (a - size) * (b * value / size) + value,
        }
    })
}

/// a^b where both are variables, so for positive a, and for a = 0 with positive b.
pub(super) fn power_of<D: DualNum<Primitive = f64> + Copy>(a: D, b: D) -> D {
    match (a.re(), b.re()) {
        (0.0, exponent) if exponent > 0.0 => power(a, exponent),
        _ => call("exp", a.ln() * b, b),
    }
}

/// A power that was computed without a part that overflowed or vanished.
fn kept<D: DualNum<Primitive = f64> + Copy>(value: D) -> Option<D> {
    let size = value.re().abs();
    (size > 0.0 && size.is_finite()).then_some(value)
}
