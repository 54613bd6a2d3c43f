//! A closed outline that was drawn, as the chord of a wing along its span.
//!
//! The leading edge is the upper edge of the drawing, straight and level; the base is at the left, the tip at the right. That is how
//! washout writes its own cutting templates.

use super::error::{GeometryError, rounded_mm};
use super::spline::MonotoneSpline;

/// How far the leading edge may leave a straight level line, over the length.
const LEVEL: f64 = 0.01;
/// Error of the chord between two points, over the largest chord, below which no more points are taken.
const CLOSE: f64 = 2e-3;
/// Chord at an end, over the largest, below which the edges meet there.
const MEET: f64 = 0.01;
/// Points that are taken at most.
const MOST: usize = 40;
/// Places at which the chord is looked at.
const LOOKS: usize = 400;
/// Share of the length that the first and last look lie inside of the ends.
const INSIDE: f64 = 1e-6;

/// A wing that was drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnWing {
    /// From base to tip, mm.
    pub length_mm: f64,
    /// Points (r, chord), mm, r rising from 0 to the length.
    pub points_mm: Vec<[f64; 2]>,
    /// Largest distance of the leading edge from its mean level, mm.
    pub off_level_mm: f64,
    /// Largest distance of the chord between the points from the drawn one, mm.
    pub off_chord_mm: f64,
}

impl DrawnWing {
    /// Of a closed line, mm, y upward; `is_mirrored`: its base is at the right.
    ///
    /// # Errors
    /// If its upper edge is not level and straight, or it folds back over itself.
    pub fn of_outline(outline_mm: &[[f64; 2]], is_mirrored: bool) -> Result<DrawnWing, GeometryError> {
        let side = if is_mirrored { -1.0 } else { 1.0 };
        let turned: Vec<[f64; 2]> = outline_mm.iter().map(|[x, y]| [side * x, *y]).collect();
        let xs = || turned.iter().map(|[x, _]| *x);
        let (low, high) = (
            xs().fold(f64::INFINITY, f64::min),
            xs().fold(f64::NEG_INFINITY, f64::max),
        );
        let length_mm = high - low;
        if !(length_mm.is_finite() && length_mm > 0.0) {
            return Err(GeometryError::Drawn {
                problem: "it has no length".to_string(),
                cure: "draw the span from left to right",
            });
        }
        let looks = (0..=LOOKS).map(|k| length_mm * k as f64 / LOOKS as f64);
        let looked: Result<Vec<[f64; 3]>, GeometryError> = looks
            .map(|r| {
                let inside = r.clamp(INSIDE * length_mm, (1.0 - INSIDE) * length_mm);
                let [top, bottom] = edges(&turned, low + inside, r)?;
                Ok([r, top, bottom])
            })
            .collect();
        let looked = looked?;
        let off_level_mm = off_level(&looked, length_mm)?;
        let mut chords: Vec<[f64; 2]> = looked.iter().map(|[r, top, bottom]| [*r, top - bottom]).collect();
        let largest = chords.iter().map(|[_, chord]| *chord).fold(0.0, f64::max);
        for end in [0, LOOKS] {
            let chord = &mut chords[end][1];
            *chord = if *chord < MEET * largest { 0.0 } else { *chord };
        }
        let (points_mm, off_chord_mm) = thinned(&chords).ok_or_else(|| GeometryError::Drawn {
            problem: "its edges leave the range of numbers".to_string(),
            cure: "draw the wing in millimetres",
        })?;
        Ok(DrawnWing {
            length_mm,
            points_mm,
            off_level_mm,
            off_chord_mm,
        })
    }
}

/// Where a line across the span meets the outline: above and below.
fn edges(outline: &[[f64; 2]], x: f64, r_mm: f64) -> Result<[f64; 2], GeometryError> {
    let next = outline.iter().cycle().skip(1);
    let crossing = |(a, b): (&[f64; 2], &[f64; 2])| {
        let is_across = (a[0] <= x) != (b[0] <= x);
        is_across.then(|| a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]))
    };
    let mut met: Vec<f64> = outline.iter().zip(next).filter_map(crossing).collect();
    met.sort_by(f64::total_cmp);
    match met.as_slice() {
        [bottom, top] => Ok([*top, *bottom]),
        _ => Err(GeometryError::Drawn {
            problem: format!(
                "{:.1} mm from the base a line across the span meets it {} times instead of twice",
                r_mm,
                met.len()
            ),
            cure: "draw one outline without holes, whose edges do not fold back along the span",
        }),
    }
}

