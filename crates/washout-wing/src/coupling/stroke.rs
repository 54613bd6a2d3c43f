//! The stroke that a flapping wing is driven through: sweep, pitch between the stops, and what stands still follows.
//!
//! Frame: the rod's own, which flips with it. Phase τ is 0 at mid-stroke; everything across the wing changes sign with the
//! half-stroke, x(τ + π) = −x(τ).

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::aero::Flow;

/// How the rod is driven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Angular frequency ω, rad/s.
    pub rate_rad_s: f64,
    /// Half of the peak-to-peak sweep, rad.
    pub half_amplitude_rad: f64,
    /// Pitch of the rod from upright at the stop, rad: π/2 less the angle of attack.
    pub stop_pitch_rad: f64,
    /// Share of the stroke that each flip between the stops takes; the wing has left its stop half of it before the reversal.
    pub flip_share: f64,
}

impl Stroke {
    /// The stroke of a flow; none in a steady stream.
    pub fn of(flow: &Flow, flip_share: f64) -> Option<Stroke> {
        match *flow {
            Flow::Flapping {
                frequency_hz,
                half_amplitude_rad,
                stop_angle_rad,
                ..
            } => Some(Stroke {
                rate_rad_s: TAU * frequency_hz,
                half_amplitude_rad,
                stop_pitch_rad: FRAC_PI_2 - stop_angle_rad,
                flip_share,
            }),
            Flow::Steady { .. } => None,
        }
    }

    /// Pitch of the rod from upright (rad) and its first and second derivative with the phase, washout of the first
    /// half-stroke positive: at the stops but for the flips, whose rate rises and falls as a raised cosine.
    pub fn pitch(&self, phase: f64) -> [f64; 3] {
        // nearest reversal, and the side on which it ends
        let turn = ((phase - FRAC_PI_2) / PI).round();
        let side = if turn.rem_euclid(2.0) == 0.0 { -1.0 } else { 1.0 };
        let (from, half) = (phase - FRAC_PI_2 - turn * PI, PI * self.flip_share);
        let stop = self.stop_pitch_rad * side;
        if from.abs() >= half {
            return [stop * from.signum(), 0.0, 0.0];
        }
        let (sin, cos) = (PI * from / half).sin_cos();
        [
            stop * (from / half + sin / PI),
            stop * (1.0 + cos) / half,
            -stop * PI * sin / (half * half),
        ]
    }

    /// Acceleration of the rod across the wing per distance from the stroke axis, rad/s², positive along +z.
    pub fn sweep_acceleration(&self, phase: f64) -> f64 {
        self.half_amplitude_rad * self.rate_rad_s.powi(2) * phase.sin() * self.pitch(phase)[0].cos()
    }
}

/// The path of a quantity that follows the load as if the wing stood still, of which value and rate with the dynamic
/// pressure are known at mid-stroke: y = |c| c (y₁ + (y₁′ − y₁)(c² − 1)), c = cos τ.
///
/// Exact where y goes with the pressure; nothing at the reversal. Gives the weights of y₁ and of y₁′ − y₁ with their first
/// and second derivatives by the phase.
pub fn standing_path(phase: f64) -> [[f64; 3]; 2] {
    let (sin, cos) = phase.sin_cos();
    let side = if cos < 0.0 { -1.0 } else { 1.0 };
    let square = [cos * cos, -2.0 * sin * cos, 2.0 * (sin * sin - cos * cos)];
    let fourth = [
        cos.powi(4),
        -4.0 * sin * cos.powi(3),
        12.0 * (sin * cos).powi(2) - 4.0 * cos.powi(4),
    ];
    [0, 1].map(|row| {
        std::array::from_fn(|k| {
            side * if row == 0 {
                square[k]
            } else {
                fourth[k] - square[k]
            }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::{Stroke, standing_path};
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    const STROKE: Stroke = Stroke {
        rate_rad_s: 100.0,
        half_amplitude_rad: 0.5,
        stop_pitch_rad: FRAC_PI_4,
        flip_share: 0.2,
    };

    #[test]
    fn the_rod_rests_at_its_stops_and_flips_about_the_reversals() {
        for (phase, pitch) in [
            (0.0, 1.0),
            (0.9, 1.0),
            (FRAC_PI_2, 0.0),
            (PI, -1.0),
            (1.5 * PI, 0.0),
            (-0.9, 1.0),
        ] {
            assert!(
                (STROKE.pitch(phase)[0] - pitch * FRAC_PI_4).abs() < 1e-12,
                "{phase}"
            );
        }
        for step in 0..200 {
            let phase = f64::from(step) * 0.05;
            let [here, there] = [phase, phase + PI].map(|phase| STROKE.pitch(phase));
            assert!(
                here.iter().zip(there).all(|(a, b)| (a + b).abs() < 1e-9),
                "{phase}"
            );
            let h = 1e-4;
            let curve = (STROKE.pitch(phase + h)[0] - 2.0 * here[0] + STROKE.pitch(phase - h)[0]) / (h * h);
            // but for the four phases in which a flip begins or ends
            let edge = ((phase.rem_euclid(PI) - FRAC_PI_2).abs() - 0.2 * PI).abs() < 2.0 * h;
            assert!(
                edge || (curve - here[2]).abs() < 1e-4,
                "{phase} {curve} {}",
                here[2]
            );
            let rate = (STROKE.pitch(phase + h)[0] - STROKE.pitch(phase - h)[0]) / (2.0 * h);
            assert!((rate - here[1]).abs() < 1e-6, "{phase} {rate} {}", here[1]);
        }
    }

    #[test]
    fn the_sweep_speeds_up_against_the_air_before_mid_stroke() {
        // the air blows along +z, so the rod moves along −z and faster until mid-stroke
        assert!(STROKE.sweep_acceleration(-0.5) < 0.0);
        assert_eq!(STROKE.sweep_acceleration(0.0), 0.0);
        // upright at the reversal: all of Φω²
        assert!((STROKE.sweep_acceleration(FRAC_PI_2) - 5000.0).abs() < 1e-9);
    }

    #[test]
    fn a_standing_path_has_value_and_rate_of_mid_stroke_and_its_own_derivatives() {
        let [value, rate] = standing_path(0.0);
        assert_eq!((value[0], rate[0]), (1.0, 0.0));
        // y = p² has y₁ = 1 and y₁′ = 2
        for phase in [0.3, 1.0, 2.0, 4.0] {
            let [a, b] = standing_path(phase);
            let exact = phase.cos().powi(4) * phase.cos().signum();
            assert!((a[0] + b[0] - exact).abs() < 1e-12);
            let h = 1e-5;
            for (row, path) in [a, b].into_iter().enumerate() {
                let [up, down] = [h, -h].map(|h| standing_path(phase + h)[row]);
                assert!((path[1] - (up[0] - down[0]) / (2.0 * h)).abs() < 1e-9);
                assert!((path[2] - (up[1] - down[1]) / (2.0 * h)).abs() < 1e-9);
            }
        }
    }
}
