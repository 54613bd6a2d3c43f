//! Lift and drag coefficients from a table, joined by a monotone cubic (Fritsch & Butland 1984).
//!
//! A table that starts at 0° is continued to negative angles with C_L odd and C_D even (smoothed within 1°
//! where the values at 0° would leave a step or kink). A table with negative angles is taken as it is, so a
//! cambered airfoil can be given. Beyond its ends a table holds its last values, so that an iteration may pass
//! through; [`CoefficientTable::check`] refuses such an angle, and every converged result is checked with it.

use super::error::AeroError;
use super::join::{SMOOTHING_RAD, even_join, odd_join};
use super::number::Number;

/// Coefficients against the angle of attack.
#[derive(Debug, Clone, PartialEq)]
pub struct CoefficientTable {
    alpha_rad: Vec<f64>,
    lift: Curve,
    drag: Curve,
    symmetric: bool,
}

/// Values and slopes of one column.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    value: Vec<f64>,
    slope_per_rad: Vec<f64>,
}

impl CoefficientTable {
    /// A table from rows `[alpha_deg, cl, cd]`, alpha rising.
    ///
    /// # Errors
    /// Fewer than 2 rows, values that are not finite, angles that do not rise or exceed one turn.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::aero::table::CoefficientTable;
    ///
    /// let table = CoefficientTable::new(&[[0.0, 0.0, 0.1], [45.0, 1.6, 1.5], [90.0, 0.0, 3.0]])?;
    /// let (cl, cd) = table.lift_and_drag(45_f64.to_radians());
    /// assert!((cl - 1.6).abs() < 1e-9 && (cd - 1.5).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(rows: &[[f64; 3]]) -> Result<Self, AeroError> {
        if rows.len() < 2 {
            return Err(AeroError::TableTooShort { rows: rows.len() });
        }
        for (index, row) in rows.iter().enumerate() {
            if row.iter().any(|value| !value.is_finite()) {
                return Err(AeroError::TableNotFinite { row: index + 1 });
            }
            if row[0].abs() > 180.0 {
                return Err(AeroError::TableAngle {
                    row: index + 1,
                    alpha_deg: row[0],
                });
            }
            if index > 0 && row[0] <= rows[index - 1][0] {
                return Err(AeroError::TableNotRising {
                    row: index + 1,
                    alpha_deg: row[0],
                    previous_deg: rows[index - 1][0],
                });
            }
        }
        let alpha_rad: Vec<f64> = rows.iter().map(|row| row[0].to_radians()).collect();
        Ok(CoefficientTable {
            lift: Curve::new(&alpha_rad, rows.iter().map(|row| row[1]).collect()),
            drag: Curve::new(&alpha_rad, rows.iter().map(|row| row[2]).collect()),
            symmetric: rows[0][0] == 0.0,
            alpha_rad,
        })
    }

    /// Smallest and largest angle that the table covers, rad, its continuation included.
    pub fn range_rad(&self) -> [f64; 2] {
        let high = self.alpha_rad[self.alpha_rad.len() - 1];
        [if self.symmetric { -high } else { self.alpha_rad[0] }, high]
    }

    /// Refuses an angle of attack (rad) that the table does not cover.
    ///
    /// # Errors
    /// [`AeroError::OutsideTable`].
    pub fn check(&self, alpha_rad: f64) -> Result<(), AeroError> {
        let [low, high] = self.range_rad();
        if (low..=high).contains(&alpha_rad) {
            return Ok(());
        }
        Err(AeroError::OutsideTable {
            alpha_deg: alpha_rad.to_degrees(),
            low_deg: low.to_degrees(),
            high_deg: high.to_degrees(),
        })
    }

    /// Lift and drag coefficient at `alpha`, rad; held at the end values outside the table.
    pub fn lift_and_drag<D: Number>(&self, alpha: D) -> (D, D) {
        if !self.symmetric {
            return (self.at(&self.lift, alpha), self.at(&self.drag, alpha));
        }
        let (angle, sign) = if alpha.re() < 0.0 {
            (-alpha, -1.0)
        } else {
            (alpha, 1.0)
        };
        let width = SMOOTHING_RAD.min(self.alpha_rad[1]);
        if angle.re() >= width {
            return (self.at(&self.lift, angle) * sign, self.at(&self.drag, angle));
        }
        let (lift, lift_slope) = self.value_and_slope(&self.lift, width);
        let (drag, drag_slope) = self.value_and_slope(&self.drag, width);
        (
            odd_join(angle, width, lift, lift_slope) * sign,
            even_join(angle, width, drag, drag_slope),
        )
    }

    fn at<D: Number>(&self, curve: &Curve, alpha: D) -> D {
        let last = self.alpha_rad.len() - 1;
        if alpha.re() <= self.alpha_rad[0] {
            return alpha * 0.0 + curve.value[0];
        }
        if alpha.re() >= self.alpha_rad[last] {
            return alpha * 0.0 + curve.value[last];
        }
        let right = self
            .alpha_rad
            .partition_point(|angle| *angle <= alpha.re())
            // below no angle stands only what is not a number
            .clamp(1, last);
        let left = right - 1;
        let width = self.alpha_rad[right] - self.alpha_rad[left];
        let t = (alpha - self.alpha_rad[left]) / width;
        let rise = t * t * (-t * 2.0 + 3.0);
        let bow = t * (-t + 1.0) * width;
        (-rise + 1.0) * curve.value[left]
            + rise * curve.value[right]
            + bow * ((-t + 1.0) * curve.slope_per_rad[left] - t * curve.slope_per_rad[right])
    }

    fn value_and_slope(&self, curve: &Curve, alpha_rad: f64) -> (f64, f64) {
        let dual = self.at(curve, num_dual::Dual64::new(alpha_rad, 1.0));
        (dual.re, dual.eps)
    }
}

