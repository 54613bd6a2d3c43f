//! Where a continuous broken line bends: exact search over the splits of the points into pieces.
//!
//! Within a fixed split the best continuous line either meets where two free lines cross (Hudson, J. Am. Stat.
//! Assoc. 61, 1966, 1097) or bends at a point. Every split is tried with both kinds of break; a split whose free
//! lines already leave more than the best so far is passed over.

use crate::structure::larger;

/// Knots `[x, y]` (start, bends, end) of the best continuous line with `pieces` pieces and at least `min_points`
/// points on each; `points` rise and are scaled to the order of one. None if no split has a line.
pub(super) fn best_knots(
    points: &[[f64; 2]],
    anchor: Option<[f64; 2]>,
    pieces: usize,
    min_points: usize,
) -> Option<Vec<[f64; 2]>> {
    let mut search = Search {
        points,
        sums: Sums::running(points),
        anchor,
        min_points,
        best: None,
    };
    search.splits(&mut Vec::new(), pieces.checked_sub(1)?);
    search.best.map(|(_, knots)| knots)
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
        Some((larger(total - explained, 0.0), knots))
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
