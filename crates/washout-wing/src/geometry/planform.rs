//! Outline of the wing as built: chord along the span, closed at the base and cut at the tip.

use super::beta::{BetaChord, r1_hat_by_regression};
use super::error::{GeometryError, rounded_mm};
use super::spline::MonotoneSpline;
use crate::input::design::Design;

/// Outline of the wing as built. Frame of [`crate::geometry`], metres.
#[derive(Debug, Clone, PartialEq)]
pub struct Planform {
    shape: Shape,
    length_m: f64,
    root_offset_m: f64,
    closure_m: f64,
    tip_m: f64,
    mean_chord_m: f64,
    area_moments: [f64; 3],
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Beta { chord: BetaChord, mean_chord_m: f64 },
    Outline(MonotoneSpline),
}

/// Numbers of an outline, SI: the wing's length, its offset, its points and where it is closed.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineSpec<'a> {
    /// Length R, m.
    pub length_m: f64,
    /// Distance from the flapping axis to the base, m.
    pub root_offset_m: f64,
    /// Points (r, chord), m, r rising.
    pub points_m: &'a [[f64; 2]],
    /// Fraction of R inboard of which the chord is held.
    pub base_closure: f64,
    /// Fraction of R at which the wing is cut.
    pub tip_cut: f64,
}

