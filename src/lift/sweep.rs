//! Lift against aerodynamic power over a sweep of the amplitude (the paper's Fig. 6a, there over four voltages).

use crate::geometry::Planform;

use super::blade::BladeLaw;
use super::error::LiftError;
use super::stroke::{Stroke, stroke_means};
use super::twist::TwistHistory;

/// Stroke means of one wing at one amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmplitudePoint {
    /// Half of the peak-to-peak stroke angle, rad.
    pub half_amplitude_rad: f64,
    /// Mean lift, N.
    pub lift_n: f64,
    /// Mean drag, N.
    pub drag_n: f64,
    /// Mean aerodynamic power, W.
    pub power_w: f64,
}

/// Sweeps the half amplitude (rad) at the frequency and stop of `stroke`; `twist_at` gives the twist of each
/// amplitude: the same for a stiff or measured profile, a coupled solve for a flexible wing.
///
/// # Errors
/// What `twist_at` returns; [`LiftError`] of the means; an amplitude that is negative or not finite.
pub fn amplitude_sweep<E: From<LiftError>>(
    planform: &Planform,
    law: &impl BladeLaw,
    stroke: &Stroke,
    half_amplitudes_rad: &[f64],
    mut twist_at: impl FnMut(&Stroke) -> Result<TwistHistory, E>,
) -> Result<Vec<AmplitudePoint>, E> {
    let mut points = Vec::with_capacity(half_amplitudes_rad.len());
    for &half_amplitude_rad in half_amplitudes_rad {
        if !(half_amplitude_rad >= 0.0 && half_amplitude_rad.is_finite()) {
            let error = LiftError::BadStroke {
                name: "half amplitude (rad)",
                value: half_amplitude_rad,
            };
            return Err(error.into());
        }
        let stroke = Stroke {
            half_amplitude_rad,
            ..*stroke
        };
        let twist = twist_at(&stroke)?;
        let means = stroke_means(planform, law, &stroke, &twist)?;
        points.push(AmplitudePoint {
            half_amplitude_rad,
            lift_n: means.lift_n,
            drag_n: means.drag_n,
            power_w: means.power_w,
        });
    }
    Ok(points)
}

/// Lift at a given power (W) on a sweep whose power rises, N: a power law between neighbours, exact while the twist
/// stays the same. `None` outside the sweep, and where a neighbour has no positive lift or power.
pub fn lift_at_power(points: &[AmplitudePoint], power_w: f64) -> Option<f64> {
    points.windows(2).find_map(|pair| {
        let [low, high] = [pair[0], pair[1]];
        let usable = low.power_w > 0.0 && high.power_w > low.power_w && low.lift_n > 0.0 && high.lift_n > 0.0;
        if !(usable && (low.power_w..=high.power_w).contains(&power_w)) {
            return None;
        }
        let share = (power_w / low.power_w).ln() / (high.power_w / low.power_w).ln();
        Some(low.lift_n * (share * (high.lift_n / low.lift_n).ln()).exp())
    })
}

#[cfg(test)]
mod tests {
    use super::{AmplitudePoint, amplitude_sweep, lift_at_power};
    use crate::lift::error::LiftError;
    use crate::lift::paper;
    use crate::lift::ratios::Ratios;
    use crate::lift::stroke::{Stroke, stroke_means};
    use crate::lift::twist::{TwistAlongSpan, TwistHistory};

    fn sweep(twist: &TwistAlongSpan, frequency_hz: f64) -> Vec<AmplitudePoint> {
        let amplitudes_rad: Vec<f64> = (24..=45).map(|degrees| f64::from(degrees).to_radians()).collect();
        let twist_at = |_: &Stroke| Ok::<_, LiftError>(TwistHistory::paper_ramp(twist.clone()));
        amplitude_sweep(
            &paper::planform(),
            &paper::law(),
            &paper::stroke(frequency_hz),
            &amplitudes_rad,
            twist_at,
        )
        .expect("a sweep")
    }

    #[test]
    fn lift_goes_with_power_to_two_thirds_at_a_fixed_twist() {
        let points = sweep(&paper::twist_v2(), 23.0);
        let slope =
            (points[21].lift_n / points[0].lift_n).ln() / (points[21].power_w / points[0].power_w).ln();
        assert!((slope - 2.0 / 3.0).abs() < 1e-12, "{slope}");
    }

    #[test]
    fn lift_read_at_equal_power_is_the_ratio_at_equal_power_whatever_the_amplitude() {
        let (rigid, v1) = (
            sweep(&TwistAlongSpan::flat(), 21.0),
            sweep(&paper::twist_v1(), 22.0),
        );
        let means = |twist: TwistAlongSpan| {
            let twist = TwistHistory::paper_ramp(twist);
            stroke_means(&paper::planform(), &paper::law(), &paper::stroke(21.0), &twist).expect("means")
        };
        let ratios =
            Ratios::between(&means(paper::twist_v1()), &means(TwistAlongSpan::flat())).expect("ratios");
        for power_w in [0.06, 0.0777, 0.11] {
            let (lift, lift_rigid) = (lift_at_power(&v1, power_w), lift_at_power(&rigid, power_w));
            let ratio = lift.expect("inside") / lift_rigid.expect("inside");
            assert!(
                (ratio / ratios.lift_at_equal_power - 1.0).abs() < 1e-9,
                "{power_w}: {ratio}"
            );
        }
        assert_eq!(lift_at_power(&v1, 1e-6), None);
        assert_eq!(lift_at_power(&v1, f64::NAN), None);
        assert_eq!(lift_at_power(&[], 0.1), None);
    }

    #[test]
    fn a_twist_that_grows_with_the_amplitude_is_asked_for_at_each_one() {
        let mut seen_rad = Vec::new();
        let twist_at = |stroke: &Stroke| {
            seen_rad.push(stroke.half_amplitude_rad);
            let full =
                TwistAlongSpan::from_points(vec![[0.0, 0.0], [0.07, stroke.half_amplitude_rad.powi(2)]])?;
            Ok::<_, LiftError>(TwistHistory::paper_ramp(full))
        };
        let (planform, law, stroke) = (paper::planform(), paper::law(), paper::stroke(22.0));
        let points = amplitude_sweep(&planform, &law, &stroke, &[0.4, 0.8], twist_at).expect("a sweep");
        assert_eq!(seen_rad, [0.4, 0.8]);
        // More washout at the larger amplitude: less than the square of the amplitude.
        assert!(points[1].lift_n < 4.0 * points[0].lift_n);
    }

    #[test]
    fn a_bad_amplitude_and_a_failed_solve_come_back_as_errors() {
        let (planform, law, stroke) = (paper::planform(), paper::law(), paper::stroke(22.0));
        let flat = |_: &Stroke| Ok::<_, LiftError>(TwistHistory::paper_ramp(TwistAlongSpan::flat()));
        assert!(amplitude_sweep(&planform, &law, &stroke, &[f64::NAN], flat).is_err());
        let failed = |_: &Stroke| Err(LiftError::NoTwist);
        assert_eq!(
            amplitude_sweep(&planform, &law, &stroke, &[0.4], failed),
            Err(LiftError::NoTwist)
        );
    }
}
