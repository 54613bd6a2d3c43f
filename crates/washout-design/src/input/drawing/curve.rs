//! Curves of a drawing as short straight lines.

/// Lines that a curve, or a quarter of a circle, is cut into: within 1/4000 of its size.
const PIECES: usize = 32;

/// Points of an arc after its first one: centre, radius, first angle and how far it turns, rad.
pub(super) fn arc([x, y]: [f64; 2], radius: f64, from: f64, turn: f64) -> Vec<[f64; 2]> {
    let quarters = (turn.abs() / std::f64::consts::FRAC_PI_2).ceil().max(1.0);
    let count = PIECES * quarters as usize;
    let at = |k: usize| from + turn * k as f64 / count as f64;
    (1..=count)
        .map(|k| [x + radius * at(k).cos(), y + radius * at(k).sin()])
        .collect()
}

/// Points after the first one of a segment of a polyline that bulges: the tangent of a quarter of the angle that it turns, positive
/// counterclockwise (AutoCAD's group 42).
pub(super) fn bulged(a: [f64; 2], b: [f64; 2], bulge: f64) -> Vec<[f64; 2]> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    if bulge == 0.0 || dx.hypot(dy) == 0.0 {
        return vec![b];
    }
    // the centre lies off the middle of the chord by its half times (1 − b²)/(2b), to the left
    let off = 0.25 * (1.0 - bulge * bulge) / bulge;
    let centre = [0.5 * (a[0] + b[0]) - off * dy, 0.5 * (a[1] + b[1]) + off * dx];
    let radius = (a[0] - centre[0]).hypot(a[1] - centre[1]);
    let from = (a[1] - centre[1]).atan2(a[0] - centre[0]);
    let mut points = arc(centre, radius, from, 4.0 * bulge.atan());
    if let Some(last) = points.last_mut() {
        *last = b;
    }
    points
}

/// Points of a B-spline by de Boor's algorithm: degree, knots, control points with their weights; none if they do not fit together.
pub(super) fn spline(degree: usize, knots: &[f64], control: &[[f64; 3]]) -> Option<Vec<[f64; 2]>> {
    let is_whole = degree > 0 && control.len() > degree && knots.len() == control.len() + degree + 1;
    if !is_whole || knots.windows(2).any(|pair| pair[1] < pair[0]) {
        return None;
    }
    let mut points = Vec::new();
    for k in degree..control.len() {
        let (from, to) = (knots[k], knots[k + 1]);
        if to <= from {
            continue;
        }
        let first = usize::from(!points.is_empty());
        for piece in first..=PIECES {
            let at = from + (to - from) * piece as f64 / PIECES as f64;
            points.push(de_boor(degree, knots, control, k, at));
        }
    }
    (points.len() > 1).then_some(points)
}

fn de_boor(degree: usize, knots: &[f64], control: &[[f64; 3]], k: usize, at: f64) -> [f64; 2] {
    // in homogeneous coordinates
    let lifted = |[x, y, weight]: [f64; 3]| [x * weight, y * weight, weight];
    let mut d: Vec<[f64; 3]> = (k - degree..=k).map(|index| lifted(control[index])).collect();
    for r in 1..=degree {
        for j in (r..=degree).rev() {
            let low = knots[j + k - degree];
            let share = (at - low) / (knots[j + 1 + k - r] - low);
            d[j] = std::array::from_fn(|i| (1.0 - share) * d[j - 1][i] + share * d[j][i]);
        }
    }
    let [x, y, weight] = d[degree];
    [x / weight, y / weight]
}

/// Points after the first one of a Bézier curve of two or three degrees: its control points, the first and the last on it.
pub(super) fn bezier(control: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let at = |t: f64| {
        let mut points = control.to_vec();
        while points.len() > 1 {
            let between = points
                .windows(2)
                .map(|pair| std::array::from_fn(|i| (1.0 - t) * pair[0][i] + t * pair[1][i]));
            points = between.collect();
        }
        points[0]
    };
    (1..=PIECES).map(|k| at(k as f64 / PIECES as f64)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_half_circle_comes_out_of_a_bulge_of_one_to_the_side_of_its_sign() {
        for (bulge, lowest) in [(1.0, -1.0), (-1.0, 1.0)] {
            let points = bulged([-1.0, 0.0], [1.0, 0.0], bulge);
            assert!(points.iter().all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-12));
            let middle = points[points.len() / 2 - 1];
            assert!((middle[1] - lowest).abs() < 1e-12, "{middle:?}");
        }
        let quarter = bulged([1.0, 0.0], [0.0, 1.0], (std::f64::consts::PI / 8.0).tan());
        assert!(quarter.iter().all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-12));
    }

    #[test]
    fn a_spline_of_one_piece_is_its_bezier_curve_and_a_weighted_one_a_circle() {
        let control = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let weighted: Vec<[f64; 3]> = control.iter().map(|[x, y]| [*x, *y, 1.0]).collect();
        let points = spline(3, &knots, &weighted).expect("a spline");
        for (a, b) in points[1..].iter().zip(bezier(&control)) {
            assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-14);
        }
        // a quarter of a circle as a rational curve of the second degree
        let weight = 0.5f64.sqrt();
        let circle = [[1.0, 0.0, 1.0], [1.0, 1.0, weight], [0.0, 1.0, 1.0]];
        let points = spline(2, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], &circle).expect("a circle");
        assert!(points.iter().all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-12));
        assert_eq!(spline(3, &knots[1..], &weighted), None);
    }
}