impl Planform {
    /// The planform that a design states: beta distribution by r̂₂ (r̂₁ by Ellington's regression) or by
    /// r̂₁ and r̂₂, or an outline of points joined by a monotone spline.
    ///
    /// Errors: values out of range, radii that no distribution has, an outline that does not rise or does
    /// not reach both ends, a chord of zero where an edge is needed.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// use washout::{geometry::Planform, input::Design};
    /// let design = Design::load(Path::new("designs/twist-v2.toml"), &[])?.design;
    /// let planform = Planform::from_design(&design)?;
    /// assert!(planform.chord_m(0.0) > planform.chord_m(0.95 * planform.length_m()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_design(design: &Design) -> Result<Planform, GeometryError> {
        let p = &design.planform;
        let length_mm = p.length_mm.value();
        positive("length_mm", length_mm)?;
        let (root_offset_m, base_closure, tip_cut) = (
            p.root_offset_mm.value() / 1000.0,
            p.base_closure.value(),
            p.tip_cut.value(),
        );
        if let Some(points_mm) = &p.outline {
            if p.r2_hat.is_some() {
                return Err(GeometryError::TwoShapes { key: "r2_hat" });
            }
            let points_m: Vec<[f64; 2]> = points_mm.iter().map(|&[r, c]| [r / 1000.0, c / 1000.0]).collect();
            return Planform::from_outline(&OutlineSpec {
                length_m: length_mm / 1000.0,
                root_offset_m,
                points_m: &points_m,
                base_closure,
                tip_cut,
            });
        }
        let (Some(mean_chord), Some(r2_hat)) = (&p.mean_chord_mm, &p.r2_hat) else {
            return Err(GeometryError::NoShape);
        };
        positive("mean_chord_mm", mean_chord.value())?;
        let r2_hat = r2_hat.value();
        let (r1_hat, origin) = match &p.r1_hat {
            Some(r1_hat) => (r1_hat.value(), ""),
            None => (r1_hat_by_regression(r2_hat), " (Ellington's regression)"),
        };
        let chord = BetaChord::from_radii(r1_hat, r2_hat).ok_or(GeometryError::ImpossibleRadii {
            r1_hat,
            r2_hat,
            origin,
        })?;
        let mean_chord_m = mean_chord.value() / 1000.0;
        Planform::build(
            Shape::Beta { chord, mean_chord_m },
            length_mm / 1000.0,
            root_offset_m,
            base_closure,
            tip_cut,
            Some(mean_chord_m),
        )
    }

    /// The planform of an outline given by points, SI. Errors as [`Planform::from_design`].
    pub fn from_outline(spec: &OutlineSpec) -> Result<Planform, GeometryError> {
        let points = spec.points_m;
        if points.len() < 2 {
            return Err(GeometryError::ShortOutline { points: points.len() });
        }
        for (index, &[r_m, chord_m]) in points.iter().enumerate() {
            let problem = if !(r_m.is_finite() && chord_m.is_finite()) {
                "not a number"
            } else if chord_m < 0.0 {
                "the chord must not be negative"
            } else if index > 0 && r_m <= points[index - 1][0] {
                "r must be larger than that of the point before it"
            } else {
                continue;
            };
            return Err(GeometryError::Outline {
                index,
                r_mm: rounded_mm(r_m),
                chord_mm: rounded_mm(chord_m),
                problem,
            });
        }
        let spline = MonotoneSpline::through(points).ok_or(GeometryError::NoShape)?;
        Planform::build(
            Shape::Outline(spline),
            spec.length_m,
            spec.root_offset_m,
            spec.base_closure,
            spec.tip_cut,
            None,
        )
    }

    fn build(
        shape: Shape,
        length_m: f64,
        root_offset_m: f64,
        base_closure: f64,
        tip_cut: f64,
        mean_chord_m: Option<f64>,
    ) -> Result<Planform, GeometryError> {
        positive("length_mm", length_m)?;
        within(
            "root_offset_mm",
            rounded_mm(root_offset_m),
            root_offset_m >= 0.0,
            "0 or more",
        )?;
        within(
            "base_closure",
            base_closure,
            (0.0..1.0).contains(&base_closure),
            "from 0 to below 1",
        )?;
        within(
            "tip_cut",
            tip_cut,
            tip_cut > base_closure && tip_cut <= 1.0,
            "larger than base_closure and at most 1",
        )?;
        let (closure_m, tip_m) = (base_closure * length_m, tip_cut * length_m);
        if let Shape::Outline(spline) = &shape {
            let (from_m, to_m) = (spline.knots()[0], spline.knots()[spline.knots().len() - 1]);
            let slack_m = 1e-9 * length_m;
            if from_m > closure_m + slack_m || to_m < tip_m - slack_m {
                return Err(GeometryError::OutlineTooShort {
                    from_mm: rounded_mm(from_m),
                    to_mm: rounded_mm(to_m),
                    needed_from_mm: rounded_mm(closure_m),
                    needed_to_mm: rounded_mm(tip_m),
                });
            }
        }
        let mut planform = Planform {
            shape,
            length_m,
            root_offset_m,
            closure_m,
            tip_m,
            mean_chord_m: mean_chord_m.unwrap_or(0.0),
            area_moments: [0.0; 3],
        };
        planform.area_moments = planform.integrate_moments();
        planform.mean_chord_m = mean_chord_m.unwrap_or(planform.area_moments[0] / length_m);
        planform.refuse_missing_chord()?;
        Ok(planform)
    }

    /// An edge shorter than a thousandth of the mean chord would make elements without a shape.
    fn refuse_missing_chord(&self) -> Result<(), GeometryError> {
        const SAMPLES: usize = 512;
        for i in 0..=SAMPLES {
            let r_m = self.tip_m * i as f64 / SAMPLES as f64;
            let chord_m = self.chord_m(r_m);
            if !(chord_m >= 1e-3 * self.mean_chord_m && chord_m.is_finite()) {
                let (end, cure) = if r_m < 0.5 * self.tip_m {
                    (
                        "root",
                        "raise planform.base_closure, which holds the chord near the base",
                    )
                } else {
                    ("tip", "lower planform.tip_cut, which closes the tip")
                };
                return Err(GeometryError::NoChord {
                    at_mm: rounded_mm(r_m),
                    chord_mm: rounded_mm(chord_m),
                    end,
                    cure,
                });
            }
        }
        Ok(())
    }

    /// Length R from base to tip before the tip is cut, m.
    pub fn length_m(&self) -> f64 {
        self.length_m
    }

    /// Distance r₀ from the flapping axis to the base, m.
    pub fn root_offset_m(&self) -> f64 {
        self.root_offset_m
    }

    /// Span position where the wing is cut, m.
    pub fn tip_m(&self) -> f64 {
        self.tip_m
    }

    /// Span position inboard of which the chord is held, m.
    pub fn closure_m(&self) -> f64 {
        self.closure_m
    }

    /// Chord as built at r, m; beyond the ends that of the end.
    pub fn chord_m(&self, r_m: f64) -> f64 {
        self.chord_and_slope(r_m).0
    }

    /// Chord as built (m) and its slope dc/dr; the slope is 0 where the chord is held.
    pub fn chord_and_slope(&self, r_m: f64) -> (f64, f64) {
        let at_m = r_m.max(self.closure_m).min(self.tip_m);
        let (chord_m, slope) = match &self.shape {
            Shape::Beta { chord, mean_chord_m } => {
                let x_hat = at_m / self.length_m;
                let chord_m = mean_chord_m * chord.chord_hat(x_hat);
                let rate = (chord.p - 1.0) / x_hat - (chord.q - 1.0) / (1.0 - x_hat);
                (chord_m, chord_m * rate / self.length_m)
            }
            Shape::Outline(spline) => spline.value_and_slope(at_m),
        };
        (
            chord_m,
            if r_m < self.closure_m || r_m > self.tip_m {
                0.0
            } else {
                slope
            },
        )
    }

    /// Mean chord, m: as stated, or area over length for an outline.
    pub fn mean_chord_m(&self) -> f64 {
        self.mean_chord_m
    }

    /// Area as built, m².
    pub fn area_m2(&self) -> f64 {
        self.area_moments[0]
    }

    /// Non-dimensional radius of the first moment of area as built, about the base, over R.
    pub fn r1_hat(&self) -> f64 {
        self.area_moments[1] / self.area_moments[0] / self.length_m
    }

    /// Non-dimensional radius of the second moment of area as built, about the base, over R.
    pub fn r2_hat(&self) -> f64 {
        (self.area_moments[2] / self.area_moments[0]).sqrt() / self.length_m
    }

    /// Places where the outline may have a kink: closure and the outline's points, m, rising, inside the wing.
    pub fn kinks_m(&self) -> Vec<f64> {
        let mut kinks_m = vec![self.closure_m];
        if let Shape::Outline(spline) = &self.shape {
            kinks_m.extend(spline.knots().iter().filter(|&&r| r > self.closure_m));
        }
        kinks_m.retain(|&r| r > 0.0 && r < self.tip_m);
        kinks_m
    }

    /// ∫ c rᵏ dr for k = 0, 1, 2, by Gauss quadrature in panels that end at the kinks.
    fn integrate_moments(&self) -> [f64; 3] {
        const PANELS: usize = 64;
        let mut ends_m = vec![0.0];
        ends_m.extend(self.kinks_m());
        ends_m.push(self.tip_m);
        let mut moments = [0.0; 3];
        for w in ends_m.windows(2) {
            let width_m = (w[1] - w[0]) / PANELS as f64;
            for panel in 0..PANELS {
                for (point, weight) in GAUSS_5 {
                    let r_m = w[0] + (panel as f64 + 0.5 * (1.0 + point)) * width_m;
                    let piece = 0.5 * weight * width_m * self.chord_m(r_m);
                    moments[0] += piece;
                    moments[1] += piece * r_m;
                    moments[2] += piece * r_m * r_m;
                }
            }
        }
        moments
    }
}

