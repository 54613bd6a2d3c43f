//! Least squares for a continuous broken line with a given number of pieces: exact search, then Gauss-Newton.
//!
//! Within a fixed split of the points into pieces the best continuous line either meets where two free lines
//! cross (Hudson, J. Am. Stat. Assoc. 61, 1966, 1097) or bends at a point. Every split is tried with both
//! kinds of break; a split whose free lines already leave more than the best so far is passed over.

use nalgebra::{DMatrix, DVector};

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
    /// Variances of the parameters per unit variance of a point, in the order of [`BrokenLine::jacobian`];
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
    let mut search = Search {
        points: &scaled,
        sums: Sums::running(&scaled),
        anchor: anchor.map(|place| scale.inward(place)),
        min_points,
        best: None,
    };
    search.splits(&mut Vec::new(), pieces - 1);
    let candidate = search.best?.1;
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
        let height = points
            .iter()
            .map(|point| (point[1] - start[1]).abs())
            .fold(0.0, f64::max);
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

/// Running sums of 1, x, x², y, xy, y² over the points.
#[derive(Clone, Copy, Default)]
struct Sums([f64; 6]);

impl Sums {
    fn running(points: &[[f64; 2]]) -> Vec<Sums> {
        let mut all = vec![Sums::default()];
        for [x, y] in points {
            let mut next = all[all.len() - 1];
            for (sum, term) in next.0.iter_mut().zip([1.0, *x, x * x, *y, x * y, y * y]) {
                *sum += term;
            }
            all.push(next);
        }
        all
    }

    fn between(running: &[Sums], from: usize, end: usize) -> Sums {
        Sums(std::array::from_fn(|k| running[end].0[k] - running[from].0[k]))
    }
}

/// Where the line bends between two neighbouring points of different pieces.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bend {
    /// Between them, where the two free lines cross.
    Free,
    /// At the last point of the left piece.
    AtLast,
    /// At the first point of the right piece.
    AtNext,
}

impl Bend {
    const ALL: [Bend; 3] = [Bend::Free, Bend::AtLast, Bend::AtNext];
}

/// The search over splits: `split[k]` is the index of the first point of piece k + 1.
struct Search<'a> {
    points: &'a [[f64; 2]],
    sums: Vec<Sums>,
    anchor: Option<[f64; 2]>,
    min_points: usize,
    best: Option<(f64, Vec<[f64; 2]>)>,
}

