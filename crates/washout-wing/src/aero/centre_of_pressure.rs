//! Where the normal force acts on the chord, as a fraction from the leading edge.

use std::f64::consts::PI;

use super::number::Number;

/// A law of the centre of pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CentreOfPressureLaw {
    /// Dickson, Straw & Dickinson 2006: x_cp = 0.82 |α|/π + 0.05, from 0.05 at 0 to 0.87 at 180°.
    /// Its kink at α = 0 does not reach the moment, because the force is zero there.
    Dickson,
    /// Public code of the Purdue hummingbird robot:
    /// x_cp = 0.46 − 0.332 cos α − 0.037 cos 3α − 0.013 cos 5α, from 0.078 at 0 to 0.842 at 180°.
    Purdue,
    /// The same fraction at every angle.
    Fixed {
        /// Fraction of the chord from the leading edge.
        fraction: f64,
    },
}

impl CentreOfPressureLaw {
    /// Fraction of the chord from the leading edge at the angle of attack `alpha`, rad in (−π, π].
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::aero::CentreOfPressureLaw;
    ///
    /// let at_90_deg = CentreOfPressureLaw::Dickson.fraction(std::f64::consts::FRAC_PI_2);
    /// assert!((at_90_deg - 0.46).abs() < 1e-12);
    /// ```
    pub fn fraction<D: Number>(&self, alpha: D) -> D {
        match *self {
            CentreOfPressureLaw::Dickson => {
                let size = if alpha.re() < 0.0 { -alpha } else { alpha };
                size * (0.82 / PI) + 0.05
            }
            CentreOfPressureLaw::Purdue => {
                -alpha.cos() * 0.332 - (alpha * 3.0).cos() * 0.037 - (alpha * 5.0).cos() * 0.013 + 0.46
            }
            CentreOfPressureLaw::Fixed { fraction } => alpha * 0.0 + fraction,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::CentreOfPressureLaw;
    use std::f64::consts::PI;

    #[test]
    fn hand_values_at_0_45_90_and_180_degrees() {
        let dickson = |alpha: f64| CentreOfPressureLaw::Dickson.fraction(alpha);
        for (alpha, expected) in [(0.0, 0.05), (PI / 4.0, 0.255), (-PI / 2.0, 0.46), (PI, 0.87)] {
            assert!((dickson(alpha) - expected).abs() < 1e-14, "{alpha}");
        }
        let purdue = |alpha: f64| CentreOfPressureLaw::Purdue.fraction(alpha);
        // At 45°: 0.46 + (−0.332 + 0.037 + 0.013)/√2
        for (alpha, expected) in [
            (0.0, 0.078),
            (-PI / 4.0, 0.460 - 0.282 / 2.0_f64.sqrt()),
            (PI / 2.0, 0.46),
        ] {
            assert!((purdue(alpha) - expected).abs() < 1e-14, "{alpha}");
        }
        assert_eq!(CentreOfPressureLaw::Fixed { fraction: 0.25 }.fraction(1.0), 0.25);
    }

    #[test]
    fn every_law_stays_on_the_chord() {
        for law in [CentreOfPressureLaw::Dickson, CentreOfPressureLaw::Purdue] {
            for step in -1800..=1800 {
                let fraction = law.fraction(f64::from(step) * 0.1_f64.to_radians());
                assert!((0.04..=0.88).contains(&fraction), "{law:?} {step}: {fraction}");
            }
        }
    }
}
