//! Between finite steps of an effect.

use nalgebra::DVector;
use serde::{Deserialize, Serialize};

use super::columns::of_strengths;

/// How far strengths are apart.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// By their difference.
    #[default]
    Even,
    /// Of a share that is lost, of which 1 would be all: by the ratio of what is left, −ln(1 − |s|) from none.
    Lost,
}

/// Slope over secant up to which a cubic keeps rising.
const STEEPEST: f64 = 3.0;

/// Ends of a range from which on a strength is a share of which 1 would be all.
const NEARLY_ALL: f64 = 0.9;

impl Measure {
    /// Of a strength in a range.
    pub fn within([low, high]: [f64; 2]) -> Measure {
        let is_share = |end: f64| (NEARLY_ALL..1.0).contains(&end.abs());
        match is_share(high) && (low == 0.0 || is_share(low)) {
            true => Measure::Lost,
            false => Measure::Even,
        }
    }

    /// How far a strength is from none.
    pub fn of(self, strength: f64) -> f64 {
        match self {
            Measure::Even => strength,
            Measure::Lost => -(-strength.abs()).ln_1p() * strength.signum(),
        }
    }

    /// The strength that is so far from none.
    pub fn strength(self, far: f64) -> f64 {
        match self {
            Measure::Even => far,
            Measure::Lost => -(-far.abs()).exp_m1() * far.signum(),
        }
    }

    /// The strength in the middle between two.
    pub fn middle(self, from: f64, to: f64) -> f64 {
        self.strength(0.5 * (self.of(from) + self.of(to)))
    }
}

/// Strengths in ascending order with the change of every observable.
pub type Knots = Vec<(f64, DVector<f64>)>;

/// Change of every observable along the strength of an effect.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Strengths that were solved, none (0) among them.
    #[serde(with = "of_strengths")]
    pub knots: Knots,
    /// Derivative of every observable with the strength at none; empty if it has none there.
    pub slope: Vec<f64>,
    /// How far strengths are apart.
    pub measure: Measure,
}

impl Curve {
    /// At a strength within the knots: cubics that keep what rises between two of them rising (Fritsch & Butland, SIAM J. Sci. Stat.
    /// Comput. 5 (1984) 300), with the derivative at none as far as that allows (at most three times the secant).
    pub fn at(&self, strength: f64) -> DVector<f64> {
        let Curve {
            knots,
            slope,
            measure,
        } = self;
        let count = knots.len();
        let Some(above) = knots.iter().position(|knot| knot.0 >= strength) else {
            return knots
                .last()
                .map_or_else(|| DVector::zeros(0), |knot| knot.1.clone());
        };
        if above == 0 {
            return knots[0].1.clone();
        }
        let below = above - 1;
        let ((from, low), (to, high)) = (&knots[below], &knots[above]);
        let (from, to) = (measure.of(*from), measure.of(*to));
        let width = to - from;
        let t = (measure.of(strength) - from) / width;
        let span = |of: usize| measure.of(knots[of + 1].0) - measure.of(knots[of].0);
        let secant = |of: usize, row: usize| (knots[of + 1].1[row] - knots[of].1[row]) / span(of);
        let known = |knot: usize, row: usize| slope.get(row).filter(|_| knots[knot].0 == 0.0);
        let slope_at = |knot: usize, row: usize| {
            let own = secant(below, row);
            match knot {
                _ if let Some(known) = known(knot, row) => rising(*known, own),
                // beside none: the parabola
                _ if count == 2 => {
                    known(1 - knot, row).map_or(own, |known| rising(2.0 * own - rising(*known, own), own))
                }
                0 => at_end([secant(0, row), secant(1, row)], [span(0), span(1)]),
                last if last + 1 == count => at_end(
                    [secant(last - 1, row), secant(last - 2, row)],
                    [span(last - 1), span(last - 2)],
                ),
                inner => {
                    let (left, right) = (secant(inner - 1, row), secant(inner, row));
                    let (before, after) = (span(inner - 1), span(inner));
                    let (a, b) = (2.0 * after + before, after + 2.0 * before);
                    match left * right > 0.0 {
                        true => (a + b) / (a / left + b / right),
                        false => 0.0,
                    }
                }
            }
        };
        let [h0, h1] = [(1.0 + 2.0 * t) * (1.0 - t).powi(2), t * (1.0 - t).powi(2)];
        let [g0, g1] = [t * t * (3.0 - 2.0 * t), t * t * (t - 1.0)];
        DVector::from_fn(low.len(), |row, _| {
            let [start, end] = [below, above].map(|knot| slope_at(knot, row));
            h0 * low[row] + g0 * high[row] + width * (h1 * start + g1 * end)
        })
    }
}

