//! Monotone cubic spline through points (Fritsch & Carlson 1980).

/// Piecewise cubic that keeps rising and falling stretches rising and falling: no overshoot.
#[derive(Debug, Clone, PartialEq)]
pub struct MonotoneSpline {
    x: Vec<f64>,
    y: Vec<f64>,
    slope: Vec<f64>,
}

impl MonotoneSpline {
    /// Through `points` (x, y); at least two, finite, x strictly rising, otherwise `None`.
    ///
    /// Tangents: mean of the neighbouring secants, 0 at extrema, limited to the circle
    /// α² + β² ≤ 9 (Fritsch & Carlson, SIAM J. Numer. Anal. 17, 1980, equation 4.2); secants at both ends.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::geometry::spline::MonotoneSpline;
    ///
    /// let spline = MonotoneSpline::through(&[[0.0, 0.0], [1.0, 1.0], [2.0, 1.0]]).unwrap();
    /// let (value, slope) = spline.value_and_slope(1.5);
    /// assert!((value - 1.0).abs() < 1e-12 && slope.abs() < 1e-12);
    /// ```
    pub fn through(points: &[[f64; 2]]) -> Option<MonotoneSpline> {
        let rising = points.windows(2).all(|w| w[1][0] > w[0][0]);
        if points.len() < 2 || !rising || points.iter().flatten().any(|v| !v.is_finite()) {
            return None;
        }
        let secant: Vec<f64> = points
            .windows(2)
            .map(|w| (w[1][1] - w[0][1]) / (w[1][0] - w[0][0]))
            .collect();
        let last = secant.len() - 1;
        let mut slope = vec![secant[0]];
        for w in secant.windows(2) {
            slope.push(if w[0] * w[1] <= 0.0 {
                0.0
            } else {
                0.5 * (w[0] + w[1])
            });
        }
        slope.push(secant[last]);
        for (k, &d) in secant.iter().enumerate() {
            if d == 0.0 {
                (slope[k], slope[k + 1]) = (0.0, 0.0);
                continue;
            }
            let (a, b) = (slope[k] / d, slope[k + 1] / d);
            let radius = a.hypot(b);
            if radius > 3.0 {
                slope[k] = 3.0 * a / radius * d;
                slope[k + 1] = 3.0 * b / radius * d;
            }
        }
        Some(MonotoneSpline {
            x: points.iter().map(|p| p[0]).collect(),
            y: points.iter().map(|p| p[1]).collect(),
            slope,
        })
    }

    /// The points' x, rising.
    pub fn knots(&self) -> &[f64] {
        &self.x
    }

    /// Value and slope at x; held beyond the ends.
    pub fn value_and_slope(&self, x: f64) -> (f64, f64) {
        let last = self.x.len() - 1;
        if x < self.x[0] {
            return (self.y[0], 0.0);
        }
        if x > self.x[last] {
            return (self.y[last], 0.0);
        }
        let k = self.x.partition_point(|&knot| knot <= x).clamp(1, last) - 1;
        let h = self.x[k + 1] - self.x[k];
        let t = (x - self.x[k]) / h;
        let (y0, y1, m0, m1) = (self.y[k], self.y[k + 1], self.slope[k] * h, self.slope[k + 1] * h);
        // Cubic Hermite, written so that a straight stretch is reproduced exactly.
        let (c2, c3) = (3.0 * (y1 - y0) - 2.0 * m0 - m1, 2.0 * (y0 - y1) + m0 + m1);
        (
            y0 + t * (m0 + t * (c2 + t * c3)),
            (m0 + t * (2.0 * c2 + 3.0 * t * c3)) / h,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::MonotoneSpline;

    #[test]
    fn it_passes_through_its_points_and_never_overshoots() {
        let points = [
            [0.0, 1.0],
            [1.0, 1.0],
            [2.0, 3.0],
            [2.1, 8.0],
            [5.0, 8.0],
            [6.0, 0.5],
        ];
        let spline = MonotoneSpline::through(&points).unwrap();
        for p in points {
            assert!((spline.value_and_slope(p[0]).0 - p[1]).abs() < 1e-12);
        }
        for w in points.windows(2) {
            let (low, high) = (w[0][1].min(w[1][1]), w[0][1].max(w[1][1]));
            for i in 0..=100 {
                let x = w[0][0] + (w[1][0] - w[0][0]) * f64::from(i) / 100.0;
                let y = spline.value_and_slope(x).0;
                assert!(
                    y >= low - 1e-12 && y <= high + 1e-12,
                    "{x}: {y} outside {low}..{high}"
                );
            }
        }
    }

    #[test]
    fn its_slope_is_the_derivative_and_lines_are_exact() {
        let spline = MonotoneSpline::through(&[[0.0, 2.0], [1.0, 3.5], [3.0, 4.0]]).unwrap();
        for x in [0.3, 0.9, 1.7, 2.6] {
            let step = 1e-6;
            let difference =
                (spline.value_and_slope(x + step).0 - spline.value_and_slope(x - step).0) / (2.0 * step);
            assert!((spline.value_and_slope(x).1 - difference).abs() < 1e-8);
        }
        let line = MonotoneSpline::through(&[[0.0, 1.0], [1.0, 3.0], [4.0, 9.0]]).unwrap();
        assert!((line.value_and_slope(2.2).0 - 5.4).abs() < 1e-14);
    }

    #[test]
    fn points_that_do_not_rise_are_refused() {
        assert!(MonotoneSpline::through(&[[0.0, 1.0]]).is_none());
        assert!(MonotoneSpline::through(&[[0.0, 1.0], [0.0, 2.0]]).is_none());
        assert!(MonotoneSpline::through(&[[0.0, 1.0], [1.0, f64::NAN]]).is_none());
    }
}
