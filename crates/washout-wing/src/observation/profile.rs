//! Twist along the span as the design's instrument reads it.

use crate::input::design::{CameraAxis, Instrument};
use crate::input::measurement::Bound;

use super::station::{Place, SkippedStation};

/// Share of the span below which two stations count as one place in a fit.
pub const CLOSE: f64 = 0.02;

/// Twist along the span, r rising.
#[derive(Debug, Clone, PartialEq)]
pub struct TwistProfile {
    /// What was read.
    pub readings: Vec<TwistReading>,
    /// Stations that were not read, and why.
    pub skipped: Vec<SkippedStation>,
    /// Instrument.
    pub instrument: Instrument,
    /// Axis of the camera, if it is one.
    pub camera_axis: Option<CameraAxis>,
    /// Angle of attack of the root, rad; none without flow.
    pub root_angle_rad: Option<f64>,
}

/// Twist at one station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwistReading {
    /// What stands there.
    pub place: Place,
    /// Distance from the wing base, m.
    pub r_m: f64,
    /// Chord at rest, m.
    pub chord_m: f64,
    /// Twist, rad; positive is washout. Relative to the unloaded (cured) shape.
    pub twist_rad: f64,
    /// Error of the instrument, rad; none for `chord_rotation`, at the clamp, and where the camera is saturated.
    pub sigma_rad: Option<f64>,
    /// Whether it is a value or a bound.
    pub bound: Bound,
    /// Angle of attack of the chord, α_root − θ, rad; none without flow.
    pub alpha_rad: Option<f64>,
    /// Deflection of the leading edge across the wing plane from the unloaded shape, m, positive along +z.
    pub le_deflection_m: f64,
    /// Sweep of the leading edge in the wing plane from the unloaded shape, m, positive toward the trailing edge.
    pub le_sweep_m: f64,
}

impl TwistProfile {
    /// Points `[r_m, twist_rad]` for a fit: the readings that are values, without the base.
    ///
    /// Of readings closer than [`CLOSE`] of the span that at a spar end stays, so that no stage rests on two places
    /// that are one.
    pub fn points(&self) -> Vec<[f64; 2]> {
        let close_m = CLOSE * self.readings.last().map_or(0.0, |last| last.r_m);
        let is_spar_end = |reading: &TwistReading| matches!(reading.place, Place::SparEnd(_));
        let mut kept: Vec<&TwistReading> = Vec::new();
        for reading in &self.readings {
            if reading.bound != Bound::None || reading.place == Place::Base {
                continue;
            }
            match kept.last() {
                Some(last) if reading.r_m - last.r_m >= close_m => kept.push(reading),
                Some(last) if !is_spar_end(last) && is_spar_end(reading) => {
                    kept.pop();
                    kept.push(reading);
                }
                Some(_) => {}
                None => kept.push(reading),
            }
        }
        kept.iter()
            .map(|reading| [reading.r_m, reading.twist_rad])
            .collect()
    }

    /// The clamp, `[r_m, twist_rad]`.
    pub fn base(&self) -> Option<[f64; 2]> {
        let base = self
            .readings
            .iter()
            .find(|reading| reading.place == Place::Base)?;
        Some([base.r_m, base.twist_rad])
    }

