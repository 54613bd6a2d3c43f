//! The chordwise pressure of a strip and its share at each point of the chord.
//!
//! Pressure per unit force over the chord fraction η: p = (m + 1)(1 − η)^m with m = 1/x_cp − 2 for x_cp ≤ ½, and
//! mirrored above, p = (m + 1) η^m with m = 1/(1 − x_cp) − 2. It never changes sign, ∫p dη = 1 and ∫p η dη = x_cp.
//! At x_cp = ½ (uniform pressure) the two branches join in value, in force and in moment with first derivatives,
//! while the shape itself has a kink there: a derivative at exactly ½ is that of the lower branch.

use super::number::Number;

/// Smallest centre of pressure that the pressure law can carry, fraction of the chord (m = 98).
pub const SMALLEST_CENTRE: f64 = 0.01;

/// Largest centre of pressure that the pressure law can carry, fraction of the chord.
pub const LARGEST_CENTRE: f64 = 0.99;

/// Share of a strip's force that each point of a chordwise polyline carries: w_k = ∫ p φ_k dη, with the hat
/// functions φ_k of `eta`, the chord fractions of the points from 0 (leading edge) to 1 (trailing edge), rising.
///
/// Exact integrals: Σ w = 1, Σ w η = x_cp, and every field that is linear between the points does the exact work.
/// Points that coincide share one weight (the later ones get none from the empty gap). A centre of pressure outside
/// [[`SMALLEST_CENTRE`], [`LARGEST_CENTRE`]] is held at that end. Fewer than 2 points give equal weights.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// use washout::aero::pressure_weights;
///
/// let eta = [0.0, 0.4, 1.0];
/// let weights: Vec<f64> = pressure_weights(0.3, &eta);
/// let centre: f64 = weights.iter().zip(eta).map(|(share, eta)| share * eta).sum();
/// assert!((centre - 0.3).abs() < 1e-12 && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
/// ```
pub fn pressure_weights<D: Number>(x_cp: D, eta: &[f64]) -> Vec<D> {
    let count = eta.len();
    if count < 2 {
        return vec![D::from(1.0); count];
    }
    let mut weights = vec![D::from(0.0); count];
    let (exponent, mirrored) = shape(x_cp);
    for i in 0..count - 1 {
        if mirrored {
            let [near, far] = segment(exponent, eta[i + 1], eta[i + 1] - eta[i], i == 0);
            weights[i + 1] += near;
            weights[i] += far;
        } else {
            let [near, far] = segment(exponent, 1.0 - eta[i], eta[i + 1] - eta[i], i + 2 == count);
            weights[i] += near;
            weights[i + 1] += far;
        }
    }
    weights
}

/// Pressure at the chord fraction `eta` per mean pressure of the strip: p of the module text.
pub fn pressure_density<D: Number>(x_cp: D, eta: f64) -> D {
    let (exponent, mirrored) = shape(x_cp);
    let distance = if mirrored { eta } else { 1.0 - eta };
    (exponent + 1.0) * power(distance, exponent)
}

/// Exponent m, and whether the pressure is mirrored (thin end at the leading edge).
fn shape<D: Number>(x_cp: D) -> (D, bool) {
    let held = if x_cp.re() < SMALLEST_CENTRE {
        D::from(SMALLEST_CENTRE)
    } else if x_cp.re() > LARGEST_CENTRE {
        D::from(LARGEST_CENTRE)
    } else {
        x_cp
    };
    let mirrored = held.re() > 0.5;
    let near = if mirrored { -held + 1.0 } else { held };
    (near.recip() - 2.0, mirrored)
}

