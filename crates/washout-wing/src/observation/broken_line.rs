//! Least squares for a continuous broken line with a given number of pieces: exact search, then Gauss-Newton.

use nalgebra::{DMatrix, DVector};

use super::split_search::best_knots;
use crate::structure::largest;

/// A continuous broken line y(x): value at its start, rate of each piece, places where it bends.
///
/// Units are those of the points given to [`fit`].
#[derive(Debug, Clone, PartialEq)]
pub struct BrokenLine {
    /// Where the line starts: the anchor, or the first point.
    pub start_x: f64,
    /// Value there.
    pub start_y: f64,
    /// Rate dy/dx of each piece.
    pub rates: Vec<f64>,
    /// Places of the bends, rising; one fewer than `rates`.
    pub breaks: Vec<f64>,
    /// Sum of squared residuals.
    pub rss: f64,
    /// Variances of the parameters per unit variance of a point, in the order of the columns of the Jacobian;
    /// none where the points cannot tell the parameters apart.
    pub unit_variance: Option<Vec<f64>>,
}

impl BrokenLine {
    /// Value at `x`; the first and last piece run on beyond the points.
    pub fn value(&self, x: f64) -> f64 {
        (0..self.rates.len()).fold(self.start_y, |y, piece| {
            y + self.rates[piece] * self.overlap(piece, x)
        })
    }

    /// Number of fitted parameters; an anchored line does not fit its start.
    pub fn parameters(pieces: usize, anchored: bool) -> usize {
        2 * pieces - usize::from(anchored)
    }

    /// Signed length of piece `piece` between the start and `x`.
    fn overlap(&self, piece: usize, x: f64) -> f64 {
        let from = if piece == 0 {
            self.start_x
        } else {
            self.breaks[piece - 1]
        };
        let past = if piece == 0 { x - from } else { (x - from).max(0.0) };
        match self.breaks.get(piece) {
            Some(to) => past.min(to - from),
            None => past,
        }
    }

    /// Derivatives of the values with respect to start value (unless anchored), rates, breaks.
    fn jacobian(&self, points: &[[f64; 2]], anchored: bool) -> DMatrix<f64> {
        let pieces = self.rates.len();
        let first = usize::from(!anchored);
        DMatrix::from_fn(points.len(), Self::parameters(pieces, anchored), |row, column| {
            let x = points[row][0];
            match column {
                _ if column < first => 1.0,
                _ if column < first + pieces => self.overlap(column - first, x),
                _ => {
                    let bend = column - first - pieces;
                    if x > self.breaks[bend] {
                        self.rates[bend] - self.rates[bend + 1]
                    } else {
                        0.0
                    }
                }
            }
        })
    }
}

/// Best continuous broken line with `pieces` pieces and at least `min_points` points on each.
///
/// A point on a break counts for one of the two. `points` are `[x, y]` with x rising; `anchor` is a point `[x, y]`, at or before the first, that the line
/// passes exactly. None where the points are too few or do not rise.
pub fn fit(
    points: &[[f64; 2]],
    anchor: Option<[f64; 2]>,
    pieces: usize,
    min_points: usize,
) -> Option<BrokenLine> {
    let min_points = min_points.max(1);
    let first = points.first()?;
    let rising = points.windows(2).all(|pair| pair[0][0] <= pair[1][0]);
    let before = anchor.is_none_or(|place| place[0] <= first[0]);
    if pieces == 0 || points.len() < pieces * min_points || !rising || !before {
        return None;
    }
    let scale = Scale::of(points, anchor)?;
    let scaled: Vec<[f64; 2]> = points.iter().map(|point| scale.inward(*point)).collect();
    let anchored_at = anchor.map(|place| scale.inward(place));
    let candidate = best_knots(&scaled, anchored_at, pieces, min_points)?;
    let line = scale.outward(candidate);
    Some(refine(line, points, anchor.is_some()))
}

