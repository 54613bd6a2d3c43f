//! The largest of numbers, where one that is not a number is kept: `f64::max` drops it, and with it the fault that made it.

/// The larger of two numbers; not a number if one of them is none.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a >= b { a } else { b }
}

/// The smaller of two numbers; not a number if one of them is none.
pub fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || a <= b { a } else { b }
}

/// The largest of numbers that are not negative, 0 without any; not a number if one of them is none.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, larger)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_number_is_kept_wherever_it_stands_and_else_the_largest_is_found() {
        for place in 0..3 {
            let mut values = [1.0, 3.0, 2.0];
            assert_eq!(largest(values), 3.0);
            values[place] = f64::NAN;
            assert!(largest(values).is_nan(), "{place}");
        }
        for (a, b) in [(f64::NAN, 1.0), (1.0, f64::NAN)] {
            assert!(larger(a, b).is_nan() && smaller(a, b).is_nan());
        }
        assert_eq!((larger(-1.0, 2.0), smaller(-1.0, 2.0)), (2.0, -1.0));
        assert_eq!((larger(2.0, -1.0), smaller(2.0, -1.0)), (2.0, -1.0));
        assert_eq!(largest([]), 0.0);
    }
}