impl Search<'_> {
    fn splits(&mut self, split: &mut Vec<usize>, left: usize) {
        if left == 0 {
            return self.try_split(split);
        }
        let from = split.last().copied().unwrap_or(0) + self.min_points;
        let end = self.points.len() - left * self.min_points;
        for index in from..=end {
            split.push(index);
            self.splits(split, left - 1);
            split.pop();
        }
    }

    fn try_split(&mut self, split: &[usize]) {
        let bends = split.len();
        let mut kinds = vec![Bend::Free; bends];
        let Some((lower_bound, _)) = self.groups(split, &kinds) else {
            return;
        };
        let beaten = |rss: f64, best: &Option<(f64, Vec<[f64; 2]>)>| {
            best.as_ref().is_some_and(|(lowest, _)| rss >= *lowest)
        };
        if beaten(lower_bound, &self.best) {
            return;
        }
        for pattern in 0..3usize.pow(bends as u32) {
            for (bend, kind) in kinds.iter_mut().enumerate() {
                *kind = Bend::ALL[pattern / 3usize.pow(bend as u32) % 3];
            }
            let Some((rss, lines)) = self.groups(split, &kinds) else {
                continue;
            };
            if beaten(rss, &self.best) {
                continue;
            }
            if let Some(knots) = self.join(split, &kinds, &lines) {
                self.best = Some((rss, knots));
            }
        }
    }

    /// Best lines for a split, each as its two end knots; neighbours share a knot where the break is not free.
    fn groups(&self, split: &[usize], kinds: &[Bend]) -> Option<(f64, Vec<[[f64; 2]; 2]>)> {
        let pieces = split.len() + 1;
        let mut rss = 0.0;
        let mut lines = Vec::with_capacity(pieces);
        let mut group_start = 0;
        for piece in 0..pieces {
            if piece + 1 < pieces && kinds[piece] != Bend::Free {
                continue;
            }
            let (part, knots) = self.chain(split, kinds, group_start, piece)?;
            rss += part;
            lines.extend(knots.windows(2).map(|pair| [pair[0], pair[1]]));
            group_start = piece + 1;
        }
        Some((rss, lines))
    }

    /// Least squares of a chain of pieces with shared knots: a tridiagonal system in the values at the knots.
    fn chain(&self, split: &[usize], kinds: &[Bend], from: usize, to: usize) -> Option<(f64, Vec<[f64; 2]>)> {
        let begin = |piece: usize| if piece == 0 { 0 } else { split[piece - 1] };
        let end = |piece: usize| split.get(piece).copied().unwrap_or(self.points.len());
        let anchor = self.anchor.filter(|_| from == 0);
        let mut x = vec![anchor.map_or(self.points[begin(from)][0], |place| place[0])];
        x.extend((from..=to).map(|piece| match kinds.get(piece) {
            Some(Bend::AtNext) if piece < to => self.points[end(piece)][0],
            _ => self.points[end(piece) - 1][0],
        }));
        let unknowns = x.len();
        let (mut diagonal, mut upper) = (vec![0.0; unknowns], vec![0.0; unknowns]);
        let (mut right, mut total) = (vec![0.0; unknowns], 0.0);
        for (knot, piece) in (from..=to).enumerate() {
            let [n, sx, sxx, sy, sxy, syy] = Sums::between(&self.sums, begin(piece), end(piece)).0;
            let (a, b) = (x[knot], x[knot + 1]);
            let h = b - a;
            if h <= 0.0 {
                return None;
            }
            diagonal[knot] += (n * b * b - 2.0 * b * sx + sxx) / (h * h);
            upper[knot] += ((a + b) * sx - n * a * b - sxx) / (h * h);
            diagonal[knot + 1] += (n * a * a - 2.0 * a * sx + sxx) / (h * h);
            right[knot] += (b * sy - sxy) / h;
            right[knot + 1] += (sxy - a * sy) / h;
            total += syy;
        }
        if let Some(place) = anchor {
            total += place[1] * (place[1] * diagonal[0] - 2.0 * right[0]);
            right[1] -= upper[0] * place[1];
            (diagonal[0], upper[0], right[0]) = (1.0, 0.0, place[1]);
        }
        let y = solve_tridiagonal(&diagonal, &upper, &right)?;
        let explained: f64 = (usize::from(anchor.is_some())..unknowns)
            .map(|k| right[k] * y[k])
            .sum();
        let knots = x.iter().zip(&y).map(|(x, y)| [*x, *y]).collect();
        Some(((total - explained).max(0.0), knots))
    }

    /// Knots of the continuous line: free neighbours must cross between their points; none if they do not.
    fn join(&self, split: &[usize], kinds: &[Bend], lines: &[[[f64; 2]; 2]]) -> Option<Vec<[f64; 2]>> {
        let mut knots = vec![lines[0][0]];
        for (bend, &index) in split.iter().enumerate() {
            let [left, right] = [lines[bend], lines[bend + 1]];
            if kinds[bend] != Bend::Free {
                knots.push(left[1]);
                continue;
            }
            let rate = |line: [[f64; 2]; 2]| (line[1][1] - line[0][1]) / (line[1][0] - line[0][0]);
            let change = rate(left) - rate(right);
            let x =
                left[0][0] + (right[0][1] - left[0][1] + rate(right) * (left[0][0] - right[0][0])) / change;
            let (low, high) = (self.points[index - 1][0], self.points[index][0]);
            if !(x.is_finite() && x > low && x < high) {
                return None;
            }
            knots.push([x, left[0][1] + rate(left) * (x - left[0][0])]);
        }
        let last = lines[lines.len() - 1];
        let before = knots[knots.len() - 1];
        let rate = (last[1][1] - last[0][1]) / (last[1][0] - last[0][0]);
        knots.push([last[1][0], before[1] + rate * (last[1][0] - before[0])]);
        Some(knots)
    }
}

/// Solution of a symmetric tridiagonal system; none if it is not positive definite.
fn solve_tridiagonal(diagonal: &[f64], upper: &[f64], right: &[f64]) -> Option<Vec<f64>> {
    let size = diagonal.len();
    let (mut pivot, mut y) = (diagonal.to_vec(), right.to_vec());
    for k in 1..size {
        let factor = upper[k - 1] / pivot[k - 1];
        pivot[k] -= factor * upper[k - 1];
        if pivot[k].is_nan() || pivot[k] <= 1e-13 * diagonal[k] {
            return None;
        }
        y[k] -= factor * y[k - 1];
    }
    y[size - 1] /= pivot[size - 1];
    for k in (0..size - 1).rev() {
        y[k] = (y[k] - upper[k] * y[k + 1]) / pivot[k];
    }
    Some(y)
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