impl Curve {
    fn new(x: &[f64], value: Vec<f64>) -> Self {
        let count = x.len();
        let width: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let secant: Vec<f64> = (0..count - 1)
            .map(|i| (value[i + 1] - value[i]) / width[i])
            .collect();
        let mut slope_per_rad = vec![0.0; count];
        for i in 1..count - 1 {
            let (before, after) = (secant[i - 1], secant[i]);
            if before * after > 0.0 {
                let (w1, w2) = (2.0 * width[i] + width[i - 1], width[i] + 2.0 * width[i - 1]);
                slope_per_rad[i] = (w1 + w2) / (w1 / before + w2 / after);
            }
        }
        slope_per_rad[0] = end_slope(&width, &secant, 0, 1);
        slope_per_rad[count - 1] = end_slope(&width, &secant, count - 2, count.saturating_sub(3));
        Curve { value, slope_per_rad }
    }
}

/// Three-point slope at an end, limited so that the curve stays monotone.
fn end_slope(width: &[f64], secant: &[f64], end: usize, next: usize) -> f64 {
    if secant.len() < 2 {
        return secant[end];
    }
    let slope = ((2.0 * width[end] + width[next]) * secant[end] - width[end] * secant[next])
        / (width[end] + width[next]);
    if slope * secant[end] <= 0.0 {
        0.0
    } else if secant[end] * secant[next] <= 0.0 && slope.abs() > 3.0 * secant[end].abs() {
        3.0 * secant[end]
    } else {
        slope
    }
}

#[cfg(test)]
mod tests {
    use super::CoefficientTable;
    use crate::aero::coefficients::CoefficientLaw;
    use crate::aero::error::AeroError;
    use num_dual::Dual64;

    fn table() -> CoefficientTable {
        let rows = [
            [0.0, 0.03, 0.39],
            [10.0, 0.7, 0.45],
            [30.0, 1.6, 1.0],
            [45.0, 1.8, 1.7],
            [90.0, 0.1, 3.4],
        ];
        CoefficientTable::new(&rows).expect("a good table")
    }

    #[test]
    fn values_at_the_rows_are_the_rows_and_the_sign_follows_the_angle() {
        for (degrees, cl, cd) in [
            (10.0_f64, 0.7, 0.45),
            (30.0, 1.6, 1.0),
            (45.0, 1.8, 1.7),
            (90.0, 0.1, 3.4),
        ] {
            let (lift, drag) = table().lift_and_drag(degrees.to_radians());
            assert!(
                (lift - cl).abs() < 1e-12 && (drag - cd).abs() < 1e-12,
                "{degrees}"
            );
            let (lift, drag) = table().lift_and_drag(-degrees.to_radians());
            assert!(
                (lift + cl).abs() < 1e-12 && (drag - cd).abs() < 1e-12,
                "-{degrees}"
            );
        }
        assert_eq!(table().lift_and_drag(0.0).0, 0.0);
    }

