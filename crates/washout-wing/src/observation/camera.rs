//! The paper's instrument: the projected distance between the edges in a video frame, turned into twist.
//!
//! With the root at its stop the relative air comes along w = cos α_root ŷ + sin α_root ẑ, so that is the line
//! of the stroke; span and stroke span the stroke plane, so the flapping axis is u = −sin α_root ŷ + cos α_root ẑ.
//! A chord with twist θ, cos θ ŷ + sin θ ẑ, has w part cos(α_root − θ) and u part −sin(α_root − θ). A camera
//! along u shows the w part, so d/d₀ = cos α / cos α_root; along the stroke it shows the u part, so
//! d/d₀ = sin α / sin α_root. The part along the span (bending) is seen by both.

use nalgebra::Vector3;

use crate::input::design::CameraAxis;

use super::edges::Edges;
use crate::input::measurement::Bound;

/// Below this angle of attack a wing counts as feathered, rad: its reading is a bound.
pub const FEATHERED_RAD: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// A camera at mid-stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Axis along which it looks.
    pub axis: CameraAxis,
    /// Angle of attack of the root at its stop, rad.
    pub root_angle_rad: f64,
    /// Error of a distance in the frame, m.
    pub distance_error_m: f64,
}

/// Twist as the camera reads it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CameraReading {
    /// Twist, rad.
    pub twist_rad: f64,
    /// Its error from that of the distance, rad: σ_d/(c |∂(d/c)/∂θ|); none where the distance says nothing
    /// about the angle (saturated, or an error above 90 deg).
    pub sigma_rad: Option<f64>,
    /// Whether it is only a bound: feathered, or near a fold of the projection.
    pub bound: Bound,
    /// d/d₀.
    pub ratio: f64,
}

impl Camera {
    /// The direction across the span that the frame shows: the stroke, or the flapping axis.
    pub fn seen_direction(&self) -> Vector3<f64> {
        self.direction_of(match self.axis {
            CameraAxis::FlappingAxis => CameraAxis::Stroke,
            CameraAxis::Stroke => CameraAxis::FlappingAxis,
        })
    }

    /// The direction of its axis: toward lift along the flapping axis, downstream along the stroke.
    pub fn axis_direction(&self) -> Vector3<f64> {
        self.direction_of(self.axis)
    }

    /// Unit vector along an axis, wing frame: u or w of the module.
    pub fn direction_of(&self, axis: CameraAxis) -> Vector3<f64> {
        let (sin, cos) = self.root_angle_rad.sin_cos();
        match axis {
            CameraAxis::Stroke => Vector3::new(0.0, cos, sin),
            CameraAxis::FlappingAxis => Vector3::new(0.0, -sin, cos),
        }
    }

    /// Share of the chord of the untwisted wing that the frame shows: cos α_root or sin α_root.
    pub fn seen_share(&self) -> f64 {
        match self.axis {
            CameraAxis::FlappingAxis => self.root_angle_rad.cos(),
            CameraAxis::Stroke => self.root_angle_rad.sin(),
        }
    }

    /// Projected distance between the edges, m; negative where the trailing edge is on the other side of the
    /// leading edge than u or w points.
    pub fn distance_m(&self, edges: &Edges) -> f64 {
        let chord = edges.chord();
        let across = chord.dot(&self.seen_direction());
        across.hypot(chord.x).copysign(across)
    }

    /// The twist that this camera reads from the untwisted and the loaded wing at a chord of `chord_m`.
    pub fn read(&self, untwisted: &Edges, loaded: &Edges, chord_m: f64) -> CameraReading {
        self.invert(self.distance_m(loaded) / self.distance_m(untwisted), chord_m)
    }

