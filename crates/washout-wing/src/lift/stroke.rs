//! Forces over one stroke, averaged by Gauss quadrature along the span and in time.

use crate::aero::{AirLaw, Flow};
use crate::coupling::BladeSection;
use crate::geometry::Planform;

use super::blade::BladeLaw;
use super::error::LiftError;
use super::means::{StationMeans, StrokeMeans};
use super::quadrature::{gauss_legendre, panels};
use super::twist::{Height, TwistHistory};

/// Widest panel along the span, as a share of it.
const WIDEST_SPAN_PANEL: f64 = 1.0 / 32.0;

/// Points of the quadrature on each panel along the span, and on each smooth piece of the half-stroke.
const SPAN_POINTS: u32 = 5;
const PHASE_POINTS: u32 = 8;

/// Harmonic flapping with the root at its stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Flapping frequency f, Hz.
    pub frequency_hz: f64,
    /// Half of the peak-to-peak stroke angle Φ, rad.
    pub half_amplitude_rad: f64,
    /// Angle of attack of the root at the stop, rad.
    pub stop_angle_rad: f64,
}

/// Forces on one wing at one phase of the stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// Stroke phase, rad; 0 is mid-stroke.
    pub phase_rad: f64,
    /// Lift, across the stream, along the flapping axis, N.
    pub lift_n: f64,
    /// Drag, along the stream, N.
    pub drag_n: f64,
    /// Aerodynamic power ∫U dD, W.
    pub power_w: f64,
}

impl Stroke {
    /// The stroke of a flapping flow.
    ///
    /// # Errors
    /// [`LiftError::NotFlapping`] for a steady stream; values that are not finite or negative.
    pub fn from_flow(flow: &Flow) -> Result<Self, LiftError> {
        let Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            stop_angle_rad,
            ..
        } = *flow
        else {
            return Err(LiftError::NotFlapping);
        };
        for (name, value) in [
            ("flapping frequency (Hz)", frequency_hz),
            ("half amplitude (rad)", half_amplitude_rad),
            ("stop angle (rad)", stop_angle_rad),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(LiftError::BadStroke { name, value });
            }
        }
        Ok(Stroke {
            frequency_hz,
            half_amplitude_rad,
            stop_angle_rad,
        })
    }

    /// Largest angular speed 2πfΦ, rad/s.
    pub fn peak_rate_rad_s(&self) -> f64 {
        std::f64::consts::TAU * self.frequency_hz * self.half_amplitude_rad
    }
}

/// Means over the stroke of one wing: ½ρ⟨U² C⟩c and ½ρ⟨U³ C_D⟩c along the span, α = stop angle − twist.
///
/// # Errors
/// [`LiftError::Air`] if an angle of attack leaves a coefficient table.
pub fn stroke_means(
    planform: &Planform,
    law: &impl BladeLaw,
    stroke: &Stroke,
    twist: &TwistHistory,
) -> Result<StrokeMeans, LiftError> {
    let half_turn = std::f64::consts::PI;
    let phases = panels(&twist.phase_kinks_rad(), half_turn, &gauss_legendre(PHASE_POINTS));
    let mut means = StrokeMeans {
        peak_rate_rad_s: stroke.peak_rate_rad_s(),
        lift_n: 0.0,
        drag_n: 0.0,
        power_w: 0.0,
        stations: Vec::new(),
    };
    let torque = drag_ratio(planform, law, stroke, twist)?;
    let ramp = law.plain().zip(twist.heights(&phases));
    for [r_m, width_m] in span_points(planform, twist) {
        let chord_m = planform.chord_m(r_m);
        let mut station = StationMeans {
            r_m,
            width_m,
            chord_m,
            twist_rad: twist.twist_rad(r_m, 0.0),
            lift_n_per_m: 0.0,
            drag_n_per_m: 0.0,
            power_w_per_m: 0.0,
        };
        match &ramp {
            Some((law, heights)) => station.fill(law, stroke, heights, r_m + planform.root_offset_m())?,
            None => {
                for [phase_rad, weight] in &phases {
                    let [lift, drag, power] =
                        blade(planform, law, stroke, twist, r_m, chord_m, *phase_rad, torque)?;
                    station.lift_n_per_m += lift * weight / half_turn;
                    station.drag_n_per_m += drag * weight / half_turn;
                    station.power_w_per_m += power * weight / half_turn;
                }
            }
        }
        means.lift_n += station.lift_n_per_m * width_m;
        means.drag_n += station.drag_n_per_m * width_m;
        means.power_w += station.power_w_per_m * width_m;
        means.stations.push(station);
    }
    Ok(means)
}

