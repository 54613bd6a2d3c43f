//! Means over the stroke of many profiles on one wing: the sums of [`crate::lift::stroke_means`] on fixed points, the plateau
//! of the ramp in closed form.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::coupling::{BladeAir, BladeSection};
use crate::geometry::Planform;
use crate::lift::quadrature::{gauss_legendre, panels};
use crate::lift::{LiftError, Stroke, TwistAlongSpan, TwistHistory, mean_local_lift_to_drag, stroke_means};

/// Panels along the span.
const PANELS: f64 = 40.0;

/// One wing on one stroke, for many profiles.
#[derive(Debug, Clone)]
pub struct Blades {
    planform: Planform,
    air: BladeAir,
    stroke: Stroke,
    share: f64,
    /// Span position, width, chord.
    stations: Vec<[f64; 3]>,
    /// Phase, height of the ramp, weights of force and of power relative to those at that phase.
    phases: Vec<[f64; 4]>,
}

/// Means over the stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Totals {
    /// Mean lift, N.
    pub lift_n: f64,
    /// Mean drag, N.
    pub drag_n: f64,
    /// Mean aerodynamic power, W.
    pub power_w: f64,
    /// Mean along the span of local mean lift over local mean drag.
    pub local_lift_to_drag: f64,
}

impl Blades {
    /// A wing whose twist is ramped up over the first `share` of each half-stroke and down over the last; 0 holds it.
    pub fn new(planform: &Planform, air: BladeAir, stroke: Stroke, share: f64) -> Blades {
        let mut ends = vec![0.0, planform.tip_m()];
        ends.extend(planform.kinks_m());
        ends.sort_by(f64::total_cmp);
        let stations = panels(&ends, planform.tip_m() / PANELS, &gauss_legendre(2))
            .into_iter()
            .map(|[r_m, width_m]| [r_m, width_m, planform.chord_m(r_m)])
            .collect();
        let edge = PI * (0.5 - share);
        let half = FRAC_PI_2;
        // over the plateau the angle stays, so the mean of cos² and cos³ is all that enters
        let square = (0.5 * edge + 0.25 * (2.0 * edge).sin()) / half;
        let cube = (edge.sin() - edge.sin().powi(3) / 3.0) / half;
        let mut phases = vec![[0.0, 1.0, square, cube]];
        if share > 0.0 {
            for [phase, weight] in panels(&[edge, half], PI, &gauss_legendre(6)) {
                phases.push([
                    phase,
                    (half - phase) / (half - edge),
                    weight / half,
                    weight / half,
                ]);
            }
        }
        Blades {
            planform: planform.clone(),
            air,
            stroke,
            share,
            stations,
            phases,
        }
    }

    /// Means of a profile.
    ///
    /// # Errors
    /// If an angle of attack leaves a table of coefficients.
    pub fn totals(&self, twist: &TwistAlongSpan) -> Result<Totals, LiftError> {
        if self.air.wants_motion() {
            return self.moving(twist);
        }
        let mut totals = Totals {
            lift_n: 0.0,
            drag_n: 0.0,
            power_w: 0.0,
            local_lift_to_drag: 0.0,
        };
        let mut span_m = 0.0;
        for &[r_m, width_m, chord_m] in &self.stations {
            let full_rad = twist.twist_rad(r_m);
            let arm_m = r_m + self.planform.root_offset_m();
            let [mut lift, mut drag, mut power] = [0.0; 3];
            for &[phase_rad, height, force, work] in &self.phases {
                let speed_m_s = self.stroke.peak_rate_rad_s() * phase_rad.cos() * arm_m;
                let section = BladeSection {
                    r_m,
                    chord_m,
                    alpha_rad: self.stroke.stop_angle_rad - full_rad * height,
                    speed_m_s,
                    phase_rad,
                    twist_rate_rad_s: 0.0,
                    normal_acceleration_m_s2: 0.0,
                    drag_ratio: 1.0,
                };
                let [l, d] = self.air.force(&section).map_err(|source| LiftError::Air {
                    r_mm: r_m * 1e3,
                    source,
                })?;
                lift += l * force;
                drag += d * force;
                power += d * speed_m_s * work;
            }
            totals.lift_n += lift * width_m;
            totals.drag_n += drag * width_m;
            totals.power_w += power * width_m;
            if drag > 0.0 {
                totals.local_lift_to_drag += width_m * lift / drag;
                span_m += width_m;
            }
        }
        if span_m > 0.0 {
            totals.local_lift_to_drag /= span_m;
        }
        Ok(totals)
    }

    /// The same where an effect knows the motion.
    fn moving(&self, twist: &TwistAlongSpan) -> Result<Totals, LiftError> {
        let history = TwistHistory::Ramp {
            full: twist.clone(),
            share: self.share.max(1e-6),
        };
        let means = stroke_means(&self.planform, &self.air, &self.stroke, &history)?;
        Ok(Totals {
            lift_n: means.lift_n,
            drag_n: means.drag_n,
            power_w: means.power_w,
            local_lift_to_drag: mean_local_lift_to_drag(&means),
        })
    }
}
