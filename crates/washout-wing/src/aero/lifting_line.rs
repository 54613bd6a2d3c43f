//! Prandtl's lifting line of an untwisted wing: the downwash that its own trailing vortices make along the span.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::{DMatrix, DVector};

/// Terms of the series: the lift of a rectangle is right to 1e-5 with them.
const TERMS: usize = 24;
/// Slope of the lift coefficient of a section, 1/rad. The downwash over the lift hardly hangs on it: not at all on an ellipse.
const SLOPE_PER_RAD: f64 = TAU;

/// The lifting line of a wing in a straight stream.
#[derive(Debug, Clone, PartialEq)]
pub struct LiftingLine {
    length_m: f64,
    has_wall: bool,
    /// Order of each term times its coefficient, for an angle of attack of 1 rad.
    terms: Vec<[f64; 2]>,
}

impl LiftingLine {
    /// Of a wing by its length (m) and chord along it (m); `has_wall`: its root stands on a wall, in which it is mirrored, and else
    /// has air around it like the tip.
    ///
    /// Glauert's series at as many stations, θ from the tip: Σ A_n sin nθ (n μ + sin θ) = μ α sin θ, μ = c a₀/(4b); with a wall, odd n alone.
    /// None where the chord makes no wing.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use std::f64::consts::PI;
    /// use washout::aero::LiftingLine;
    ///
    /// // an ellipse of aspect ratio 8, from tip to tip: 1/(π A) everywhere
    /// let chord_m = |r_m: f64| 4.0 / (8.0 * PI) * (1.0 - (2.0 * r_m - 1.0).powi(2)).max(0.0).sqrt();
    /// let line = LiftingLine::new(1.0, chord_m, false).unwrap();
    /// assert!((line.downwash_per_lift(0.3) * 8.0 * PI - 1.0).abs() < 0.01);
    /// ```
    pub fn new(length_m: f64, chord_m: impl Fn(f64) -> f64, has_wall: bool) -> Option<Self> {
        let span_m = if has_wall { 2.0 * length_m } else { length_m };
        let order = |k: usize| {
            if has_wall {
                2.0 * k as f64 + 1.0
            } else {
                k as f64 + 1.0
            }
        };
        let end = if has_wall { FRAC_PI_2 } else { PI };
        let station = |row: usize| end * (row as f64 + 0.5) / TERMS as f64;
        let share = |row: usize| {
            let chord_m = chord_m(place(station(row), length_m, has_wall)).max(0.0);
            0.25 * chord_m * SLOPE_PER_RAD / span_m
        };
        let matrix = DMatrix::from_fn(TERMS, TERMS, |row, column| {
            let (angle, order) = (station(row), order(column));
            (order * angle).sin() * (order * share(row) + angle.sin())
        });
        let side = DVector::from_fn(TERMS, |row, _| share(row) * station(row).sin());
        let found = matrix.lu().solve(&side)?;
        let terms: Vec<[f64; 2]> = (0..TERMS).map(|k| [order(k), order(k) * found[k]]).collect();
        let is_sound = found.iter().all(|term| term.is_finite()) && found[0] > 0.0;
        is_sound.then_some(LiftingLine {
            length_m,
            has_wall,
            terms,
        })
    }

    /// Angle of the downwash over the lift coefficient at a span position (m), rad: 1/(π A) all along an ellipse of aspect ratio A.
    pub fn downwash_per_lift(&self, r_m: f64) -> f64 {
        let place = (r_m / self.length_m).clamp(0.0, 1.0);
        let angle = if self.has_wall {
            place.acos()
        } else {
            (2.0 * place - 1.0).acos()
        };
        // at the very tip the series has its limit a little inside
        let angle = angle.clamp(1e-6, PI - 1e-6);
        let sum: f64 = self
            .terms
            .iter()
            .map(|[order, term]| term * (order * angle).sin())
            .sum();
        let downwash = (sum / angle.sin()).clamp(0.0, MOST);
        downwash / (SLOPE_PER_RAD * (1.0 - downwash))
    }
}

/// Most of the angle of attack that downwash may take: at a tip of full chord it takes all.
const MOST: f64 = 0.999;

/// Span position of a station of the series, m.
fn place(angle: f64, length_m: f64, has_wall: bool) -> f64 {
    if has_wall {
        length_m * angle.cos()
    } else {
        0.5 * length_m * (1.0 + angle.cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_downwash_of_an_ellipse_is_its_lift_over_pi_times_the_aspect_ratio_all_along() {
        for (has_wall, aspect) in [(true, 6.0), (false, 6.0)] {
            let span_m: f64 = if has_wall { 0.4 } else { 0.2 };
            let middle_m = if has_wall { 0.0 } else { 0.1 };
            let chord_m = |r_m: f64| {
                let place = 2.0 * (r_m - middle_m) / span_m;
                4.0 * span_m / (PI * aspect) * (1.0 - place * place).max(0.0).sqrt()
            };
            let line = LiftingLine::new(0.2, chord_m, has_wall).unwrap();
            for r_m in [0.0, 0.05, 0.13, 0.19] {
                let found = line.downwash_per_lift(r_m) * PI * aspect;
                assert!((found - 1.0).abs() < 1e-9, "{r_m} {found}");
            }
        }
    }

    /// Glauert 1926, The Elements of Aerofoil and Airscrew Theory, table 10: a = a₀/(1 + a₀ (1 + τ)/(π A)), τ = 0.16 at A = 6 and 0.20 at 8 nearly.
    #[test]
    fn the_lift_slope_of_a_rectangle_is_glauerts() {
        for (aspect, slope) in [(4.0, 4.02839), (6.0, 4.53042), (8.0, 4.83770)] {
            let (length_m, steps) = (0.1, 4000);
            let line = LiftingLine::new(length_m, |_| 2.0 * length_m / aspect, true).unwrap();
            let lift = |step: usize| {
                let r_m = length_m * (step as f64 + 0.5) / steps as f64;
                TAU / (1.0 + TAU * line.downwash_per_lift(r_m)) / steps as f64
            };
            let found: f64 = (0..steps).map(lift).sum();
            assert!((found / slope - 1.0).abs() < 1e-3, "{aspect}: {found}");
        }
    }

    #[test]
    fn a_rectangle_with_air_all_around_is_alike_at_both_its_ends() {
        let line = LiftingLine::new(0.1, |_| 0.02, false).unwrap();
        for r_m in [0.0, 0.01, 0.03] {
            let [here, there] = [r_m, 0.1 - r_m].map(|r_m| line.downwash_per_lift(r_m));
            assert!((here / there - 1.0).abs() < 1e-6, "{r_m}: {here} {there}");
        }
    }

    #[test]
    fn a_wing_without_chord_has_no_lifting_line() {
        assert_eq!(LiftingLine::new(0.1, |_| 0.0, true), None);
        assert_eq!(LiftingLine::new(0.1, |_| f64::NAN, true), None);
    }
}