    #[test]
    fn between_rows_the_curve_stays_between_their_values() {
        for step in 0..=1000 {
            let degrees = 10.0 + 80.0 * f64::from(step) / 1000.0;
            let (lift, drag) = table().lift_and_drag(degrees.to_radians());
            assert!(
                (0.1..=1.8 + 1e-12).contains(&lift) && (0.45..=3.4 + 1e-12).contains(&drag),
                "{degrees}"
            );
        }
    }

    #[test]
    fn the_curve_has_no_step_and_no_kink() {
        let tiny = 1e-9;
        for degrees in [-30.0, -1.0, 0.0, 1.0, 10.0, 30.0, 45.0, 60.0] {
            let joint = f64::to_radians(degrees);
            let below = table().lift_and_drag(Dual64::new(joint - tiny, 1.0));
            let above = table().lift_and_drag(Dual64::new(joint + tiny, 1.0));
            assert!(
                (below.0.re - above.0.re).abs() < 1e-7 && (below.1.re - above.1.re).abs() < 1e-7,
                "{degrees}"
            );
            assert!(
                (below.0.eps - above.0.eps).abs() < 1e-5 && (below.1.eps - above.1.eps).abs() < 1e-5,
                "{degrees}"
            );
        }
    }

    #[test]
    fn a_dense_table_of_dickinson_gives_dickinson() {
        let rows: Vec<[f64; 3]> = (0..=90)
            .map(|degrees| {
                let (cl, cd) = CoefficientLaw::Dickinson.lift_and_drag(f64::from(degrees).to_radians());
                [f64::from(degrees), cl, cd]
            })
            .collect();
        let table = CoefficientTable::new(&rows).expect("a good table");
        // Between the rows at 2 and 88 degrees: outside them the slope of the law itself jumps within a gap.
        for step in 20..=880 {
            let alpha = f64::from(step) * 0.1_f64.to_radians();
            let (cl, cd) = table.lift_and_drag(alpha);
            let (cl_law, cd_law) = CoefficientLaw::Dickinson.lift_and_drag(alpha);
            assert!(
                (cl - cl_law).abs() < 1e-3 && (cd - cd_law).abs() < 1e-3,
                "{alpha}"
            );
        }
    }

    #[test]
    fn two_rows_are_a_straight_line_through_negative_angles() {
        let table = CoefficientTable::new(&[[-10.0, -0.9, 0.02], [10.0, 1.1, 0.04]]).expect("a good table");
        let (lift, drag) = table.lift_and_drag(5.0_f64.to_radians());
        assert!((lift - 0.6).abs() < 1e-12 && (drag - 0.035).abs() < 1e-12);
    }

    #[test]
    fn an_angle_outside_the_table_is_held_and_then_refused_with_the_cure() {
        assert!((table().lift_and_drag(2.0_f64).0 - 0.1).abs() < 1e-12);
        assert_eq!(table().check(-1.5), Ok(()));
        let error = table().check(100.0_f64.to_radians()).expect_err("outside");
        assert_eq!(
            error.to_string(),
            "the angle of attack 100.000 deg lies outside the table of air coefficients, which covers [-90, 90] \
             deg; extend the table or choose air.coefficients = \"dickinson\""
        );
        assert!(table().check(f64::NAN).is_err());
    }

    #[test]
    fn bad_tables_are_refused_with_their_row() {
        let new = |rows: &[[f64; 3]]| CoefficientTable::new(rows).expect_err("bad");
        assert_eq!(new(&[[0.0, 0.0, 0.0]]), AeroError::TableTooShort { rows: 1 });
        assert_eq!(
            new(&[[0.0; 3], [1.0, f64::NAN, 0.0]]),
            AeroError::TableNotFinite { row: 2 }
        );
        let same = AeroError::TableNotRising {
            row: 2,
            alpha_deg: 0.0,
            previous_deg: 0.0,
        };
        assert_eq!(new(&[[0.0; 3], [0.0; 3]]), same);
        let turn = AeroError::TableAngle {
            row: 2,
            alpha_deg: 200.0,
        };
        assert_eq!(new(&[[0.0; 3], [200.0, 0.0, 0.0]]), turn);
    }
}
