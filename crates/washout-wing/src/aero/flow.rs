//! Relative air in the wing frame at rest: flapping at a stroke phase, or a steady stream.
//!
//! Flapping: the stroke axis â = (0, −sin α, cos α) stands at x = −r₀, with α the pitch-stop angle. The wing
//! turns about it at the rate −ω â, so a point at span r moves at −ω (r + r₀) û and meets air at
//! +ω (r + r₀) û, û = (0, cos α, sin α) = â × x̂. Lift, the force across the stream, is along +â; for a wing
//! that hovers with its stroke plane level, gravity is g (0, sin α, −cos α).
//! After each reversal the wing is flipped to its other stop and the frame with it, so both half-strokes look
//! alike and only the amount of cos(phase) enters.
//!
//! Steady: the wing is pitched by the root angle α and its span axis then swept aft by Λ in its own plane, so
//! the stream at rest is V (cos α sin Λ, cos α cos Λ, sin α): with the tip swept aft the air runs outward (+x).
//! Normal to the span the speed is V cos Λ for small α, and the incidence there is α / cos Λ.

use nalgebra::Vector3;

use crate::input::design::Design;

/// Relative air, as a design states it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Flow {
    /// Flapping about the stroke axis with the root at its pitch stop.
    Flapping {
        /// Flapping frequency, Hz.
        frequency_hz: f64,
        /// Half of the peak-to-peak stroke angle, rad.
        half_amplitude_rad: f64,
        /// Angle of attack of the root at the stop, rad.
        stop_angle_rad: f64,
        /// Distance from the stroke axis to the wing base, m.
        root_offset_m: f64,
        /// Stroke phase of the design, rad; 0 is mid-stroke.
        phase_rad: f64,
    },
    /// Steady stream of a wind tunnel.
    Steady {
        /// Speed of the stream, m/s.
        speed_m_s: f64,
        /// Angle of attack of the wing's plane, rad.
        root_angle_rad: f64,
        /// Sweep of the span axis, rad, positive aft.
        sweep_rad: f64,
    },
}

impl Flow {
    /// The flow of a design; `None` for a bench without air. With both tables, flapping counts (the input room
    /// refuses such a design).
    pub fn from_design(design: &Design) -> Option<Flow> {
        if let Some(flapping) = &design.flapping {
            return Some(Flow::Flapping {
                frequency_hz: flapping.frequency_hz.value(),
                half_amplitude_rad: flapping.half_amplitude_deg.value().to_radians(),
                stop_angle_rad: flapping.stop_angle_deg.value().to_radians(),
                root_offset_m: design.planform.root_offset_mm.value() * 1e-3,
                phase_rad: flapping.phase_deg.value().to_radians(),
            });
        }
        design.steady.as_ref().map(|steady| Flow::Steady {
            speed_m_s: steady.speed_m_s.value(),
            root_angle_rad: steady.root_angle_deg.value().to_radians(),
            sweep_rad: steady.sweep_deg.value().to_radians(),
        })
    }

    /// Velocity of the air relative to the wing at span position `r_m`, m/s, wing frame at rest, at the phase
    /// of the design.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::aero::Flow;
    ///
    /// let stream = Flow::Steady { speed_m_s: 10.0, root_angle_rad: 0.0, sweep_rad: 0.0 };
    /// assert!((stream.velocity(0.03).norm() - 10.0).abs() < 1e-12);
    /// ```
    pub fn velocity(&self, r_m: f64) -> Vector3<f64> {
        let phase_rad = match self {
            Flow::Flapping { phase_rad, .. } => *phase_rad,
            Flow::Steady { .. } => 0.0,
        };
        self.velocity_at_phase(r_m, phase_rad)
    }

