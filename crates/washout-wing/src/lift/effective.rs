//! Effective coefficients: what a measured lift and power say of the modelled coefficients.
//!
//! The paper scales modelled lift and power to the measured ones and calls the scale the effective coefficient. A
//! ratio of 1 means that the quasi-steady model explains the measurement.

use super::error::LiftError;
use super::ratios::{Ratios, positive};

/// Effective coefficients of a wing, each over that of the reference wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EffectiveCoefficients {
    /// Effective lift coefficient: measured over modelled lift ratio.
    pub lift: f64,
    /// Effective drag coefficient: measured over modelled power ratio; absent without a measured efficiency.
    pub drag: Option<f64>,
}

impl EffectiveCoefficients {
    /// From the modelled ratios as the wings were flown (frequency and amplitude each its own), the measured lift
    /// ratio, and the measured ratio of lift per power where there is one. If the measured efficiency was taken at
    /// another condition than the lift (equal power, say), leave it out.
    ///
    /// # Errors
    /// [`LiftError::NoRatio`] for measured ratios that are not positive.
    pub fn new(
        modelled: &Ratios,
        measured_lift: f64,
        measured_lift_per_power: Option<f64>,
    ) -> Result<EffectiveCoefficients, LiftError> {
        let drag = measured_lift_per_power
            .map(|efficiency| {
                positive("the ratio of lift per power", "measurement", efficiency)?;
                effective_coefficient_ratio(measured_lift / efficiency, modelled.power)
            })
            .transpose()?;
        Ok(EffectiveCoefficients {
            lift: effective_coefficient_ratio(measured_lift, modelled.lift)?,
            drag,
        })
    }
}

/// Effective coefficient ratio: measured over modelled ratio (of lift for the lift coefficient, of power for the drag
/// coefficient).
///
/// # Errors
/// [`LiftError::NoRatio`] for ratios that are not positive.
pub fn effective_coefficient_ratio(measured_ratio: f64, modelled_ratio: f64) -> Result<f64, LiftError> {
    positive("the ratio", "measurement", measured_ratio)?;
    positive("the ratio", "model", modelled_ratio)?;
    Ok(measured_ratio / modelled_ratio)
}

/// Amplitude ratio Φ/Φ_reference that a quasi-steady lift ratio implies, given the lift ratio at equal fΦ and the
/// ratio of frequencies: lift goes with (fΦ)².
///
/// # Errors
/// [`LiftError::NoRatio`] for ratios that are not positive.
pub fn implied_amplitude_ratio(
    lift_ratio: f64,
    lift_ratio_at_equal_rate: f64,
    frequency_ratio: f64,
) -> Result<f64, LiftError> {
    positive("the lift ratio", "wing", lift_ratio)?;
    positive("the lift ratio at equal fΦ", "wing", lift_ratio_at_equal_rate)?;
    positive("the frequency ratio", "wing", frequency_ratio)?;
    Ok((lift_ratio / lift_ratio_at_equal_rate).sqrt() / frequency_ratio)
}

#[cfg(test)]
mod tests {
    use super::{EffectiveCoefficients, effective_coefficient_ratio, implied_amplitude_ratio};
    use crate::lift::paper;
    use crate::lift::ratios::Ratios;
    use crate::lift::stroke::stroke_means;
    use crate::lift::twist::{TwistAlongSpan, TwistHistory};

    fn modelled(twist: TwistAlongSpan, rate_ratio: f64) -> Ratios {
        let means = |twist| {
            let twist = TwistHistory::paper_ramp(twist);
            stroke_means(&paper::planform(), &paper::law(), &paper::stroke(21.0), &twist).expect("means")
        };
        let ratios = Ratios::between(&means(twist), &means(TwistAlongSpan::flat())).expect("ratios");
        ratios.at_rate_ratio(rate_ratio).expect("a rate")
    }

    #[test]
    fn the_papers_own_numbers_close() {
        // Measured +35.3 %, quasi-steady 0.827 of the rigid wing: effective +63.6 %.
        let ratio = effective_coefficient_ratio(1.353, 0.827).expect("ratio");
        assert!((ratio - 1.636).abs() < 1e-3, "{ratio}");
    }

    #[test]
    fn with_the_implied_amplitude_both_wings_have_the_papers_effective_lift() {
        for (twist, frequency, lift, effective) in [
            (paper::twist_v1(), 22.0 / 21.0, 1.353, 1.636),
            (paper::twist_v2(), 23.0 / 21.0, 1.177, 1.133),
        ] {
            // One amplitude ratio for both wings, 0.9785: that two numbers follow from one is the check.
            let ratios = modelled(twist, frequency * 0.9785);
            let found = EffectiveCoefficients::new(&ratios, lift, None)
                .expect("ratios")
                .lift;
            assert!((found / effective - 1.0).abs() < 5e-3, "{found} {effective}");
        }
    }

    #[test]
    fn effective_drag_is_measured_over_modelled_power() {
        let ratios = modelled(paper::twist_v1(), 1.0);
        let found = EffectiveCoefficients::new(&ratios, ratios.lift * 1.5, Some(ratios.lift_per_power * 1.2));
        let found = found.expect("ratios");
        assert!((found.lift - 1.5).abs() < 1e-12);
        assert!((found.drag.expect("efficiency") - 1.25).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_ratio_is_refused() {
        let ratios = modelled(paper::twist_v2(), 1.0);
        assert!(EffectiveCoefficients::new(&ratios, -1.0, None).is_err());
        assert!(EffectiveCoefficients::new(&ratios, 1.0, Some(0.0)).is_err());
        assert!(effective_coefficient_ratio(f64::NAN, 1.0).is_err());
        assert!(implied_amplitude_ratio(1.0, 0.0, 1.0).is_err());
    }
}