/// Gauss-Newton on all parameters from the best split, as far as it lowers the residual, and the variances.
fn refine(mut line: BrokenLine, points: &[[f64; 2]], anchored: bool) -> BrokenLine {
    let residuals = |line: &BrokenLine| {
        DVector::from_iterator(
            points.len(),
            points.iter().map(|point| point[1] - line.value(point[0])),
        )
    };
    let first = usize::from(!anchored);
    let pieces = line.rates.len();
    line.rss = residuals(&line).norm_squared();
    for _ in 0..4 {
        let jacobian = line.jacobian(points, anchored);
        let Ok(step) = jacobian.svd(true, true).solve(&residuals(&line), 1e-12) else {
            break;
        };
        let mut trial = line.clone();
        if !anchored {
            trial.start_y += step[0];
        }
        (0..pieces).for_each(|piece| trial.rates[piece] += step[first + piece]);
        (0..pieces - 1).for_each(|bend| trial.breaks[bend] += step[first + pieces + bend]);
        trial.rss = residuals(&trial).norm_squared();
        let last = points.len() - 1;
        let inside = trial
            .breaks
            .iter()
            .all(|b| *b > trial.start_x && *b < points[last][0]);
        if !(trial.rss < line.rss && inside && trial.breaks.windows(2).all(|pair| pair[0] < pair[1])) {
            break;
        }
        line = trial;
    }
    line.unit_variance = unit_variance(&line.jacobian(points, anchored));
    line
}

/// Diagonal of (JᵀJ)⁻¹; none where J has not full rank.
fn unit_variance(jacobian: &DMatrix<f64>) -> Option<Vec<f64>> {
    let lengths: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    if lengths.contains(&0.0) {
        return None;
    }
    let scaled = DMatrix::from_fn(jacobian.nrows(), jacobian.ncols(), |row, column| {
        jacobian[(row, column)] / lengths[column]
    });
    let inverse = (scaled.transpose() * scaled).cholesky()?.inverse();
    let variance: Vec<f64> = (0..lengths.len())
        .map(|k| inverse[(k, k)] / (lengths[k] * lengths[k]))
        .collect();
    variance
        .iter()
        .all(|v| v.is_finite() && *v < 1e14)
        .then_some(variance)
}

/// Shift and scale that bring the points near [0, 1]², so that running sums keep their digits.
struct Scale {
    x: [f64; 2],
    y: [f64; 2],
}

impl Scale {
    fn of(points: &[[f64; 2]], anchor: Option<[f64; 2]>) -> Option<Scale> {
        let start = anchor.unwrap_or(points[0]);
        let length = points[points.len() - 1][0] - start[0];
        let height = largest(points.iter().map(|point| (point[1] - start[1]).abs()));
        let finite = points
            .iter()
            .flatten()
            .chain(&start)
            .all(|value| value.is_finite());
        (finite && length > 0.0).then_some(Scale {
            x: [start[0], length],
            y: [start[1], if height > 0.0 { height } else { 1.0 }],
        })
    }

    fn inward(&self, point: [f64; 2]) -> [f64; 2] {
        [
            (point[0] - self.x[0]) / self.x[1],
            (point[1] - self.y[0]) / self.y[1],
        ]
    }