/// Integrals of (m + 1) s^m against the two hat functions of a gap that runs from `start` toward s = 0 over `width`,
/// s the distance from the thin end: [share of the point at `start`, share of the other]. `last`: the gap ends at 0.
///
/// With τ = width/start, the whole is start^(m+1) [1 − (1−τ)^(m+1)], the far share
/// start^(m+1) [1 − (1−τ)^(m+1) (1 + (m+1)τ)] / ((m+2) τ); on narrow gaps the brackets cancel, so the first goes
/// through expm1 and the second through the binomial series of ∫ t (1−τt)^m dt.
fn segment<D: Number>(m: D, start: f64, width: f64, last: bool) -> [D; 2] {
    if width <= 0.0 || start <= 0.0 {
        return [D::from(0.0); 2];
    }
    let scale = power(start, m + 1.0);
    let tau = if last { 1.0 } else { (width / start).min(1.0) };
    if tau >= 1.0 {
        let far = scale / (m + 2.0);
        return [scale - far, far];
    }
    let log_left = (-tau).ln_1p();
    let grown = (m + 1.0) * log_left;
    let whole = -scale * grown.exp_m1();
    let far = if tau * (m.re() + 2.0) < 0.3 {
        let mut binomial = (m + 1.0) * tau;
        let mut sum = binomial * 0.5;
        // The bound, not the term, ends the series: at whole m terms vanish while their derivatives do not.
        let mut bound = 1.0;
        let mut order = 1.0;
        while bound > 1e-18 {
            binomial = binomial * (-m + (order - 1.0)) * (tau / order);
            sum += binomial / (order + 2.0);
            bound *= tau * (m.re() + order) / order;
            order += 1.0;
        }
        scale * sum
    } else {
        scale * (-grown.exp() * ((m + 1.0) * tau + 1.0) + 1.0) / ((m + 2.0) * tau)
    };
    [whole - far, far]
}