/// Gauss-Legendre points and weights on −1 … 1, exact to degree 9.
const GAUSS_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

fn positive(key: &'static str, value: f64) -> Result<(), GeometryError> {
    within(key, value, value > 0.0 && value.is_finite(), "larger than 0")
}

fn within(key: &'static str, value: f64, holds: bool, allowed: &'static str) -> Result<(), GeometryError> {
    if holds {
        Ok(())
    } else {
        Err(GeometryError::Value { key, value, allowed })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::function::beta::beta_reg;

    fn wing(planform: &str) -> Result<Planform, GeometryError> {
        let text = format!(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\n{planform}\n[[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\n\
             section = {{ shape = 'round', diameter_mm = 1.0 }}\n"
        );
        Planform::from_design(&toml::from_str(&text).unwrap())
    }

    const PAPER: &str = "mean_chord_mm = 20.5\nr2_hat = 0.54\nroot_offset_mm = 38.0";

    #[test]
    fn the_built_area_agrees_with_the_incomplete_beta_function() {
        let built = wing(PAPER).unwrap();
        let r1 = r1_hat_by_regression(0.54);
        let BetaChord { p, q, .. } = BetaChord::from_radii(r1, 0.54).unwrap();
        let (length, mean) = (0.070, 0.0205);
        let held = built.chord_m(0.0) * 0.02 * length;
        let area = mean * length * (beta_reg(p, q, 0.99) - beta_reg(p, q, 0.02)) + held;
        assert!(
            (built.area_m2() / area - 1.0).abs() < 1e-9,
            "{} {area}",
            built.area_m2()
        );
        // Closing both ends must not move the wing that the paper states by more than half a percent.
        assert!((built.area_m2() / (mean * length) - 1.0).abs() < 5e-3);
        assert!((built.r1_hat() - r1).abs() < 3e-3 && (built.r2_hat() - 0.54).abs() < 3e-3);
    }

    #[test]
    fn the_chord_is_held_at_the_base_and_cut_at_the_tip() {
        let built = wing(PAPER).unwrap();
        assert_eq!(built.chord_m(0.0), built.chord_m(0.02 * 0.070));
        assert!((built.tip_m() - 0.0693).abs() < 1e-15);
        assert!(built.chord_m(built.tip_m()) > 0.004);
        assert_eq!(built.root_offset_m(), 0.038);
        for r_m in [0.003, 0.02, 0.05, 0.069] {
            let difference = (built.chord_m(r_m + 1e-8) - built.chord_m(r_m - 1e-8)) / 2e-8;
            assert!((built.chord_and_slope(r_m).1 / difference - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn a_rectangle_given_as_outline_has_its_exact_moments() {
        let built = wing("outline = [[0.0, 20.0], [70.0, 20.0]]\nbase_closure = 0.0\ntip_cut = 1.0").unwrap();
        assert!((built.area_m2() - 0.0014).abs() < 1e-15);
        assert!((built.mean_chord_m() - 0.020).abs() < 1e-15);
        assert!((built.r1_hat() - 0.5).abs() < 1e-12);
        assert!((built.r2_hat() - (1.0f64 / 3.0).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_triangle_given_as_outline_has_its_exact_area() {
        let built = wing("outline = [[0.0, 30.0], [70.0, 10.0]]\nbase_closure = 0.0\ntip_cut = 1.0").unwrap();
        assert!((built.area_m2() - 0.0014).abs() < 1e-15);
    }

    #[test]
    fn impossible_planforms_are_refused_with_the_cure() {
        let message = |planform: &str| wing(planform).unwrap_err().to_string();
        assert_eq!(
            message("mean_chord_mm = 20.5\nr2_hat = 0.55\nr1_hat = 0.6"),
            "planform.r2_hat = 0.55 with r1_hat = 0.6000: no chord distribution has these, it needs \
             r1_hat < r2_hat < √r1_hat = 0.7746; leave r1_hat out to have it from r2_hat (between 0.01 and 0.75)"
        );
        assert_eq!(
            message("mean_chord_mm = 20.5\nr2_hat = 0.9"),
            "planform.r2_hat = 0.9 with r1_hat = 0.9576 (Ellington's regression): no chord distribution has these, \
             it needs r1_hat < r2_hat < √r1_hat = 0.9786; leave r1_hat out to have it from r2_hat (between 0.01 and 0.75)"
        );
        assert_eq!(
            message("mean_chord_mm = 20.5\nr2_hat = 0.54\ntip_cut = 1.0"),
            "planform: the chord is 0.000000 mm at r = 70.000 mm, where the tip edge stands; \
             lower planform.tip_cut, which closes the tip"
        );
        assert_eq!(
            message("outline = [[0.0, 20.0], [60.0, 20.0]]"),
            "planform.outline runs from 0 to 60 mm, but the wing is built from 1.4 to \
             69.3 mm; add points, or change length_mm, base_closure or tip_cut"
        );
        assert_eq!(
            message("outline = [[0.0, 20.0], [60.0, 20.0], [50.0, 3.0]]"),
            "planform.outline, point 3 [50, 3]: r must be larger than that of the point before it"
        );
        assert_eq!(
            message("mean_chord_mm = -2.0\nr2_hat = 0.54"),
            "planform.mean_chord_mm = -2: must be larger than 0"
        );
        assert_eq!(
            message("mean_chord_mm = 20.5\nr2_hat = 0.54\nbase_closure = 1.5"),
            "planform.base_closure = 1.5: must be from 0 to below 1"
        );
        assert!(
            message("mean_chord_mm = 20.5").starts_with("planform: no shape; give mean_chord_mm and r2_hat")
        );
    }
}