impl StationMeans {
    /// Means where forces hang on angle and speed alone: each height of the ramp but once.
    fn fill(
        &mut self,
        law: &AirLaw,
        stroke: &Stroke,
        heights: &[Height],
        arm_m: f64,
    ) -> Result<(), LiftError> {
        let speed_m_s = stroke.peak_rate_rad_s() * arm_m;
        let load = 0.5 * law.density_kg_m3 * self.chord_m * speed_m_s * speed_m_s;
        for height in heights {
            let alpha_rad = stroke.stop_angle_rad - self.twist_rad * height.share;
            law.check(alpha_rad).map_err(|source| LiftError::Air {
                r_mm: self.r_m * 1e3,
                source,
            })?;
            let (cl, cd) = law.coefficients.lift_and_drag(alpha_rad);
            self.lift_n_per_m += load * cl * height.squares;
            self.drag_n_per_m += load * cd * height.squares;
            self.power_w_per_m += load * speed_m_s * cd * height.cubes;
        }
        Ok(())
    }
}

/// Forces on one wing at a phase of the stroke, rad.
///
/// # Errors
/// As [`stroke_means`].
pub fn forces_at_phase(
    planform: &Planform,
    law: &impl BladeLaw,
    stroke: &Stroke,
    twist: &TwistHistory,
    phase_rad: f64,
) -> Result<Instant, LiftError> {
    let mut instant = Instant {
        phase_rad,
        lift_n: 0.0,
        drag_n: 0.0,
        power_w: 0.0,
    };
    let torque = drag_ratio(planform, law, stroke, twist)?;
    for [r_m, width_m] in span_points(planform, twist) {
        let [lift, drag, power] = blade(
            planform,
            law,
            stroke,
            twist,
            r_m,
            planform.chord_m(r_m),
            phase_rad,
            torque,
        )?;
        instant.lift_n += lift * width_m;
        instant.drag_n += drag * width_m;
        instant.power_w += power * width_m;
    }
    Ok(instant)
}

/// Lift and drag (N/m) and power (W/m) of the blade element at `r_m` and `phase_rad`.
#[allow(clippy::too_many_arguments)]
fn blade(
    planform: &Planform,
    law: &impl BladeLaw,
    stroke: &Stroke,
    twist: &TwistHistory,
    r_m: f64,
    chord_m: f64,
    phase_rad: f64,
    drag_ratio: f64,
) -> Result<[f64; 3], LiftError> {
    let arm_m = r_m + planform.root_offset_m();
    let speed_m_s = stroke.peak_rate_rad_s() * phase_rad.cos().abs() * arm_m;
    let alpha_rad = stroke.stop_angle_rad - twist.twist_rad(r_m, phase_rad);
    let mut section = BladeSection {
        r_m,
        chord_m,
        alpha_rad,
        speed_m_s,
        phase_rad,
        twist_rate_rad_s: 0.0,
        normal_acceleration_m_s2: 0.0,
        drag_ratio,
    };
    if law.wants_motion() {
        let angular_rate = std::f64::consts::TAU * stroke.frequency_hz;
        section.twist_rate_rad_s = twist.rate(r_m, phase_rad) * angular_rate;
        let side = if phase_rad.cos() < 0.0 { -1.0 } else { 1.0 };
        let surge = -stroke.peak_rate_rad_s() * arm_m * phase_rad.sin() * side * angular_rate;
        section.normal_acceleration_m_s2 =
            surge * alpha_rad.sin() - speed_m_s * alpha_rad.cos() * section.twist_rate_rad_s;
    }
    let [lift, drag] = law.force(&section).map_err(|source| LiftError::Air {
        r_mm: r_m * 1e3,
        source,
    })?;
    Ok([lift, drag, drag * speed_m_s])
}