/// base^exponent for base ≥ 0; 0^0 = 1, and the derivative of 0^m by m is 0.
fn power<D: Number>(base: f64, exponent: D) -> D {
    if base > 0.0 {
        (exponent * base.ln()).exp()
    } else if exponent.re() > 0.0 {
        exponent * 0.0
    } else {
        exponent * 0.0 + 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::{LARGEST_CENTRE, SMALLEST_CENTRE, pressure_density, pressure_weights};
    use num_dual::Dual64;
    use proptest::prelude::{prop, proptest};

    /// 20-point Gauss-Legendre nodes and weights on [0, 1] by Newton's method.
    fn gauss_20() -> Vec<(f64, f64)> {
        let n = 20;
        (0..n)
            .map(|i| {
                let mut x = (std::f64::consts::PI * (f64::from(i) + 0.75) / (f64::from(n) + 0.5)).cos();
                let mut slope = 1.0;
                for _ in 0..100 {
                    let (mut p, mut before) = (1.0, 0.0);
                    for k in 0..n {
                        let k = f64::from(k);
                        (p, before) = (((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0), p);
                    }
                    slope = f64::from(n) * (x * p - before) / (x * x - 1.0);
                    x -= p / slope;
                }
                ((1.0 + x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope))
            })
            .collect()
    }

    /// Weights by Gauss quadrature on each gap, geometrically refined toward both edges where p has a branch point.
    fn weights_by_quadrature(x_cp: f64, eta: &[f64]) -> Vec<f64> {
        let rule = gauss_20();
        let mut weights = vec![0.0; eta.len()];
        for i in 0..eta.len() - 1 {
            let (a, b) = (eta[i], eta[i + 1]);
            let mut cuts = vec![0.0, 1.0];
            cuts.extend((1..60).map(|k| 0.5_f64.powi(k)));
            cuts.extend((2..50).map(|k| 1.0 - 0.5_f64.powi(k)));
            cuts.sort_by(f64::total_cmp);
            for cut in cuts.windows(2) {
                for (node, weight) in &rule {
                    let t = cut[0] + (cut[1] - cut[0]) * node;
                    let share =
                        pressure_density(x_cp, a + (b - a) * t) * weight * (cut[1] - cut[0]) * (b - a);
                    weights[i] += share * (1.0 - t);
                    weights[i + 1] += share * t;
                }
            }
        }
        weights
    }

    const CENTRES: [f64; 13] = [
        0.05, 0.078, 0.12, 0.2, 0.25, 0.255, 0.333, 0.4, 0.49, 0.5, 0.51, 0.7, 0.87,
    ];

    #[test]
    fn weights_equal_gauss_quadrature_of_the_pressure_law() {
        let grid = [0.0, 0.001, 0.03, 0.1, 0.25, 0.5, 0.52, 0.9, 0.97, 1.0];
        for x_cp in CENTRES {
            let exact = pressure_weights(x_cp, &grid);
            for (weight, by_quadrature) in exact.iter().zip(weights_by_quadrature(x_cp, &grid)) {
                assert!(
                    (weight - by_quadrature).abs() < 1e-12,
                    "{x_cp}: {weight} {by_quadrature}"
                );
            }
        }
    }

    #[test]
    fn pressure_never_changes_sign_and_has_its_force_and_centre() {
        let rule = gauss_20();
        for x_cp in [0.1, 0.25, 0.4, 0.5, 0.6, 0.8] {
            let (mut force, mut moment) = (0.0, 0.0);
            for panel in 0..400 {
                for (node, weight) in &rule {
                    let eta = (f64::from(panel) + node) / 400.0;
                    let pressure = pressure_density(x_cp, eta);
                    assert!(pressure >= 0.0);
                    force += pressure * weight / 400.0;
                    moment += pressure * eta * weight / 400.0;
                }
            }
            assert!(
                (force - 1.0).abs() < 1e-4 && (moment - x_cp).abs() < 1e-4,
                "{x_cp}: {force} {moment}"
            );
        }
    }

    #[test]
    fn uniform_pressure_halves_between_two_points_and_quarter_chord_is_quadratic() {
        assert_eq!(pressure_weights(0.5, &[0.0, 1.0]), vec![0.5, 0.5]);
        // m = 2: ∫ 3 (1−η)² (1−2η)₊ dη over [0, ½] = 17/32, and 1/32 at the trailing edge.
        let weights: Vec<f64> = pressure_weights(0.25, &[0.0, 0.5, 1.0]);
        for (weight, expected) in weights.iter().zip([17.0 / 32.0, 14.0 / 32.0, 1.0 / 32.0]) {
            assert!((weight - expected).abs() < 1e-15, "{weights:?}");
        }
    }

    #[test]
    fn very_fine_gaps_keep_relative_accuracy() {
        // Six gaps of 1e-7: each inner weight is p times the width of the gap, to first order.
        let mut grid = vec![0.0];
        grid.extend((0..7).map(|i| 0.4 + f64::from(i) * 1e-7));
        grid.push(1.0);
        for x_cp in CENTRES {
            let weights = pressure_weights(x_cp, &grid);
            for i in 2..7 {
                let expected = pressure_density(x_cp, grid[i]) * 0.5 * (grid[i + 1] - grid[i - 1]);
                assert!(
                    (weights[i] / expected - 1.0).abs() < 1e-9,
                    "{x_cp}: {} {expected}",
                    weights[i]
                );
            }
        }
    }

    #[test]
    fn weights_are_continuous_through_the_middle_of_the_chord() {
        let grid = [0.0, 0.2, 0.6, 0.95, 1.0];
        let below: Vec<f64> = pressure_weights(0.5 - 1e-9, &grid);
        let above: Vec<f64> = pressure_weights(0.5 + 1e-9, &grid);
        for (left, right) in below.iter().zip(&above) {
            assert!((left - right).abs() < 1e-7);
        }
    }

    #[test]
    fn degenerate_chords_give_no_nan() {
        assert_eq!(pressure_weights(0.3, &[]), Vec::<f64>::new());
        assert_eq!(pressure_weights(0.3, &[0.0]), vec![1.0]);
        for grid in [[0.0, 0.0, 0.5, 1.0], [0.0, 0.5, 0.5, 1.0], [0.0, 0.5, 1.0, 1.0]] {
            for x_cp in [-1.0, 0.0, 0.3, 0.8, 1.0, 2.0] {
                let weights = pressure_weights(Dual64::new(x_cp, 1.0), &grid);
                let sum: f64 = weights.iter().map(|weight| weight.re).sum();
                assert!((sum - 1.0).abs() < 1e-14 && weights.iter().all(|weight| weight.eps.is_finite()));
                let centre: f64 = weights
                    .iter()
                    .zip(grid)
                    .map(|(weight, eta)| weight.re * eta)
                    .sum();
                assert!(
                    (centre - x_cp.clamp(SMALLEST_CENTRE, LARGEST_CENTRE)).abs() < 1e-13,
                    "{x_cp} {grid:?}"
                );
            }
        }
    }

    proptest! {
        #[test]
        fn force_and_moment_are_exact_on_any_polyline(
            x_cp in 0.03..0.97_f64,
            mut inner in prop::collection::vec(1e-6..0.999_999_f64, 0..40),
        ) {
            inner.sort_by(f64::total_cmp);
            let grid: Vec<f64> = std::iter::once(0.0).chain(inner).chain(std::iter::once(1.0)).collect();
            let weights = pressure_weights(x_cp, &grid);
            let force: f64 = weights.iter().sum();
            let moment: f64 = weights.iter().zip(&grid).map(|(weight, eta)| weight * eta).sum();
            assert!((force - 1.0).abs() < 1e-13 && (moment - x_cp).abs() < 1e-13, "{force} {moment}");
            assert!(weights.iter().all(|weight| *weight >= 0.0));
        }

        #[test]
        fn dual_derivatives_equal_central_differences(
            x_cp in 0.05..0.95_f64,
            mut inner in prop::collection::vec(1e-3..0.999_f64, 0..12),
        ) {
            inner.sort_by(f64::total_cmp);
            let grid: Vec<f64> = std::iter::once(0.0).chain(inner).chain(std::iter::once(1.0)).collect();
            // The shape has a kink at the middle of the chord: stay on one side.
            let x_cp = if (x_cp - 0.5).abs() < 1e-5 { 0.49 } else { x_cp };
            let step = 1e-6;
            let dual = pressure_weights(Dual64::new(x_cp, 1.0), &grid);
            let (up, down) = (pressure_weights(x_cp + step, &grid), pressure_weights(x_cp - step, &grid));
            for i in 0..grid.len() {
                let slope = (up[i] - down[i]) / (2.0 * step);
                assert!((dual[i].eps - slope).abs() < 1e-7, "{} {slope}", dual[i].eps);
            }
        }
    }

    #[test]
    fn derivatives_are_right_at_whole_exponents() {
        // x_cp = 1/2, 1/3, 1/4 give m = 0, 1, 2, where terms of the series vanish.
        let grid: Vec<f64> = (0..=50).map(|i| f64::from(i) / 50.0).collect();
        for x_cp in [0.5, 1.0 / 3.0, 0.25] {
            let dual = pressure_weights(Dual64::new(x_cp, 1.0), &grid);
            let (here, below) = (
                pressure_weights(x_cp, &grid),
                pressure_weights(x_cp - 1e-7, &grid),
            );
            let moment: f64 = dual.iter().zip(&grid).map(|(weight, eta)| weight.eps * eta).sum();
            assert!((moment - 1.0).abs() < 1e-12, "{x_cp}: {moment}");
            for i in 0..grid.len() {
                let slope = (here[i] - below[i]) / 1e-7;
                assert!(
                    (dual[i].eps - slope).abs() < 1e-6,
                    "{x_cp} at {i}: {} {slope}",
                    dual[i].eps
                );
            }
        }
    }
}
