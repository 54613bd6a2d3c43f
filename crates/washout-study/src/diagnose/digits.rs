//! Numbers in the sentences of a diagnosis.

/// Three digits that count.
pub fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
    if !(1e-4..1e6).contains(&value.abs()) {
        format!("{value:.2e}")
    } else {
        format!("{value:.digits$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_three_digits() {
        assert_eq!(
            [short(0.123456), short(12.3456), short(1234.6)],
            ["0.123", "12.3", "1235"]
        );
        assert_eq!([short(-2.5e-6), short(0.0)], ["-2.50e-6", "0"]);
    }
}