    /// The same at another stroke phase, rad (0 mid-stroke, ±π/2 the reversals). A steady stream has no phase.
    ///
    /// Flapping speed is 2πfΦ |cos phase| (r + r₀) (physics of the paper's equation 1).
    pub fn velocity_at_phase(&self, r_m: f64, phase_rad: f64) -> Vector3<f64> {
        match *self {
            Flow::Flapping {
                frequency_hz,
                half_amplitude_rad,
                stop_angle_rad,
                root_offset_m,
                ..
            } => {
                let rate_rad_s = std::f64::consts::TAU * frequency_hz * half_amplitude_rad;
                // at a reversal the wing stands still; the cosine of the nearest number to π/2 is not zero
                let cosine = phase_rad.cos().abs();
                let cosine = if cosine > f64::EPSILON { cosine } else { 0.0 };
                let speed_m_s = rate_rad_s * cosine * (r_m + root_offset_m);
                Vector3::new(0.0, stop_angle_rad.cos(), stop_angle_rad.sin()) * speed_m_s
            }
            Flow::Steady {
                speed_m_s,
                root_angle_rad,
                sweep_rad,
            } => {
                let in_plane_m_s = speed_m_s * root_angle_rad.cos();
                Vector3::new(
                    in_plane_m_s * sweep_rad.sin(),
                    in_plane_m_s * sweep_rad.cos(),
                    speed_m_s * root_angle_rad.sin(),
                )
            }
        }
    }

    /// Angle of attack of the undeformed wing in the plane normal to the span, rad.
    pub fn root_angle_rad(&self) -> f64 {
        match *self {
            Flow::Flapping { stop_angle_rad, .. } => stop_angle_rad,
            Flow::Steady {
                root_angle_rad,
                sweep_rad,
                ..
            } => root_angle_rad.sin().atan2(root_angle_rad.cos() * sweep_rad.cos()),
        }
    }

    /// Unit vector along which lift acts on the undeformed wing, wing frame: across the stream and the span;
    /// for flapping it is the stroke axis.
    pub fn lift_direction(&self) -> Vector3<f64> {
        let (sin, cos) = self.root_angle_rad().sin_cos();
        Vector3::new(0.0, -sin, cos)
    }
}

#[cfg(test)]
mod tests {
    use super::Flow;
    use nalgebra::Vector3;

    fn flapping() -> Flow {
        Flow::Flapping {
            frequency_hz: 23.0,
            half_amplitude_rad: 34.5_f64.to_radians(),
            stop_angle_rad: 40.0_f64.to_radians(),
            root_offset_m: 0.038,
            phase_rad: 0.0,
        }
    }

    #[test]
    fn flapping_speed_and_direction_at_mid_stroke_by_hand() {
        // 2π · 23 Hz · 0.602139 rad · (0.07 + 0.038) m = 9.39785 m/s
        let velocity = flapping().velocity(0.07);
        assert!((velocity.norm() - 9.39785).abs() < 1e-4, "{}", velocity.norm());
        assert!((velocity.z.atan2(velocity.y).to_degrees() - 40.0).abs() < 1e-12);
        assert_eq!(velocity.x, 0.0);
    }

    #[test]
    fn flapping_speed_falls_with_the_cosine_of_the_phase_in_both_half_strokes() {
        let full = flapping().velocity(0.05);
        for degrees in [0.0, 60.0, 120.0, 180.0] {
            let part = flapping().velocity_at_phase(0.05, f64::to_radians(degrees));
            let share = if degrees % 180.0 == 0.0 { 1.0 } else { 0.5 };
            assert!((part - full * share).norm() < 1e-12, "{degrees} deg");
        }
    }

    #[test]
    fn relative_air_of_flapping_is_a_rigid_turn_about_the_lift_direction() {
        let flow = flapping();
        let rate = std::f64::consts::TAU * 23.0 * 34.5_f64.to_radians();
        let turn = flow.lift_direction() * -rate;
        let wing = turn.cross(&Vector3::new(0.03 + 0.038, 0.0, 0.0));
        assert!((flow.velocity(0.03) + wing).norm() < 1e-12);
    }

    #[test]
    fn aft_sweep_sends_air_outward_and_keeps_the_speed() {
        let flow = Flow::Steady {
            speed_m_s: 30.0,
            root_angle_rad: 0.03,
            sweep_rad: 0.4,
        };
        let velocity = flow.velocity(0.2);
        assert!((velocity.norm() - 30.0).abs() < 1e-12);
        assert!(velocity.x > 0.0);
        assert!((flow.root_angle_rad() - 0.03 / 0.4_f64.cos()).abs() < 1e-5);
        assert!(flow.lift_direction().dot(&velocity).abs() < 1e-12);
    }
}