/// Drag torque at mid-stroke over that of the untwisted wing, as an effect on the motion may ask for it; 1 without drag.
fn drag_ratio(
    planform: &Planform,
    law: &impl BladeLaw,
    stroke: &Stroke,
    twist: &TwistHistory,
) -> Result<f64, LiftError> {
    if !law.wants_motion() {
        return Ok(1.0);
    }
    let [mut twisted, mut plain] = [0.0, 0.0];
    let flat = TwistHistory::paper_ramp(super::twist::TwistAlongSpan::flat());
    for [r_m, width_m] in span_points(planform, twist) {
        let chord_m = planform.chord_m(r_m);
        for (history, sum) in [(twist, &mut twisted), (&flat, &mut plain)] {
            let [_, _, power] = blade(planform, law, stroke, history, r_m, chord_m, 0.0, 1.0)?;
            *sum += power * width_m;
        }
    }
    Ok(if plain > 0.0 && twisted > 0.0 {
        twisted / plain
    } else {
        1.0
    })
}

/// Quadrature points and weights along the built span, m.
fn span_points(planform: &Planform, twist: &TwistHistory) -> Vec<[f64; 2]> {
    let tip_m = planform.tip_m();
    let mut ends_m = vec![0.0, tip_m];
    ends_m.extend(
        planform
            .kinks_m()
            .into_iter()
            .chain(twist.span_kinks_m())
            .filter(|r| (0.0..=tip_m).contains(r)),
    );
    ends_m.sort_by(f64::total_cmp);
    panels(&ends_m, tip_m * WIDEST_SPAN_PANEL, &gauss_legendre(SPAN_POINTS))
}

#[cfg(test)]
mod tests {
    use super::{BladeLaw, BladeSection, Stroke, forces_at_phase, stroke_means};
    use crate::aero::{AeroError, AirLaw, CentreOfPressureLaw, CoefficientLaw, Flow};
    use crate::lift::error::LiftError;
    use crate::lift::paper;
    use crate::lift::twist::{TwistAlongSpan, TwistHistory};
    use std::f64::consts::PI;

    fn rigid() -> TwistHistory {
        TwistHistory::paper_ramp(TwistAlongSpan::flat())
    }

    #[test]
    fn a_flat_wing_has_the_closed_form_of_its_second_and_third_moment() {
        let (planform, law, stroke) = (paper::planform(), paper::law(), paper::stroke(21.0));
        let means = stroke_means(&planform, &law, &stroke, &rigid()).expect("means");
        let (length, offset) = (planform.length_m(), planform.root_offset_m());
        let (r1, r2) = (planform.r1_hat() * length, planform.r2_hat() * length);
        let second = planform.area_m2() * (r2 * r2 + 2.0 * offset * r1 + offset * offset);
        let (cl, cd) = law.coefficients.lift_and_drag(PI / 4.0);
        let rate = stroke.peak_rate_rad_s();
        let lift = 0.5 * 1.2 * rate * rate * 0.5 * cl * second;
        assert!(
            (means.lift_n / lift - 1.0).abs() < 1e-7,
            "{} {lift}",
            means.lift_n
        );
        assert!((means.drag_n / (lift * cd / cl) - 1.0).abs() < 1e-7);
        // ⟨|cos|³⟩ = 4/(3π); the third moment by the trapezoidal rule, as an independent sum.
        let third: f64 = (0..200_000)
            .map(|i| (f64::from(i) + 0.5) / 200_000.0 * planform.tip_m())
            .map(|r| planform.chord_m(r) * (r + offset).powi(3) * planform.tip_m() / 200_000.0)
            .sum();
        let power = 0.5 * 1.2 * rate.powi(3) * 4.0 / (3.0 * PI) * cd * third;
        assert!(
            (means.power_w / power - 1.0).abs() < 1e-6,
            "{} {power}",
            means.power_w
        );
    }

    #[test]
    fn the_papers_rigid_wing_lifts_26_5_millinewtons_at_34_5_degrees() {
        let means =
            stroke_means(&paper::planform(), &paper::law(), &paper::stroke(21.0), &rigid()).expect("means");
        // Independent sum in another program: 26.456 mN, 24.978 mN, 134.18 mW for the built wing.
        assert!((means.lift_n * 1e3 - 26.456).abs() < 2e-3, "{}", means.lift_n);
        assert!((means.drag_n * 1e3 - 24.978).abs() < 2e-3, "{}", means.drag_n);
        assert!((means.power_w * 1e3 - 134.18).abs() < 2e-2, "{}", means.power_w);
        // The paper's reading of Fig. 6: lift about equal to drag.
        assert!((means.lift_to_drag().expect("drag") - 1.06).abs() < 0.005);
    }

