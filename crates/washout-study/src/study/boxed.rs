//! Least of a quadratic within a box: steps of a fit whose unknowns have ranges.

use nalgebra::{Cholesky, DMatrix, DVector};

use crate::structure::larger;

/// Minimizes ½ dᵀ `curvature` d − `push`ᵀ d with `low` ≤ d ≤ `high`, by active sets.
///
/// `curvature` is positive definite; where it is not, the push itself is taken, clamped.
pub fn least_in_box(
    curvature: &DMatrix<f64>,
    push: &DVector<f64>,
    low: &DVector<f64>,
    high: &DVector<f64>,
) -> DVector<f64> {
    let size = push.len();
    let mut held = vec![false; size];
    let mut best = DVector::zeros(size);
    // one unknown is held or freed in each round
    for _ in 0..10 * (size + 1) {
        let Some(found) = least_with_held(curvature, push, &held, &best) else {
            best.copy_from(push);
            break;
        };
        best = found;
        let beyond = |k: usize| larger(low[k] - best[k], best[k] - high[k]);
        let worst = (0..size)
            .filter(|&k| !held[k])
            .max_by(|&a, &b| beyond(a).total_cmp(&beyond(b)));
        if let Some(k) = worst.filter(|&k| beyond(k) > 0.0) {
            held[k] = true;
            best[k] = best[k].clamp(low[k], high[k]);
            continue;
        }
        let pull = push - curvature * &best;
        let inward = |k: usize| match () {
            () if low[k] >= high[k] => 0.0,
            () if best[k] <= low[k] => pull[k],
            () => -pull[k],
        };
        let freed = (0..size)
            .filter(|&k| held[k])
            .max_by(|&a, &b| inward(a).total_cmp(&inward(b)));
        match freed.filter(|&k| inward(k) > 1e-12 * push.norm()) {
            Some(k) => held[k] = false,
            None => break,
        }
    }
    DVector::from_fn(size, |k, _| best[k].clamp(low[k], high[k]))
}

/// The least with some unknowns held where they are in `at`.
fn least_with_held(
    curvature: &DMatrix<f64>,
    push: &DVector<f64>,
    held: &[bool],
    at: &DVector<f64>,
) -> Option<DVector<f64>> {
    let free: Vec<usize> = (0..held.len()).filter(|&k| !held[k]).collect();
    let mut found = DVector::from_fn(at.len(), |k, _| if held[k] { at[k] } else { 0.0 });
    if free.is_empty() {
        return Some(found);
    }
    let right = (push - curvature * &found).select_rows(&free);
    let inner = curvature.select_rows(&free).select_columns(&free);
    let solved = Cholesky::new(inner)?.solve(&right);
    for (&k, value) in free.iter().zip(solved.iter()) {
        found[k] = *value;
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(values: &[f64]) -> DVector<f64> {
        DVector::from_column_slice(values)
    }

    #[test]
    fn without_walls_in_the_way_it_is_the_solution() {
        let curvature = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 3.0]);
        let found = least_in_box(&curvature, &of(&[1.0, -2.0]), &of(&[-9.0; 2]), &of(&[9.0; 2]));
        assert!((found - of(&[1.0, -1.0])).norm() < 1e-14);
    }

    #[test]
    fn an_unknown_that_is_stopped_lets_the_others_go_on_to_where_they_then_are_best() {
        let curvature = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 3.0]);
        let found = least_in_box(&curvature, &of(&[1.0, -2.0]), &of(&[-9.0, -0.5]), &of(&[9.0; 2]));
        // 2 d₀ = 1 + 0.5
        assert!((found - of(&[0.75, -0.5])).norm() < 1e-14);
    }

    #[test]
    fn no_move_within_the_box_is_better() {
        // strongly correlated, walls on several sides
        let size = 5;
        let slopes = DMatrix::from_fn(7, size, |i, j| ((i * 3 + j * j) as f64).sin() + 1.5);
        let curvature = slopes.transpose() * &slopes + 0.01 * DMatrix::identity(size, size);
        for turn in 0..40 {
            let push = DVector::from_fn(size, |k, _| 3.0 * ((turn * 7 + k * 5) as f64).sin());
            let low = DVector::from_fn(size, |k, _| -0.2 * ((turn + k) % 3) as f64);
            let high = DVector::from_fn(size, |k, _| 0.3 * ((turn + 2 * k) % 4) as f64);
            let found = least_in_box(&curvature, &push, &low, &high);
            let pull = &push - &curvature * &found;
            for k in 0..size {
                assert!(low[k] <= found[k] && found[k] <= high[k]);
                let up = found[k] < high[k] && pull[k] > 1e-9;
                let down = found[k] > low[k] && pull[k] < -1e-9;
                assert!(!up && !down, "{turn} {k}: {found} {pull}");
            }
        }
    }
}
