//! A picture that is not as the design states it: the camera stands near, or is turned, or the frame is late.
//!
//! The camera of [`super::camera`] is far away, so that a point is shown where it lies along the span and along the seen
//! direction q. One at the distance 1/κ, on the axis a and aimed at the place p on the leading edge, is a pinhole (Hartley &
//! Zisserman 2004, Multiple View Geometry, ch. 6): a point with P = X − p is shown at (P·x̂, P·q) / (1 − κ P·a), in lengths at
//! the distance of p. Tilt turns q and a about the span; in a late frame the wing has swung on about the flapping axis, the
//! untwisted one has not. What is shown is turned into twist as if nothing of this were so.

use nalgebra::{Rotation3, Vector2, Vector3};

use crate::effects::{View, bind};
use crate::input::design::{CameraAxis, Design};

use super::camera::{Camera, CameraReading};
use super::edges::Edges;
use super::error::ObservationError;
use super::station::SkipReason;

/// A camera, and how it differs from what the design says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Picture {
    /// The camera as the design has it.
    pub camera: Camera,
    /// How the picture is taken.
    pub view: View,
    /// Distance from the flapping axis to the wing base, m.
    pub root_offset_m: f64,
}

impl Picture {
    /// The picture that the effects of a design make of its camera's; none if they leave that as it is.
    ///
    /// # Errors
    /// If an effect is none, or cannot act.
    pub fn of_design(design: &Design, camera: Camera) -> Result<Option<Picture>, ObservationError> {
        let mut view = View::default();
        for bound in bind(design).map_err(Box::new)? {
            bound.effect.view(&bound.values, design, &mut view);
        }
        if view == View::default() {
            return Ok(None);
        }
        Ok(Some(Picture {
            camera,
            view,
            root_offset_m: design.planform.root_offset_mm.value() * 1e-3,
        }))
    }

    /// The twist that is read from pictures of the untwisted and the loaded wing at a chord of `chord_m`, as
    /// [`Camera::read`].
    ///
    /// # Errors
    /// If the camera stands so near that an edge lies beside or behind it.
    pub fn read(&self, untwisted: &Edges, loaded: &Edges, chord_m: f64) -> Result<CameraReading, SkipReason> {
        let distance = |edges: &Edges| {
            self.distance_m(edges).ok_or(SkipReason::OutOfSight {
                distance_m: 1.0 / self.view.nearness_per_m.abs(),
            })
        };
        let at_rest = distance(untwisted)?;
        let shown = distance(&self.swung(loaded))?;
        Ok(self.camera.invert(shown / at_rest, chord_m))
    }

    /// Distance between the edges in the picture, m at the distance of the place that the camera is aimed at, signed as
    /// [`Camera::distance_m`]; none if one of them lies beside or behind the camera.
    pub fn distance_m(&self, edges: &Edges) -> Option<f64> {
        let chord = self.shown(&edges.trailing_m)? - self.shown(&edges.leading_m)?;
        Some(chord.norm().copysign(chord.y))
    }

    /// Where a point is shown, m along the span and along the seen direction, from the place that the camera is aimed at.
    fn shown(&self, point_m: &Vector3<f64>) -> Option<Vector2<f64>> {
        let tilt = Rotation3::from_axis_angle(&Vector3::x_axis(), self.view.tilt_rad);
        let (across, axis) = (
            tilt * self.camera.seen_direction(),
            tilt * self.camera.axis_direction(),
        );
        let from_aim = point_m - Vector3::x() * self.view.aim_m;
        let depth = 1.0 - self.view.nearness_per_m * axis.dot(&from_aim);
        (depth > 0.0).then(|| Vector2::new(from_aim.x, across.dot(&from_aim)) / depth)
    }