    #[test]
    fn means_are_the_average_of_the_instants() {
        let (planform, law, stroke) = (paper::planform(), paper::law(), paper::stroke(22.0));
        let twist = TwistHistory::paper_ramp(paper::twist_v1());
        let means = stroke_means(&planform, &law, &stroke, &twist).expect("means");
        let count = 2000;
        let mut sums = [0.0; 3];
        for i in 0..count {
            let phase = PI * ((f64::from(i) + 0.5) / f64::from(count) - 0.5);
            let instant = forces_at_phase(&planform, &law, &stroke, &twist, phase).expect("instant");
            for (sum, part) in sums
                .iter_mut()
                .zip([instant.lift_n, instant.drag_n, instant.power_w])
            {
                *sum += part / f64::from(count);
            }
        }
        for (sum, mean) in sums.iter().zip([means.lift_n, means.drag_n, means.power_w]) {
            assert!((sum / mean - 1.0).abs() < 1e-5, "{sum} {mean}");
        }
        let reversal = forces_at_phase(&planform, &law, &stroke, &twist, PI / 2.0).expect("instant");
        assert!(reversal.lift_n.abs() < 1e-30 && reversal.power_w.abs() < 1e-30);
    }

    /// The laws as if an effect acted besides: every phase is looked at.
    struct EveryPhase(AirLaw);

    impl BladeLaw for EveryPhase {
        fn force(&self, section: &BladeSection) -> Result<[f64; 2], AeroError> {
            self.0.force(section)
        }
    }

    #[test]
    fn heights_of_the_ramp_taken_once_give_what_every_phase_gives() {
        let (planform, stroke) = (paper::planform(), paper::stroke(23.0));
        let twist = TwistHistory::paper_ramp(paper::twist_v2());
        let quick = stroke_means(&planform, &paper::law(), &stroke, &twist).expect("means");
        let slow = stroke_means(&planform, &EveryPhase(paper::law()), &stroke, &twist).expect("means");
        for (a, b) in [
            (quick.lift_n, slow.lift_n),
            (quick.drag_n, slow.drag_n),
            (quick.power_w, slow.power_w),
        ] {
            assert!((a / b - 1.0).abs() < 1e-13, "{a} {b}");
        }
    }

    #[test]
    fn a_ramp_given_as_a_solved_table_gives_the_ramp() {
        let (planform, law, stroke) = (paper::planform(), paper::law(), paper::stroke(23.0));
        let ramp = TwistHistory::paper_ramp(paper::twist_v2());
        let phases = vec![(0.3 * PI, paper::twist_v2()), (0.5 * PI, TwistAlongSpan::flat())];
        let table = TwistHistory::solved(phases).expect("phases");
        let by_ramp = stroke_means(&planform, &law, &stroke, &ramp).expect("means");
        let by_table = stroke_means(&planform, &law, &stroke, &table).expect("means");
        assert!((by_ramp.lift_n / by_table.lift_n - 1.0).abs() < 1e-12);
        assert!((by_ramp.power_w / by_table.power_w - 1.0).abs() < 1e-12);
    }

    #[test]
    fn an_angle_outside_the_table_of_coefficients_names_its_station() {
        let table =
            crate::aero::table::CoefficientTable::new(&[[20.0, 1.0, 0.6], [50.0, 1.8, 1.8]]).expect("table");
        let law = AirLaw {
            density_kg_m3: 1.2,
            coefficients: CoefficientLaw::Table(table),
            centre_of_pressure: CentreOfPressureLaw::Dickson,
        };
        let twist = TwistHistory::paper_ramp(paper::twist_v1());
        let error =
            stroke_means(&paper::planform(), &law, &paper::stroke(22.0), &twist).expect_err("alpha below 20");
        assert!(
            matches!(error, LiftError::Air { r_mm, .. } if r_mm > 50.0 && r_mm < 60.0),
            "{error}"
        );
    }

    #[test]
    fn only_a_flapping_flow_has_a_stroke() {
        let steady = Flow::Steady {
            speed_m_s: 5.0,
            root_angle_rad: 0.1,
            sweep_rad: 0.0,
        };
        assert_eq!(Stroke::from_flow(&steady), Err(LiftError::NotFlapping));
        let flapping = Flow::Flapping {
            frequency_hz: f64::NAN,
            half_amplitude_rad: 0.6,
            stop_angle_rad: 0.8,
            root_offset_m: 0.0,
            phase_rad: 0.0,
        };
        assert!(matches!(
            Stroke::from_flow(&flapping),
            Err(LiftError::BadStroke { .. })
        ));
    }
}