    /// The twist for a ratio d/d₀; beyond what an angle can give it is the largest or smallest twist, as a bound.
    pub fn invert(&self, ratio: f64, chord_m: f64) -> CameraReading {
        let share = ratio * self.seen_share();
        let held = share.clamp(-1.0, 1.0);
        let half_turn = std::f64::consts::PI;
        // Toward the folds the twist may lie beyond the reading: on which side follows from the projection.
        let (alpha_rad, slope, folds) = match self.axis {
            CameraAxis::FlappingAxis => {
                let alpha = held.acos();
                (
                    alpha,
                    alpha.sin(),
                    [(0.0, Bound::Lower), (half_turn, Bound::Upper)],
                )
            }
            CameraAxis::Stroke => {
                let alpha = held.asin();
                (
                    alpha,
                    alpha.cos(),
                    [(-half_turn / 2.0, Bound::Lower), (half_turn / 2.0, Bound::Upper)],
                )
            }
        };
        let folded = folds
            .iter()
            .find(|(fold, _)| (alpha_rad - fold).abs() < FEATHERED_RAD);
        let bound = match folded {
            Some((_, bound)) => *bound,
            None if alpha_rad < FEATHERED_RAD => Bound::Lower,
            None => Bound::None,
        };
        let sigma_rad = self.distance_error_m / (chord_m * slope);
        let tells = share == held && sigma_rad < half_turn / 2.0;
        CameraReading {
            twist_rad: self.root_angle_rad - alpha_rad,
            sigma_rad: tells.then_some(sigma_rad),
            bound,
            ratio,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(axis: CameraAxis) -> Camera {
        Camera {
            axis,
            root_angle_rad: 45.0f64.to_radians(),
            distance_error_m: 0.2e-3,
        }
    }

    fn edges(chord_m: f64, twist_rad: f64) -> Edges {
        let leading_m = Vector3::new(0.03, 0.001, 0.002);
        let chord = Vector3::new(0.0, twist_rad.cos(), twist_rad.sin()) * chord_m;
        Edges {
            leading_m,
            trailing_m: leading_m + chord,
        }
    }

    #[test]
    fn both_views_give_back_the_twist_of_a_rigid_section() {
        for axis in [CameraAxis::FlappingAxis, CameraAxis::Stroke] {
            for twist_deg in [-30.0, 0.0, 5.0, 23.0, 39.0f64] {
                let reading =
                    camera(axis).read(&edges(0.02, 0.0), &edges(0.02, twist_deg.to_radians()), 0.02);
                assert!(
                    (reading.twist_rad.to_degrees() - twist_deg).abs() < 1e-9,
                    "{axis:?} {reading:?}"
                );
                assert_eq!(reading.bound, Bound::None);
            }
        }
    }

    #[test]
    fn the_ratio_is_that_of_the_cosines_or_sines_of_alpha() {
        let (root, twist) = (45.0f64.to_radians(), 20.0f64.to_radians());
        let (rest, loaded) = (edges(0.02, 0.0), edges(0.02, twist));
        let along_axis = camera(CameraAxis::FlappingAxis).read(&rest, &loaded, 0.02).ratio;
        assert!((along_axis - (root - twist).cos() / root.cos()).abs() < 1e-12);
        let along_stroke = camera(CameraAxis::Stroke).read(&rest, &loaded, 0.02).ratio;
        assert!((along_stroke - (root - twist).sin() / root.sin()).abs() < 1e-12);
    }

    #[test]
    fn two_tenths_of_a_millimetre_are_4_to_26_degrees_over_the_last_8_mm_of_twist_v1_but_1_along_the_stroke()
    {
        // r, chord of the beta distribution (p = 1.367, q = 1.501), twist of v1 as first stated.
        for (chord_mm, alpha_deg, along_axis_deg, along_stroke_deg) in
            [(14.9, 11.6, 3.8, 0.79), (7.94, 3.42, 24.2, 1.45f64)]
        {
            let read = |axis| {
                let twist: f64 = 45.0 - alpha_deg;
                camera(axis).read(
                    &edges(chord_mm / 1e3, 0.0),
                    &edges(chord_mm / 1e3, twist.to_radians()),
                    chord_mm / 1e3,
                )
            };
            let sigma = |axis| read(axis).sigma_rad.unwrap().to_degrees();
            assert!((sigma(CameraAxis::FlappingAxis) - along_axis_deg).abs() < 0.1);
            assert!((sigma(CameraAxis::Stroke) - along_stroke_deg).abs() < 0.02);
        }
    }

    #[test]
    fn sigma_is_the_change_of_the_reading_with_the_distance() {
        for axis in [CameraAxis::FlappingAxis, CameraAxis::Stroke] {
            let camera = camera(axis);
            let (chord_m, step_m) = (0.02, 1e-8);
            let distance_m = camera.distance_m(&edges(chord_m, 0.4));
            let untwisted_m = camera.distance_m(&edges(chord_m, 0.0));
            let twist = |d_m: f64| camera.invert(d_m / untwisted_m, chord_m).twist_rad;
            let slope = (twist(distance_m + step_m) - twist(distance_m - step_m)) / (2.0 * step_m);
            let sigma = camera
                .invert(distance_m / untwisted_m, chord_m)
                .sigma_rad
                .unwrap();
            assert!(
                (sigma - (slope * camera.distance_error_m).abs()).abs() < 1e-6 * sigma,
                "{axis:?}"
            );
        }
    }

    #[test]
    fn a_distance_beyond_any_angle_is_a_bound_without_sigma_and_never_nan() {
        for axis in [CameraAxis::FlappingAxis, CameraAxis::Stroke] {
            for ratio in [1.42, 5.0, -1.5, -9.0] {
                let reading = camera(axis).invert(ratio, 0.02);
                assert!(reading.twist_rad.is_finite());
                assert_eq!(reading.sigma_rad, None);
                assert_ne!(reading.bound, Bound::None);
            }
        }
        assert!(
            (camera(CameraAxis::FlappingAxis)
                .invert(1.42, 0.02)
                .twist_rad
                .to_degrees()
                - 45.0)
                .abs()
                < 1e-12
        );
    }

    #[test]
    fn a_feathered_section_reads_as_a_lower_bound_in_both_views() {
        for (axis, read_deg) in [(CameraAxis::FlappingAxis, 42.0), (CameraAxis::Stroke, 48.0)] {
            let reading = camera(axis).read(&edges(0.02, 0.0), &edges(0.02, 48.0f64.to_radians()), 0.02);
            assert_eq!(reading.bound, Bound::Lower);
            assert!(
                (reading.twist_rad.to_degrees() - read_deg).abs() < 1e-9,
                "{axis:?} {reading:?}"
            );
        }
    }

    #[test]
    fn bending_foreshortens_nothing_but_adds_its_part_along_the_span() {
        let camera = camera(CameraAxis::FlappingAxis);
        let mut swept = edges(0.02, 0.3);
        swept.trailing_m.x += 0.004;
        let across = (45.0f64.to_radians() - 0.3).cos() * 0.02;
        assert!((camera.distance_m(&swept) - across.hypot(0.004)).abs() < 1e-15);
    }
}