/// How far the upper edge is from level, without the rounded corners at its ends.
fn off_level(looked: &[[f64; 3]], length_mm: f64) -> Result<f64, GeometryError> {
    let inner = &looked[LOOKS / 20..=LOOKS - LOOKS / 20];
    let mean = inner.iter().map(|[_, top, _]| top).sum::<f64>() / inner.len() as f64;
    let worst = inner
        .iter()
        .max_by(|a, b| (a[1] - mean).abs().total_cmp(&(b[1] - mean).abs()));
    let [r_mm, top, _] = worst.copied().unwrap_or_default();
    let off_mm = (top - mean).abs();
    if off_mm <= LEVEL * length_mm {
        return Ok(off_mm);
    }
    let [first, last] = [inner[0][1], inner[inner.len() - 1][1]];
    Err(GeometryError::Drawn {
        problem: format!(
            "its upper edge, the leading edge, is not straight and level: {:.2} mm off at {:.1} mm from the base, and {:.2} mm {} from \
             base to tip",
            rounded_mm(off_mm * 1e-3),
            r_mm,
            (last - first).abs(),
            if last > first { "up" } else { "down" }
        ),
        cure: "turn the drawing so that the leading edge lies level on top, the base at the left; a curved leading edge cannot be modelled",
    })
}

/// As few of the points as keep the chord between them, by the spline that will join them, and how far it leaves the chord.
fn thinned(chords: &[[f64; 2]]) -> Option<(Vec<[f64; 2]>, f64)> {
    let largest = chords.iter().map(|[_, chord]| *chord).fold(0.0, f64::max);
    let rounded = |value: f64| (value * 1e3).round() * 1e-3;
    let mut taken = vec![0, chords.len() / 2, chords.len() - 1];
    loop {
        let points: Vec<[f64; 2]> = taken.iter().map(|index| chords[*index]).collect();
        let spline = MonotoneSpline::through(&points)?;
        let off = chords
            .iter()
            .map(|[r, chord]| (spline.value_and_slope(*r).0 - chord).abs());
        let (worst, off_mm) = off
            .enumerate()
            .fold((0, 0.0), |most, own| if own.1 > most.1 { own } else { most });
        if off_mm <= CLOSE * largest || taken.len() == MOST {
            return Some((
                points.into_iter().map(|point| point.map(rounded)).collect(),
                off_mm,
            ));
        }
        taken.push(worst);
        taken.sort_unstable();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half an ellipse below a level leading edge.
    fn ellipse(turn: f64) -> Vec<[f64; 2]> {
        let half: Vec<[f64; 2]> = (0..=200)
            .map(|k| {
                let angle = std::f64::consts::PI * k as f64 / 200.0;
                [35.0 + 35.0 * angle.cos(), 5.0 - 20.0 * angle.sin()]
            })
            .collect();
        let turned = half
            .iter()
            .map(|[x, y]| [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()]);
        turned.collect()
    }

    #[test]
    fn the_chord_of_half_an_ellipse_is_found_with_few_points() {
        let wing = DrawnWing::of_outline(&ellipse(0.0), false).expect("a wing");
        assert!((wing.length_mm - 70.0).abs() < 1e-9 && wing.off_level_mm < 1e-9);
        assert_eq!(
            (wing.points_mm[0], wing.points_mm[wing.points_mm.len() - 1]),
            ([0.0, 0.0], [70.0, 0.0])
        );
        assert!(wing.points_mm.len() <= MOST, "{}", wing.points_mm.len());
        assert!(wing.off_chord_mm <= CLOSE * 20.0, "{}", wing.off_chord_mm);
        let spline = MonotoneSpline::through(&wing.points_mm).expect("a spline");
        for k in 2..=98 {
            let r = 0.7 * f64::from(k);
            let exact = 20.0 * (1.0 - ((r - 35.0) / 35.0).powi(2)).sqrt();
            assert!((spline.value_and_slope(r).0 - exact).abs() < 0.1, "{r}: {exact}");
        }
    }

    #[test]
    fn a_base_at_the_right_is_mirrored() {
        let triangle = [[0.0, 0.0], [60.0, 0.0], [60.0, -20.0]];
        let wing = DrawnWing::of_outline(&triangle, true).expect("a wing");
        assert!((wing.points_mm[0][1] - 20.0).abs() < 1e-3);
        let left = DrawnWing::of_outline(&triangle, false).expect("a wing");
        assert_eq!(left.points_mm[0][1], 0.0);
    }

    #[test]
    fn a_turned_drawing_and_one_that_folds_back_are_refused_with_the_place() {
        let turned = DrawnWing::of_outline(&ellipse(0.1), false)
            .expect_err("turned")
            .to_string();
        assert!(turned.contains("not straight and level"), "{turned}");
        let folded = [
            [0.0, 0.0],
            [60.0, 0.0],
            [60.0, -20.0],
            [20.0, -20.0],
            [40.0, -10.0],
            [0.0, -15.0],
        ];
        let folded = DrawnWing::of_outline(&folded, false)
            .expect_err("folded")
            .to_string();
        assert!(folded.contains("4 times instead of twice"), "{folded}");
    }
}
