//! Ranges and ticks of axes.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Ticks that an axis has at least, where a finer step gives them.
const FEWEST: f64 = 3.0;

/// Range of an axis with its ticks.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// Lower and upper end.
    pub range: [f64; 2],
    /// Ticks within, rising.
    pub ticks: Vec<f64>,
    decimals: Option<usize>,
}

impl Scale {
    /// A scale that holds all `values` with some room around them and has about `count` ticks at round numbers.
    ///
    /// Without values it runs from 0 to 1; a single value gets room on both sides.
    pub fn around(values: impl IntoIterator<Item = f64>, room: f64, count: usize) -> Scale {
        let (low, high) = values
            .into_iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        let size = low.abs().max(high.abs());
        let width = high - low;
        let range = if width > 1e-9 * size {
            [low - room * width, high + room * width]
        } else if size > 0.0 {
            [low - 0.5 * size, high + 0.5 * size]
        } else {
            [-1.0, 1.0]
        };
        let asked = (range[1] - range[0]) / count.max(1) as f64;
        let ticks_of = |step: f64| (range[1] / step).floor() - (range[0] / step).ceil() + 1.0;
        let steps = [1.0, 0.5, 0.25].map(|share| round_step(share * asked));
        let step = steps
            .into_iter()
            .find(|step| ticks_of(*step) >= FEWEST)
            .unwrap_or(steps[2]);
        let first = (range[0] / step).ceil() as i64;
        let last = (range[1] / step).floor() as i64;
        // Division by the reciprocal of a small step gives 0.3 where 3 × 0.1 would not.
        let tick = |k: i64| {
            if step < 1.0 {
                k as f64 / (1.0 / step).round()
            } else {
                k as f64 * step
            }
        };
        let ticks: Vec<f64> = if step < 1e-6 {
            (first..=last).map(|k| k as f64 * step).collect()
        } else {
            (first..=last).map(tick).collect()
        };
        let is_plain = size < 1e5 && step > 0.99e-4;
        let decimals = is_plain.then(|| (-(step * 1.0001).log10().floor()).max(0.0) as usize);
        Scale {
            range,
            ticks,
            decimals,
        }
    }

    /// Label of a tick.
    pub fn label(&self, tick: f64) -> String {
        match self.decimals {
            Some(decimals) => typeset(&format!("{tick:.decimals$}")),
            None if tick == 0.0 => "0".to_string(),
            None => typeset(&format!("{tick:.1e}")),
        }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let share = (value - self.range[0]) / (self.range[1] - self.range[0]);
        (f64::from(limit.0) + share * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range[0]..self.range[1]
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, tick: &f64) -> String {
        self.label(*tick)
    }
}

/// The smallest of 1, 2 and 5 times a power of ten that is not below `step`.
fn round_step(step: f64) -> f64 {
    let power = 10_f64.powf(step.log10().floor());
    let factors = [1.0, 2.0, 5.0, 10.0];
    let factor = factors
        .iter()
        .find(|factor| **factor * power >= step * (1.0 - 1e-9));
    power * factor.unwrap_or(&10.0)
}

/// A number with a true minus sign, and none before zero.
pub fn typeset(number: &str) -> String {
    match number.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| "0.".contains(c)) => rest.to_string(),
        Some(rest) => format!("−{}", rest.replace('-', "−")),
        None => number.replace('-', "−"),
    }
}

/// A number with so many significant digits, in plain notation where it can be read so.
pub fn short(value: f64, digits: usize) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e5).contains(&size) {
        return typeset(&format!("{value:.*e}", digits.saturating_sub(1)));
    }
    let whole = if size == 0.0 {
        1
    } else {
        size.log10().floor() as i64 + 1
    };
    let decimals = (digits as i64 - whole).max(0) as usize;
    typeset(&format!("{value:.decimals$}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(values: &[f64], count: usize) -> Vec<String> {
        let scale = Scale::around(values.iter().copied(), 0.0, count);
        scale.ticks.iter().map(|tick| scale.label(*tick)).collect()
    }

    #[test]
    fn ticks_stand_at_round_numbers_within_the_range() {
        assert_eq!(labels(&[0.0, 1.0], 5), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&[-30.0, 41.0], 4), ["−20", "0", "20", "40"]);
        assert_eq!(labels(&[0.0, 0.0031], 4), ["0.000", "0.001", "0.002", "0.003"]);
        assert_eq!(labels(&[0.0, 3e-7], 3), ["0", "1.0e−7", "2.0e−7", "3.0e−7"]);
        assert_eq!(labels(&[1.2e6, 1.4e6], 2), ["1.2e6", "1.3e6", "1.4e6"]);
    }

    #[test]
    fn every_scale_has_finite_ends_and_at_least_one_tick() {
        let cases: [&[f64]; 7] = [
            &[],
            &[0.0],
            &[-3.7],
            &[1e-12],
            &[2e9, 2e9],
            &[5.0, 5.0 + 1e-13],
            &[-1e-9, 1e7],
        ];
        for values in cases {
            let scale = Scale::around(values.iter().copied(), 0.05, 5);
            assert!(scale.range[0] < scale.range[1], "{values:?} {scale:?}");
            assert!(
                scale.range.iter().chain(&scale.ticks).all(|v| v.is_finite()),
                "{scale:?}"
            );
            assert!(
                !scale.ticks.is_empty() && scale.ticks.len() < 12,
                "{values:?} {scale:?}"
            );
            assert!(
                values
                    .iter()
                    .all(|v| scale.range[0] <= *v && *v <= scale.range[1]),
                "{values:?} {scale:?}"
            );
        }
    }

    #[test]
    fn numbers_carry_true_minus_signs_and_zero_none() {
        assert_eq!(typeset("-0.00"), "0.00");
        assert_eq!(short(-12.345, 3), "−12.3");
        assert_eq!(short(2e-6, 2), "2.0e−6");
        assert_eq!(short(0.0, 2), "0.0");
    }
}
