//! Gauss-Legendre quadrature on panels between kinks.

/// Nodes and weights of the `count`-point rule on [0, 1] (Newton's method on the Legendre polynomial).
pub fn gauss_legendre(count: u32) -> Vec<[f64; 2]> {
    let n = f64::from(count);
    let mut rule: Vec<[f64; 2]> = (0..count)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (f64::from(i) + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..20 {
                let (mut value, mut before) = (1.0, 0.0);
                for k in 0..count {
                    let k = f64::from(k);
                    (value, before) = (((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0), value);
                }
                slope = n * (x * value - before) / (x * x - 1.0);
                x -= value / slope;
            }
            [0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)]
        })
        .collect();
    rule.sort_by(|a, b| a[0].total_cmp(&b[0]));
    rule
}

/// Points and weights from the first of `ends` to the last (rising), each stretch between two ends cut into panels no
/// wider than `widest`, with the rule on each.
pub fn panels(ends: &[f64], widest: f64, rule: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    for stretch in ends.windows(2) {
        let length = stretch[1] - stretch[0];
        if length <= 0.0 {
            continue;
        }
        let count = (length / widest).ceil().max(1.0);
        let width = length / count;
        let mut start = 0.0;
        while start < count {
            points.extend(
                rule.iter()
                    .map(|[node, weight]| [stretch[0] + (start + node) * width, weight * width]),
            );
            start += 1.0;
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::{gauss_legendre, panels};

    #[test]
    fn the_rule_is_exact_to_degree_2n_minus_1() {
        for count in [1, 2, 5, 16] {
            let rule = gauss_legendre(count);
            for degree in 0..2 * count {
                let sum: f64 = rule
                    .iter()
                    .map(|[x, weight]| weight * x.powi(degree as i32))
                    .sum();
                assert!(
                    (sum - 1.0 / f64::from(degree + 1)).abs() < 1e-14,
                    "{count} {degree}: {sum}"
                );
            }
        }
    }

    #[test]
    fn panels_integrate_a_kink_exactly_and_run_upward() {
        let points = panels(&[0.0, 0.3, 0.3, 1.0], 0.2, &gauss_legendre(2));
        let sum: f64 = points.iter().map(|[x, weight]| weight * (x - 0.3).abs()).sum();
        assert!((sum - (0.09 + 0.49) / 2.0).abs() < 1e-15);
        assert!(points.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    }
}
