//! Lift, drag and power of one wing as a report names them: at the phase that was solved, and mean over the stroke.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::aero::Flow;
use crate::coupling::solution::StripLoad;
use crate::geometry::Planform;

use super::blade::BladeLaw;
use super::error::LiftError;
use super::means::StrokeMeans;
use super::stroke::{Stroke, stroke_means};
use super::twist::{TwistAlongSpan, TwistHistory};

/// Forces on one wing under a name that says what they are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Forces {
    /// What they are: "mid-stroke", "mean over the stroke (20/60/20 ramp)", …
    pub name: String,
    /// Lift of one wing, mN.
    pub lift_mn: f64,
    /// Drag of one wing, mN.
    pub drag_mn: f64,
    /// Aerodynamic power of one wing, mW.
    pub power_mw: f64,
    /// Lift over drag; absent without drag.
    pub lift_to_drag: Option<f64>,
    /// Lift per aerodynamic power, N/W; absent without power.
    pub lift_per_power_n_per_w: Option<f64>,
}

/// Lift of a solved wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LiftReport {
    /// At the phase of the solution.
    pub solved: Forces,
    /// Mean over the stroke with the solved twist on the paper's ramp; absent for a steady stream, and where the
    /// solution is not mid-stroke, whose twist the ramp takes as its full one.
    pub stroke_mean: Option<Forces>,
}

/// Whether a drag is one, and not what is left of forces that cancel: a thin aerofoil has none.
fn is_more_than_rounding(drag_n: f64, lift_n: f64) -> bool {
    drag_n > 1e-12 * lift_n.abs()
}

impl Forces {
    /// From newtons and watts.
    pub fn new(name: impl Into<String>, lift_n: f64, drag_n: f64, power_w: f64) -> Self {
        Forces {
            name: name.into(),
            lift_mn: lift_n * 1e3,
            drag_mn: drag_n * 1e3,
            power_mw: power_w * 1e3,
            lift_to_drag: is_more_than_rounding(drag_n, lift_n).then(|| lift_n / drag_n),
            lift_per_power_n_per_w: (power_w > 0.0 && is_more_than_rounding(drag_n, lift_n))
                .then(|| lift_n / power_w),
        }
    }

    /// Sums of strips: in each section lift acts across the local stream, N cos α − T sin α, drag along it,
    /// N sin α + T cos α, and drag times speed is power.
    pub fn of_strips(name: impl Into<String>, strips: &[StripLoad]) -> Self {
        let (mut lift_n, mut drag_n, mut power_w) = (0.0, 0.0, 0.0);
        for strip in strips {
            let (sin, cos) = strip.alpha_rad.sin_cos();
            let lift = strip.normal_n_per_m * cos - strip.tangential_n_per_m * sin;
            let drag = strip.normal_n_per_m * sin + strip.tangential_n_per_m * cos;
            lift_n += lift * strip.width_m;
            drag_n += drag * strip.width_m;
            power_w += drag * strip.width_m * strip.speed_m_s;
        }
        Forces::new(name, lift_n, drag_n, power_w)
    }

    /// Means over the stroke.
    pub fn of_means(name: impl Into<String>, means: &StrokeMeans) -> Self {
        Forces::new(name, means.lift_n, means.drag_n, means.power_w)
    }
}

impl LiftReport {
    /// From the strips of a solved wing, its planform, air and flow.
    ///
    /// # Errors
    /// As [`stroke_means`] and [`TwistAlongSpan::from_strips`].
    pub fn new(
        planform: &Planform,
        law: &impl BladeLaw,
        flow: &Flow,
        strips: &[StripLoad],
    ) -> Result<Self, LiftError> {
        let Flow::Flapping { phase_rad, .. } = *flow else {
            return Ok(LiftReport {
                solved: Forces::of_strips("steady stream", strips),
                stroke_mean: None,
            });
        };
        let mid_stroke = phase_rad.sin().abs() < 1e-9;
        let name = if mid_stroke {
            "mid-stroke".to_string()
        } else {
            format!("at stroke phase {} deg", rounded(phase_rad.to_degrees()))
        };
        let solved = Forces::of_strips(name, strips);
        if !mid_stroke {
            return Ok(LiftReport {
                solved,
                stroke_mean: None,
            });
        }
        let stroke = Stroke::from_flow(flow)?;
        let twist = TwistHistory::paper_ramp(TwistAlongSpan::from_strips(strips, stroke.stop_angle_rad)?);
        let means = stroke_means(planform, law, &stroke, &twist)?;
        Ok(LiftReport {
            solved,
            stroke_mean: Some(Forces::of_means("mean over the stroke (20/60/20 ramp)", &means)),
        })
    }
}