    /// The edges after the wing has swung on against the air, about the flapping axis.
    fn swung(&self, edges: &Edges) -> Edges {
        // lift points along the flapping axis; the wing turns about it the other way round
        let flapping_axis = self.camera.direction_of(CameraAxis::FlappingAxis);
        let swing = Rotation3::new(flapping_axis * -self.view.swing_rad);
        let hub = -Vector3::x() * self.root_offset_m;
        Edges {
            leading_m: hub + swing * (edges.leading_m - hub),
            trailing_m: hub + swing * (edges.trailing_m - hub),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix3, Matrix3x4, Vector4};

    const ROOT_DEG: f64 = 45.0;
    const CHORD_M: f64 = 0.02;

    fn picture(axis: CameraAxis, view: View) -> Picture {
        let camera = Camera {
            axis,
            root_angle_rad: ROOT_DEG.to_radians(),
            distance_error_m: 0.2e-3,
        };
        Picture {
            camera,
            view: View { aim_m: 0.035, ..view },
            root_offset_m: 0.038,
        }
    }

    fn edges(r_m: f64, twist_deg: f64) -> Edges {
        let leading_m = Vector3::new(r_m, 0.0, 0.0);
        let twist = twist_deg.to_radians();
        Edges {
            leading_m,
            trailing_m: leading_m + Vector3::new(0.0, twist.cos(), twist.sin()) * CHORD_M,
        }
    }

    fn read_deg(picture: &Picture, r_m: f64, twist_deg: f64) -> f64 {
        let reading = picture
            .read(&edges(r_m, 0.0), &edges(r_m, twist_deg), CHORD_M)
            .unwrap();
        reading.twist_rad.to_degrees()
    }

    /// x = K [R | −R C] X with homogeneous coordinates: focal length and image plane drop out of d/d0.
    #[test]
    fn a_near_camera_that_is_turned_shows_what_the_matrix_of_a_pinhole_gives() {
        let (sin, cos) = ROOT_DEG.to_radians().sin_cos();
        let (stroke, flapping) = (Vector3::new(0.0, cos, sin), Vector3::new(0.0, -sin, cos));
        for (axis, seen, along) in [
            (CameraAxis::FlappingAxis, stroke, flapping),
            (CameraAxis::Stroke, flapping, stroke),
        ] {
            for (nearness_per_m, tilt_rad) in [(4.0, 0.0), (-4.0, 0.0), (2.5, 0.1), (-2.5, -0.2)] {
                let (sin, cos) = f64::sin_cos(tilt_rad);
                // both turned about the span, from y toward z
                let turned =
                    |v: Vector3<f64>| Vector3::new(v.x, v.y * cos - v.z * sin, v.y * sin + v.z * cos);
                let (seen, along) = (turned(seen), turned(along));
                let centre = Vector3::new(0.035, 0.0, 0.0) + along / nearness_per_m;
                // it looks back at the wing, from either side
                let look = -along * f64::signum(nearness_per_m);
                let pose =
                    Matrix3::from_rows(&[Vector3::x().transpose(), seen.transpose(), look.transpose()]);
                let moved = -pose * centre;
                let focal = Matrix3::from_diagonal(&Vector3::new(0.05, 0.05, 1.0));
                let matrix: Matrix3x4<f64> = focal
                    * Matrix3x4::from_columns(&[
                        pose.column(0).into_owned(),
                        pose.column(1).into_owned(),
                        pose.column(2).into_owned(),
                        moved,
                    ]);
                let shown = |point: &Vector3<f64>| {
                    let image = matrix * Vector4::new(point.x, point.y, point.z, 1.0);
                    Vector2::new(image.x / image.z, image.y / image.z)
                };
                let length = |edges: &Edges| (shown(&edges.trailing_m) - shown(&edges.leading_m)).norm();
                let mut loaded = edges(0.05, 20.0);
                let bent = Vector3::new(-0.001, 0.002, 0.004);
                loaded.leading_m += bent;
                loaded.trailing_m += bent;
                let view = View {
                    nearness_per_m,
                    tilt_rad,
                    ..View::default()
                };
                let found = picture(axis, view).read(&edges(0.05, 0.0), &loaded, CHORD_M);
                let expected = length(&loaded) / length(&edges(0.05, 0.0));
                let ratio = found.unwrap().ratio;
                assert!((ratio / expected - 1.0).abs() < 1e-12, "{ratio} {expected}");
            }
        }
    }

    /// Lines of sight drawn from a camera 250 mm away and cut with the plane through the leading edge, by another program.
    #[test]
    fn readings_from_250_mm_away_are_those_of_lines_of_sight() {
        for (axis, nearness_per_m, twist_deg, off_deg) in [
            (CameraAxis::Stroke, 4.0, 20.0, -0.636),
            (CameraAxis::Stroke, -4.0, 20.0, 0.227),
            (CameraAxis::FlappingAxis, 4.0, 5.0, 0.299),
            (CameraAxis::FlappingAxis, -4.0, 20.0, -2.906),
        ] {
            let view = View {
                nearness_per_m,
                ..View::default()
            };
            let found = read_deg(&picture(axis, view), 0.05, twist_deg) - twist_deg;
            assert!((found - off_deg).abs() < 6e-4, "{axis:?} {found} {off_deg}");
        }
    }

    #[test]
    fn a_tilted_camera_counts_the_angle_of_attack_from_its_own_line() {
        let (root, alpha, tilt) = (45.0f64.to_radians(), 25.0f64.to_radians(), 5.0f64.to_radians());
        let view = View {
            tilt_rad: tilt,
            ..View::default()
        };
        let by_stroke = (root.sin() * (alpha + tilt).sin() / (root + tilt).sin()).asin();
        let found = read_deg(&picture(CameraAxis::Stroke, view), 0.05, 20.0);
        assert!((found - (root - by_stroke).to_degrees()).abs() < 1e-9);
        let by_axis = (root.cos() * (alpha + tilt).cos() / (root + tilt).cos())
            .min(1.0)
            .acos();
        let found = read_deg(&picture(CameraAxis::FlappingAxis, view), 0.05, 20.0);
        assert!((found - (root - by_axis).to_degrees()).abs() < 1e-9);
    }

    /// The swung chord shows part of its length along the span: d² = c² (sin² α + cos² α sin² ψ). Along the flapping axis nothing
    /// changes.
    #[test]
    fn a_wing_that_has_swung_on_is_seen_askew_along_the_stroke_alone() {
        let (root, alpha, swing) = (45.0f64.to_radians(), 25.0f64.to_radians(), 9.0f64.to_radians());
        for swing_rad in [swing, -swing] {
            let view = View {
                swing_rad,
                ..View::default()
            };
            let shown = alpha.sin().hypot(alpha.cos() * swing.sin());
            let found = read_deg(&picture(CameraAxis::Stroke, view), 0.05, 20.0);
            assert!((found - (root - shown.asin()).to_degrees()).abs() < 1e-9);
            let found = read_deg(&picture(CameraAxis::FlappingAxis, view), 0.05, 20.0);
            assert!((found - 20.0).abs() < 1e-9);
        }
    }

    /// The wing runs against the air: 30 deg on, its tip has come (70 + 38) mm · sin 30 deg nearer to a camera upstream.
    #[test]
    fn a_late_wing_has_come_nearer_to_a_camera_that_it_flies_toward() {
        let view = View {
            swing_rad: 30.0f64.to_radians(),
            ..View::default()
        };
        let picture = picture(CameraAxis::Stroke, view);
        let swung = picture.swung(&edges(0.07, 0.0)).leading_m;
        let downstream = picture.camera.axis_direction().dot(&swung);
        assert!((downstream + 0.054).abs() < 1e-12, "{downstream}");
    }

    #[test]
    fn a_wing_behind_the_camera_is_not_seen() {
        let view = View {
            nearness_per_m: 100.0,
            ..View::default()
        };
        let found = picture(CameraAxis::Stroke, view).read(&edges(0.05, 0.0), &edges(0.05, 20.0), CHORD_M);
        assert_eq!(found, Err(SkipReason::OutOfSight { distance_m: 0.01 }));
    }
}
