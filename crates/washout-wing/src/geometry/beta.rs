//! Chord from a beta distribution (Ellington 1984, part II).

use statrs::function::beta::ln_beta;

/// Chord distribution ĉ(x̂) = x̂^(p−1) (1−x̂)^(q−1) / B(p,q); its mean over 0 … 1 is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BetaChord {
    /// Exponent p of the base.
    pub p: f64,
    /// Exponent q of the tip.
    pub q: f64,
    ln_beta: f64,
}

impl BetaChord {
    /// From the non-dimensional radii of the first and second moment of area; `None` if no beta
    /// distribution has them (it needs r̂₁² < r̂₂² < r̂₁ < 1).
    ///
    /// p = r̂₁ [r̂₁(1−r̂₁)/(r̂₂²−r̂₁²) − 1], q = (1−r̂₁) times the same bracket; Ellington 1984.
    pub fn from_radii(r1_hat: f64, r2_hat: f64) -> Option<BetaChord> {
        let variance = r2_hat * r2_hat - r1_hat * r1_hat;
        if !(r1_hat > 0.0 && r1_hat < 1.0 && variance > 0.0) {
            return None;
        }
        let bracket = r1_hat * (1.0 - r1_hat) / variance - 1.0;
        let (p, q) = (r1_hat * bracket, (1.0 - r1_hat) * bracket);
        if !(p > 0.0 && q > 0.0 && p.is_finite() && q.is_finite()) {
            return None;
        }
        Some(BetaChord {
            p,
            q,
            ln_beta: ln_beta(p, q),
        })
    }

    /// Chord over mean chord at x̂, strictly between 0 and 1 (elsewhere it may be 0 or infinite).
    pub fn chord_hat(&self, x_hat: f64) -> f64 {
        ((self.p - 1.0) * x_hat.ln() + (self.q - 1.0) * (-x_hat).ln_1p() - self.ln_beta).exp()
    }
}

/// Ellington's regression of the first on the second moment, solved for r̂₁: r̂₂ = 0.929 r̂₁^0.732.
pub fn r1_hat_by_regression(r2_hat: f64) -> f64 {
    (r2_hat / 0.929).powf(1.0 / 0.732)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_wing_has_the_exponents_of_ellingtons_regression() {
        let r1 = r1_hat_by_regression(0.54);
        assert!((r1 - 0.4766).abs() < 5e-5, "{r1}");
        let beta = BetaChord::from_radii(r1, 0.54).unwrap();
        assert!((beta.p - 1.367).abs() < 5e-4, "{}", beta.p);
        assert!((beta.q - 1.501).abs() < 5e-4, "{}", beta.q);
        let largest = (1..1000)
            .map(|i| beta.chord_hat(f64::from(i) / 1000.0))
            .fold(0.0, f64::max);
        assert!((20.5 * largest - 25.6).abs() < 0.05, "{}", 20.5 * largest);
    }

    #[test]
    fn a_uniform_chord_has_p_and_q_of_one() {
        let beta = BetaChord::from_radii(0.5, (1.0f64 / 3.0).sqrt()).unwrap();
        assert!((beta.chord_hat(0.02) - 1.0).abs() < 1e-12 && (beta.chord_hat(0.99) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn impossible_radii_are_refused() {
        for (r1, r2) in [
            (0.6, 0.55),
            (0.5, 0.5),
            (0.25, 0.51),
            (1.2, 1.3),
            (-0.1, 0.5),
            (f64::NAN, 0.5),
        ] {
            assert_eq!(BetaChord::from_radii(r1, r2), None, "{r1} {r2}");
        }
    }
}
