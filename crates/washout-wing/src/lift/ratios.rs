//! A wing against a reference wing, in the paper's metrics; each power condition by its own name.
//!
//! With the twist kept, forces grow with (fΦ)² and power with (fΦ)³, so the conditions follow from one
//! computation: lift ratio ℓ and power ratio p at equal fΦ give lift per power ℓ/p at equal fΦ, lift ℓ p^(−2/3) at
//! equal power, lift per power ℓ^(3/2)/p at equal lift.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::LiftError;
use super::means::StrokeMeans;

/// Ratios of a wing to a reference, the wing at `rate_ratio` times the reference's fΦ.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Ratios {
    /// fΦ of the wing over that of the reference.
    pub rate_ratio: f64,
    /// Mean lift: span integral of the stroke-mean lift distribution (the paper's lift).
    pub lift: f64,
    /// Mean drag.
    pub drag: f64,
    /// Mean aerodynamic power.
    pub power: f64,
    /// Mean lift over mean drag; the same at every fΦ.
    pub lift_to_drag: f64,
    /// Span integral of the local L/D curve (the paper's Fig. 6d, rigid = 1); the same at every fΦ.
    pub local_lift_to_drag: f64,
    /// Mean lift per mean power at this rate ratio.
    pub lift_per_power: f64,
    /// Lift, and lift per power, with the fΦ of the wing changed until both take the same power.
    pub lift_at_equal_power: f64,
    /// Lift per power with the fΦ of the wing changed until both lift the same.
    pub lift_per_power_at_equal_lift: f64,
}

impl Ratios {
    /// As both were computed, each at its own fΦ.
    ///
    /// # Errors
    /// [`LiftError::NoRatio`] unless both wings have positive lift, drag and power.
    pub fn between(wing: &StrokeMeans, reference: &StrokeMeans) -> Result<Ratios, LiftError> {
        for (name, means) in [("wing", wing), ("reference", reference)] {
            for (what, value) in [
                ("the mean lift (N)", means.lift_n),
                ("the mean drag (N)", means.drag_n),
                ("the mean power (W)", means.power_w),
            ] {
                positive(what, name, value)?;
            }
        }
        let lift = wing.lift_n / reference.lift_n;
        let drag = wing.drag_n / reference.drag_n;
        let power = wing.power_w / reference.power_w;
        Ok(Ratios {
            rate_ratio: wing.peak_rate_rad_s / reference.peak_rate_rad_s,
            lift,
            drag,
            power,
            lift_to_drag: lift / drag,
            local_lift_to_drag: mean_local_lift_to_drag(wing) / mean_local_lift_to_drag(reference),
            lift_per_power: lift / power,
            lift_at_equal_power: lift * power.powf(-2.0 / 3.0),
            lift_per_power_at_equal_lift: lift.powf(1.5) / power,
        })
    }

    /// The ratios: the key of each in documents, its name, its value.
    pub fn named(&self) -> [(&'static str, &'static str, f64); 8] {
        [
            ("lift", "lift", self.lift),
            ("drag", "drag", self.drag),
            ("power", "power", self.power),
            ("lift_to_drag", "lift over drag", self.lift_to_drag),
            (
                "local_lift_to_drag",
                "local lift over drag along the span",
                self.local_lift_to_drag,
            ),
            ("lift_per_power", "lift per power", self.lift_per_power),
            (
                "lift_at_equal_power",
                "lift at equal power",
                self.lift_at_equal_power,
            ),
            (
                "lift_per_power_at_equal_lift",
                "lift per power at equal lift",
                self.lift_per_power_at_equal_lift,
            ),
        ]
    }

    /// The same wings with the same twist, the wing at another multiple of the reference's fΦ: 1 compares at equal
    /// fΦ, the ratio of frequencies at equal Φ.
    ///
    /// # Errors
    /// [`LiftError::NoRatio`] for a rate ratio that is not positive.
    pub fn at_rate_ratio(&self, rate_ratio: f64) -> Result<Ratios, LiftError> {
        positive("the ratio of fΦ", "wing", rate_ratio)?;
        let factor = rate_ratio / self.rate_ratio;
        Ok(Ratios {
            rate_ratio,
            lift: self.lift * factor.powi(2),
            drag: self.drag * factor.powi(2),
            power: self.power * factor.powi(3),
            lift_per_power: self.lift_per_power / factor,
            ..*self
        })
    }
}

/// Mean along the built span of the local ratio of mean lift to mean drag.
pub fn mean_local_lift_to_drag(means: &StrokeMeans) -> f64 {
    let (mut sum, mut span_m) = (0.0, 0.0);
    for station in means.stations.iter().filter(|station| station.drag_n_per_m > 0.0) {
        sum += station.width_m * station.lift_n_per_m / station.drag_n_per_m;
        span_m += station.width_m;
    }
    if span_m > 0.0 { sum / span_m } else { 0.0 }
}

/// Refuses what no ratio can be formed with.
pub(super) fn positive(what: &'static str, wing: &'static str, value: f64) -> Result<(), LiftError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(LiftError::NoRatio { what, wing, value })
}