/// A slope as far as a cubic with this secant does not overshoot with it.
fn rising(slope: f64, secant: f64) -> f64 {
    match slope * secant > 0.0 {
        true => slope.abs().min(STEEPEST * secant.abs()).copysign(secant),
        false => 0.0,
    }
}

/// Slope at an end, from the secants next to it and their widths: that of the parabola, kept from overshooting.
fn at_end([near, far]: [f64; 2], [width, next]: [f64; 2]) -> f64 {
    let slope = ((2.0 * width + next) * near - width * far) / (width + next);
    if slope * near <= 0.0 {
        0.0
    } else if near * far <= 0.0 && slope.abs() > 3.0 * near.abs() {
        3.0 * near
    } else {
        slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(knots: &[(f64, f64)]) -> impl Fn(f64) -> DVector<f64> {
        let knots: Vec<(f64, DVector<f64>)> = knots
            .iter()
            .map(|&(s, y)| (s, DVector::from_element(1, y)))
            .collect();
        let curve = Curve {
            knots,
            ..Curve::default()
        };
        move |strength| curve.at(strength)
    }

    #[test]
    fn between_steps_a_line_stays_a_line_and_a_parabola_nearly_one() {
        let line = of(&[(-1.0, -2.0), (0.0, 0.0), (0.5, 1.0), (2.0, 4.0)]);
        let parabola = of(&[(0.0, 0.0), (0.5, 0.75), (1.0, 2.0), (1.5, 3.75)]);
        for k in 0..=15 {
            let s = 0.1 * f64::from(k);
            assert!((line(s)[0] - 2.0 * s).abs() < 1e-12, "{s}");
            // a straight line would be 0.06 off
            assert!(
                (parabola(s)[0] - (s + s * s)).abs() < 0.02,
                "{s}: {}",
                parabola(s)[0]
            );
        }
        let both = of(&[(0.0, 0.0), (1.0, 3.0)]);
        assert_eq!(both(0.5)[0], 1.5);
    }

    #[test]
    fn what_a_lost_share_does_to_a_torsion_bar_is_met_between_a_few_steps() {
        // twist in proportion to the softness 1/(1 − s) − 1, as far as the air lets it: it falls with the twist
        let twist = |s: f64| {
            let soft = s / (1.0 - s);
            soft / (1.0 + 0.3 * soft)
        };
        let measure = Measure::within([0.0, 0.999]);
        let middle = measure.middle(0.0, 0.95);
        let strengths = [
            0.0,
            measure.middle(0.0, middle),
            middle,
            measure.middle(middle, 0.95),
            0.95,
        ];
        let knots: Vec<(f64, DVector<f64>)> = strengths
            .iter()
            .map(|&s| (s, DVector::from_element(1, twist(s))))
            .collect();
        let curve = Curve {
            knots,
            slope: vec![],
            measure,
        };
        for k in 0..=19 {
            let s = 0.05 * f64::from(k);
            let off = curve.at(s)[0] - twist(s);
            assert!(off.abs() < 0.02 * twist(0.95), "{s}: {off}");
            assert!((measure.strength(measure.of(s)) - s).abs() < 1e-12);
        }
    }

    #[test]
    fn the_derivative_at_none_halves_the_error_between_few_steps() {
        let twist = |s: f64| s / (1.0 + 2.0 * s);
        let off = |strengths: &[f64], slope: &[f64]| {
            let knots = strengths.iter().map(|&s| (s, DVector::from_element(1, twist(s))));
            let curve = Curve {
                knots: knots.collect(),
                slope: slope.to_vec(),
                measure: Measure::Even,
            };
            let errors =
                (0..=100).map(|k| (curve.at(0.01 * f64::from(k))[0] - twist(0.01 * f64::from(k))).abs());
            errors.fold(0.0, f64::max)
        };
        let (without, with) = (off(&[0.0, 0.5, 1.0], &[]), off(&[0.0, 0.5, 1.0], &[1.0]));
        assert!(with < 0.5 * without, "{with} {without}");
        // one step and the derivative: the parabola, as far as it rises
        let parabola = Curve {
            knots: vec![(0.0, DVector::zeros(1)), (1.0, DVector::from_element(1, 2.0))],
            slope: vec![1.0],
            measure: Measure::Even,
        };
        assert!((parabola.at(0.3)[0] - (0.3 + 0.09)).abs() < 1e-12);
    }

    #[test]
    fn a_step_response_is_never_overshot() {
        let kink = of(&[(0.0, 0.0), (1.0, 0.0), (2.0, 1.0), (3.0, 1.0)]);
        for k in 0..=30 {
            let y = kink(0.1 * f64::from(k))[0];
            assert!((0.0..=1.0).contains(&y), "{y}");
        }
    }
}