    /// The reading at the tip station, if the chord there could be read.
    pub fn tip(&self) -> Option<&TwistReading> {
        self.readings.iter().find(|reading| reading.place == Place::Tip)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observation::imposed::{design, wing};
    use crate::observation::{ObservationError, read_profile, twist_at};

    fn twist_rad(r_m: f64) -> f64 {
        6.0 * r_m + 40.0 * r_m * r_m
    }

    #[test]
    fn an_imposed_twist_is_read_at_base_spar_ends_and_tip() {
        let design = design("");
        let (planform, solution) = wing(&design, twist_rad, |_| [0.0, 0.0]);
        let profile = read_profile(&design, &planform, &solution).unwrap();
        let r_mm: Vec<f64> = profile
            .readings
            .iter()
            .map(|reading| (reading.r_m * 1e4).round() / 10.0)
            .collect();
        assert_eq!(r_mm, [0.0, 2.8, 18.9, 35.0, 51.1, 67.2, 67.9]);
        assert!(profile.skipped.is_empty());
        for reading in &profile.readings {
            // Between two columns of nodes the film is straight, so the angle there is a chord's of the curve's.
            assert!(
                (reading.twist_rad - twist_rad(reading.r_m)).abs() < 2e-4,
                "{reading:?}"
            );
            let alpha_rad = 45.0f64.to_radians() - reading.twist_rad;
            assert!((reading.alpha_rad.unwrap() - alpha_rad).abs() < 1e-15);
            assert_eq!(reading.bound, Bound::None);
        }
        let spar_ends = profile
            .readings
            .iter()
            .filter(|reading| matches!(reading.place, Place::SparEnd(_)));
        for reading in spar_ends {
            assert!(
                (reading.twist_rad - twist_rad(reading.r_m)).abs() < 1e-12,
                "{reading:?}"
            );
        }
        assert!((profile.tip().unwrap().r_m - 0.0679).abs() < 1e-12);
        assert_eq!(profile.base(), Some([0.0, 0.0]));
        // The tip stands 0.7 mm from the last spar, so the spar alone counts in a fit.
        let fitted_mm: Vec<f64> = profile.points().iter().map(|point| point[0] * 1e3).collect();
        assert_eq!(fitted_mm, [2.8, 18.9, 35.0, 51.1, 67.2]);
    }

    #[test]
    fn twist_is_counted_from_the_cured_shape() {
        let design = design("");
        let (planform, mut solution) = wing(&design, twist_rad, |_| [0.0, 0.0]);
        let (_, cured) = wing(&design, |r_m| 2.0 * r_m, |_| [0.0, 1e-3]);
        solution.rest = cured.state;
        let twist = twist_at(&design, &planform, &solution, 0.035).unwrap();
        assert!((twist - (twist_rad(0.035) - 0.07)).abs() < 1e-12);
        let profile = read_profile(&design, &planform, &solution).unwrap();
        assert!(
            profile
                .readings
                .iter()
                .all(|reading| (reading.le_deflection_m + 1e-3).abs() < 1e-12)
        );
    }

    #[test]
    fn rigid_translation_and_leading_edge_deflection_leave_the_chord_rotation_alone() {
        let design = design("");
        let (planform, solution) = wing(&design, twist_rad, |r_m| [0.5 * r_m * r_m, 3.0 * r_m * r_m]);
        let profile = read_profile(&design, &planform, &solution).unwrap();
        let reading = &profile.readings[3];
        assert!((reading.twist_rad - twist_rad(reading.r_m)).abs() < 1e-12);
        assert!((reading.le_deflection_m - 3.0 * 0.035f64.powi(2)).abs() < 1e-12);
        assert!((reading.le_sweep_m - 0.5 * 0.035f64.powi(2)).abs() < 1e-12);
    }

    #[test]
    fn both_cameras_agree_with_the_rotation_on_a_wing_whose_chords_stay_straight() {
        for axis in ["flapping-axis", "stroke"] {
            let mut design = design("");
            let (planform, solution) = wing(&design, twist_rad, |r_m| [0.0, 2.0 * r_m * r_m]);
            let rotation = read_profile(&design, &planform, &solution).unwrap();
            design.observation.instrument = Instrument::Camera;
            design.observation.camera_axis = toml::Value::from(axis).try_into().ok();
            let camera = read_profile(&design, &planform, &solution).unwrap();
            for (seen, turned) in camera.readings.iter().zip(&rotation.readings) {
                // Off the columns of nodes an imposed turn shortens the interpolated chord a little.
                let slack_rad = if seen.place == Place::Tip { 2e-4 } else { 1e-9 };
                assert!(
                    (seen.twist_rad - turned.twist_rad).abs() < slack_rad,
                    "{axis} {seen:?} {turned:?}"
                );
                assert_eq!(seen.sigma_rad.is_some(), seen.place != Place::Base);
            }
        }
    }

    #[test]
    fn a_feathered_tip_is_a_bound_for_the_camera_and_leaves_the_points_of_a_fit() {
        let mut design = design("");
        let (planform, solution) = wing(&design, |r_m| 11.0 * r_m, |_| [0.0, 0.0]);
        design.observation.instrument = Instrument::Camera;
        design.observation.camera_axis = Some(CameraAxis::FlappingAxis);
        let profile = read_profile(&design, &planform, &solution).unwrap();
        let bounds = profile
            .readings
            .iter()
            .filter(|reading| reading.bound == Bound::Lower)
            .count();
        assert_eq!(bounds, 2, "{profile:?}");
        assert_eq!(profile.points().len(), 4);
    }

    #[test]
    fn stations_with_too_small_a_chord_or_off_the_wing_are_reported_never_extrapolated() {
        let mut design = design("");
        design.observation.smallest_chord = 0.6;
        design.observation.stations_mm = vec![69.9];
        let (planform, solution) = wing(&design, twist_rad, |_| [0.0, 0.0]);
        let profile = read_profile(&design, &planform, &solution).unwrap();
        let places: Vec<Place> = profile
            .skipped
            .iter()
            .map(|skipped| skipped.station.place)
            .collect();
        assert_eq!(places, [Place::SparEnd(4), Place::Tip, Place::OnRequest]);
        assert_eq!(profile.tip(), None);
        assert!(profile.skipped[1].reason.to_string().contains("does not exceed"));
        assert!(
            profile.skipped[2]
                .reason
                .to_string()
                .contains("nothing is extrapolated")
        );
        assert_eq!(twist_at(&design, &planform, &solution, 0.0699), None);
        assert_eq!(twist_at(&design, &planform, &solution, f64::NAN), None);
    }

    #[test]
    fn a_wing_without_film_is_read_from_its_rod() {
        let mut design = design("");
        let (planform, mut solution) = wing(&design, twist_rad, |_| [0.0, 0.0]);
        solution.mesh.triangles.clear();
        design.observation.stations_mm = vec![40.0];
        let profile = read_profile(&design, &planform, &solution).unwrap();
        for reading in &profile.readings {
            assert!(
                (reading.twist_rad - twist_rad(reading.r_m)).abs() < 2e-4,
                "{reading:?}"
            );
        }
    }

    #[test]
    fn a_camera_without_axis_without_flow_or_edge_on_is_refused_with_the_cure() {
        let mut design = design("");
        let (planform, solution) = wing(&design, twist_rad, |_| [0.0, 0.0]);
        design.observation.instrument = Instrument::Camera;
        let error = read_profile(&design, &planform, &solution).unwrap_err();
        assert!(error.to_string().contains("camera_axis = \"flapping-axis\""));
        design.observation.camera_axis = Some(CameraAxis::Stroke);
        let flapping = design.flapping.as_mut().unwrap();
        flapping.stop_angle_deg = 0.0.into();
        let error = read_profile(&design, &planform, &solution).unwrap_err();
        assert!(error.to_string().contains("edge-on"));
        design.flapping = None;
        let error = read_profile(&design, &planform, &solution).unwrap_err();
        assert_eq!(error, ObservationError::CameraWithoutFlow);
    }

    #[test]
    fn a_solution_of_another_mesh_is_refused() {
        let design = design("");
        let (planform, mut solution) = wing(&design, twist_rad, |_| [0.0, 0.0]);
        solution.rest.displacement.pop();
        let error = read_profile(&design, &planform, &solution).unwrap_err();
        assert!(matches!(
            error,
            ObservationError::ForeignState {
                state: "unloaded",
                ..
            }
        ));
    }
}