#[cfg(test)]
mod tests {
    use super::Ratios;
    use crate::geometry::Planform;
    use crate::lift::effective::implied_amplitude_ratio;
    use crate::lift::means::StrokeMeans;
    use crate::lift::paper;
    use crate::lift::stroke::stroke_means;
    use crate::lift::twist::{TwistAlongSpan, TwistHistory};

    fn means(planform: &Planform, twist: TwistAlongSpan, frequency_hz: f64) -> StrokeMeans {
        stroke_means(
            planform,
            &paper::law(),
            &paper::stroke(frequency_hz),
            &TwistHistory::paper_ramp(twist),
        )
        .expect("means")
    }

    fn against_rigid(planform: &Planform, twist: TwistAlongSpan, frequency_hz: f64) -> Ratios {
        let rigid = means(planform, TwistAlongSpan::flat(), 21.0);
        Ratios::between(&means(planform, twist, frequency_hz), &rigid).expect("ratios")
    }

    fn close(value: f64, expected: f64, relative: f64, what: &str) {
        assert!(
            (value / expected - 1.0).abs() < relative,
            "{what}: {value}, expected {expected}"
        );
    }

    /// Lift, drag, L/D and lift per power at equal fΦ; lift per power at equal Φ; implied amplitude ratio.
    fn amplitude_free_checks(planform: &Planform, relative: f64) {
        let v1 = (
            paper::twist_v1(),
            22.0,
            1.353 / 1.636,
            [0.786, 0.579, 1.357, 1.481, 1.414, 0.979],
        );
        let v2 = (
            paper::twist_v2(),
            23.0,
            1.177 / 1.133,
            [0.905, 0.701, 1.290, 1.375, 1.255, 0.978],
        );
        for (twist, frequency_hz, quasi_steady_lift, expected) in [v1, v2] {
            let as_flown = against_rigid(planform, twist, frequency_hz);
            let equal = as_flown.at_rate_ratio(1.0).expect("equal");
            let amplitude =
                implied_amplitude_ratio(quasi_steady_lift, equal.lift, frequency_hz / 21.0).expect("ratio");
            close(equal.lift, expected[0], relative, "lift");
            close(equal.drag, expected[1], relative, "drag");
            close(equal.lift_to_drag, expected[2], relative, "lift to drag");
            close(
                equal.lift_per_power,
                expected[3],
                relative,
                "lift per power at equal fΦ",
            );
            close(
                as_flown.lift_per_power,
                expected[4],
                relative,
                "lift per power at equal Φ",
            );
            close(amplitude, expected[5], relative, "implied amplitude ratio");
        }
    }

    #[test]
    fn the_papers_twists_give_the_amplitude_free_ratios_on_the_built_wing() {
        amplitude_free_checks(&paper::planform(), 5e-3);
    }

    #[test]
    fn on_the_unclosed_planform_the_ratios_agree_to_their_last_digit() {
        amplitude_free_checks(&paper::planform_unclosed(), 1e-3);
    }

    #[test]
    fn the_conditions_of_power_agree_with_wings_brought_there() {
        let rigid = means(&paper::planform(), TwistAlongSpan::flat(), 21.0);
        let wing = means(&paper::planform(), paper::twist_v1(), 22.0);
        let ratios = Ratios::between(&wing, &rigid).expect("ratios");
        let equal_power = wing
            .at_rate(wing.peak_rate_rad_s * (rigid.power_w / wing.power_w).cbrt())
            .expect("moves");
        close(equal_power.power_w, rigid.power_w, 1e-12, "power");
        close(
            equal_power.lift_n / rigid.lift_n,
            ratios.lift_at_equal_power,
            1e-12,
            "lift at equal power",
        );
        let equal_lift = wing
            .at_rate(wing.peak_rate_rad_s * (rigid.lift_n / wing.lift_n).sqrt())
            .expect("moves");
        let there = Ratios::between(&equal_lift, &rigid).expect("ratios");
        close(there.lift, 1.0, 1e-12, "lift");
        close(
            there.lift_per_power,
            ratios.lift_per_power_at_equal_lift,
            1e-12,
            "lift per power at equal lift",
        );
        close(
            there.lift_at_equal_power,
            ratios.lift_at_equal_power,
            1e-12,
            "independent of fΦ",
        );
    }

    #[test]
    fn a_wing_against_itself_is_one_in_every_ratio() {
        let rigid = means(&paper::planform(), TwistAlongSpan::flat(), 21.0);
        let same = Ratios::between(&rigid, &rigid).expect("ratios");
        for ratio in [
            same.lift,
            same.power,
            same.lift_to_drag,
            same.local_lift_to_drag,
            same.lift_at_equal_power,
        ] {
            assert_eq!(ratio, 1.0);
        }
    }

    #[test]
    fn no_ratio_is_formed_with_nothing() {
        let rigid = means(&paper::planform(), TwistAlongSpan::flat(), 21.0);
        let still = means(&paper::planform(), TwistAlongSpan::flat(), 0.0);
        let error = Ratios::between(&rigid, &still).expect_err("no force");
        assert_eq!(
            error.to_string(),
            "the mean lift (N) of the reference is 0, so no ratio can be formed; choose a wing, a stroke and a twist \
             (below the stop angle) that give some"
        );
    }
}