    /// The line through knots `[x, y]` in scaled units, back in the units of the points.
    fn outward(&self, knots: Vec<[f64; 2]>) -> BrokenLine {
        let out = |knot: &[f64; 2]| [knot[0] * self.x[1] + self.x[0], knot[1] * self.y[1] + self.y[0]];
        let knots: Vec<[f64; 2]> = knots.iter().map(out).collect();
        BrokenLine {
            start_x: knots[0][0],
            start_y: knots[0][1],
            rates: knots
                .windows(2)
                .map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]))
                .collect(),
            breaks: knots[1..knots.len() - 1].iter().map(|knot| knot[0]).collect(),
            rss: f64::INFINITY,
            unit_variance: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(count: usize, line: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        (0..count).map(|k| [k as f64, line(k as f64)]).collect()
    }

    /// Residual of the best line for breaks on a fine grid that meets no point, by dense least squares: no code shared.
    fn brute_force(points: &[[f64; 2]], bends: usize, step: f64) -> f64 {
        let end = points[points.len() - 1][0];
        let grid: Vec<f64> = (0..)
            .map(|k| (k as f64 + 0.5) * step)
            .take_while(|x| *x < end)
            .collect();
        let mut breaks = vec![0usize; bends];
        let mut lowest = f64::INFINITY;
        loop {
            if breaks.windows(2).all(|pair| pair[0] < pair[1]) {
                let columns = 2 + bends;
                let a = DMatrix::from_fn(points.len(), columns, |row, column| match column {
                    0 => 1.0,
                    1 => points[row][0],
                    _ => (points[row][0] - grid[breaks[column - 2]]).max(0.0),
                });
                let y = DVector::from_iterator(points.len(), points.iter().map(|p| p[1]));
                let solved = a.clone().svd(true, true).solve(&y, 1e-12).unwrap();
                let ok = breaks
                    .iter()
                    .map(|k| grid[*k])
                    .fold((true, -1.0), |(ok, from), to| {
                        let count = points.iter().filter(|p| p[0] >= from && p[0] <= to).count();
                        (ok && count >= 2, to)
                    });
                let last = points.iter().filter(|p| p[0] >= ok.1).count();
                if ok.0 && last >= 2 {
                    lowest = lowest.min((y - a * solved).norm_squared());
                }
            }
            let Some(slot) = (0..bends).rev().find(|k| breaks[*k] + 1 < grid.len()) else {
                return lowest;
            };
            breaks[slot] += 1;
            breaks[slot + 1..].fill(0);
        }
    }

    #[test]
    fn a_line_with_two_bends_between_points_is_recovered_to_rounding() {
        let truth = |x: f64| 1.0 + 0.5 * x + 2.0 * (x - 4.3).max(0.0) - 1.7 * (x - 9.6).max(0.0);
        let line = fit(&sampled(16, truth), None, 3, 2).unwrap();
        assert!(line.rss < 1e-24, "{line:?}");
        for (found, wanted) in line
            .breaks
            .iter()
            .zip([4.3, 9.6])
            .chain(line.rates.iter().zip([0.5, 2.5, 0.8]))
        {
            assert!((found - wanted).abs() < 1e-11, "{line:?}");
        }
    }

    #[test]
    fn the_search_is_never_above_a_brute_force_grid() {
        for seed in 0..6u64 {
            let points = sampled(11, |x| {
                let wild = ((x * 12.9898 + seed as f64 * 78.233).sin() * 43758.5453).fract();
                0.2 * x + 0.4 * (x - 5.0).max(0.0) + 0.8 * wild
            });
            for bends in 1..=2 {
                let line = fit(&points, None, bends + 1, 2).unwrap();
                let grid = brute_force(&points, bends, 0.04);
                assert!(
                    line.rss <= grid * (1.0 + 1e-12),
                    "seed {seed}: {} above {grid}",
                    line.rss
                );
                assert!(
                    line.rss > 0.9 * grid,
                    "seed {seed}: {} far below {grid}",
                    line.rss
                );
            }
        }
    }

    #[test]
    fn an_anchored_line_passes_its_anchor_and_is_the_best_that_does() {
        let points = [[1.0, 1.1], [2.0, 1.9], [4.0, 4.2]];
        let line = fit(&points, Some([0.0, 0.0]), 1, 1).unwrap();
        let by_hand = (1.1 + 2.0 * 1.9 + 4.0 * 4.2) / (1.0 + 4.0 + 16.0);
        assert!((line.rates[0] - by_hand).abs() < 1e-14);
        assert_eq!(line.value(0.0), 0.0);
        let variance = line.unit_variance.unwrap();
        assert!((variance[0] - 1.0 / 21.0).abs() < 1e-14);
    }

    #[test]
    fn too_few_or_falling_points_give_no_line() {
        assert_eq!(fit(&[[0.0, 1.0], [1.0, 2.0], [2.0, 2.0]], None, 2, 2), None);
        assert_eq!(fit(&[[1.0, 1.0], [0.0, 2.0]], None, 1, 1), None);
        assert_eq!(fit(&[[0.0, f64::NAN], [1.0, 2.0]], None, 1, 1), None);
        assert_eq!(fit(&[[1.0, 1.0], [2.0, 2.0]], Some([1.5, 0.0]), 1, 1), None);
    }

    #[test]
    fn the_jacobian_agrees_with_differences() {
        let points = sampled(12, |x| 0.3 * x + 0.9 * (x - 5.4).max(0.0) + 0.1 * (3.0 * x).sin());
        let line = fit(&points, None, 2, 2).unwrap();
        let jacobian = line.jacobian(&points, false);
        let step = 1e-6;
        for column in 0..4 {
            let nudged = |sign: f64| {
                let mut other = line.clone();
                match column {
                    0 => other.start_y += sign * step,
                    1 | 2 => other.rates[column - 1] += sign * step,
                    _ => other.breaks[0] += sign * step,
                }
                other
            };
            for (row, point) in points.iter().enumerate() {
                let difference = (nudged(1.0).value(point[0]) - nudged(-1.0).value(point[0])) / (2.0 * step);
                assert!((jacobian[(row, column)] - difference).abs() < 1e-8);
            }
        }
    }
}