/// To a thousandth, so that a phase reads as it was written.
fn rounded(degrees: f64) -> f64 {
    (degrees * 1e3).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::LiftReport;
    use crate::aero::{Flow, strip_force};
    use crate::coupling::solution::StripLoad;
    use crate::lift::paper;
    use crate::lift::stroke::{forces_at_phase, stroke_means};
    use crate::lift::twist::{TwistAlongSpan, TwistHistory};
    use nalgebra::Vector3;

    fn flow(phase_deg: f64) -> Flow {
        Flow::Flapping {
            frequency_hz: 22.0,
            half_amplitude_rad: 34.5_f64.to_radians(),
            stop_angle_rad: 45.0_f64.to_radians(),
            root_offset_m: 0.038,
            phase_rad: phase_deg.to_radians(),
        }
    }

    /// Strips of the wing twisted as v1, as a coupled solve would leave them.
    fn strips(flow: &Flow) -> Vec<StripLoad> {
        let (planform, law, count) = (paper::planform(), paper::law(), 400);
        let width_m = planform.tip_m() / f64::from(count);
        (0..count)
            .map(|i| {
                let r_m = (f64::from(i) + 0.5) * width_m;
                let (chord_m, twist) = (planform.chord_m(r_m), paper::twist_v1().twist_rad(r_m));
                let chord = Vector3::new(0.0, twist.cos(), twist.sin()) * chord_m;
                let force = strip_force(&law, &flow.velocity(r_m), &chord, &Vector3::x(), chord_m, &());
                StripLoad {
                    r_m,
                    width_m,
                    chord_m,
                    speed_m_s: force.speed,
                    alpha_rad: force.alpha,
                    cl: force.cl,
                    cd: force.cd,
                    centre_of_pressure: force.centre_of_pressure,
                    normal_n_per_m: force.normal_n_per_m,
                    tangential_n_per_m: force.tangential_n_per_m,
                }
            })
            .collect()
    }

    #[test]
    fn the_strips_of_a_solved_wing_give_the_forces_of_its_twist() {
        let (planform, law, stroke) = (paper::planform(), paper::law(), paper::stroke(22.0));
        let report = LiftReport::new(&planform, &law, &flow(0.0), &strips(&flow(0.0))).expect("report");
        let twist = TwistHistory::paper_ramp(paper::twist_v1());
        let instant = forces_at_phase(&planform, &law, &stroke, &twist, 0.0).expect("instant");
        assert_eq!(report.solved.name, "mid-stroke");
        assert!((report.solved.lift_mn / (instant.lift_n * 1e3) - 1.0).abs() < 1e-4);
        assert!((report.solved.drag_mn / (instant.drag_n * 1e3) - 1.0).abs() < 1e-4);
        assert!((report.solved.power_mw / (instant.power_w * 1e3) - 1.0).abs() < 1e-4);
        let mean = report.stroke_mean.expect("flapping");
        let direct = stroke_means(&planform, &law, &stroke, &twist).expect("means");
        assert_eq!(mean.name, "mean over the stroke (20/60/20 ramp)");
        assert!((mean.lift_mn / (direct.lift_n * 1e3) - 1.0).abs() < 1e-3);
        assert!((mean.power_mw / (direct.power_w * 1e3) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn off_mid_stroke_and_in_a_stream_no_stroke_mean_is_claimed() {
        let report = LiftReport::new(
            &paper::planform(),
            &paper::law(),
            &flow(30.0),
            &strips(&flow(30.0)),
        );
        let report = report.expect("report");
        assert_eq!(
            (report.solved.name.as_str(), report.stroke_mean),
            ("at stroke phase 30 deg", None)
        );
        let steady = Flow::Steady {
            speed_m_s: 5.0,
            root_angle_rad: 0.3,
            sweep_rad: 0.0,
        };
        let report =
            LiftReport::new(&paper::planform(), &paper::law(), &steady, &strips(&steady)).expect("report");
        assert_eq!(
            (report.solved.name.as_str(), report.stroke_mean),
            ("steady stream", None)
        );
        assert!(report.solved.lift_to_drag.expect("drag") > 0.5);
    }

    #[test]
    fn a_wing_without_strips_carries_nothing_and_says_no_ratio() {
        let steady = Flow::Steady {
            speed_m_s: 5.0,
            root_angle_rad: 0.3,
            sweep_rad: 0.0,
        };
        let report = LiftReport::new(&paper::planform(), &paper::law(), &steady, &[]).expect("report");
        assert_eq!((report.solved.lift_mn, report.solved.lift_to_drag), (0.0, None));
        assert!(TwistAlongSpan::from_strips(&[], 0.8).is_err());
    }
}
