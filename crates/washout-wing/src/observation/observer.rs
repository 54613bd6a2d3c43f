//! A solved wing before the design's instrument: twist and leading edge at any station.

use nalgebra::Vector3;

use crate::coupling::solution::Solution;
use crate::geometry::Planform;
use crate::input::design::{CameraAxis, Design, Instrument};
use crate::input::measurement::Bound;
use crate::mesh::ChordLines;

use super::camera::Camera;
use super::deflection::{LeadingEdgeReading, displacement_at, leading_edge_at};
use super::edges::{Edges, edges_at, sections_at};
use super::error::ObservationError;
use super::picture::Picture;
use super::profile::{TwistProfile, TwistReading};
use super::station::{Place, SkipReason, SkippedStation, Station, readable, stations};

/// Places evenly along the span at which a wing is read besides the stations of its design.
const ALONG_SPAN: usize = 50;

/// A solved wing ready to be read at any station.
#[derive(Debug)]
pub struct Observer<'a> {
    design: &'a Design,
    planform: &'a Planform,
    solution: &'a Solution,
    lines: ChordLines<'a>,
    instrument: Instrument,
    camera: Option<Camera>,
    picture: Option<Picture>,
    root_angle_rad: Option<f64>,
}

impl<'a> Observer<'a> {
    /// The instrument of `design` before a solved wing.
    ///
    /// Errors: a camera whose axis or root angle is not stated or that sees the wing edge-on, or whose effects cannot act; states of
    /// another mesh.
    pub fn new(
        design: &'a Design,
        planform: &'a Planform,
        solution: &'a Solution,
    ) -> Result<Observer<'a>, ObservationError> {
        Observer::with(design.observation.instrument, design, planform, solution)
    }

    /// The same wing before another instrument, for measurements that were made with it; errors as [`Observer::new`].
    pub fn seen_by(&self, instrument: Instrument) -> Result<Observer<'a>, ObservationError> {
        Observer::with(instrument, self.design, self.planform, self.solution)
    }

    fn with(
        instrument: Instrument,
        design: &'a Design,
        planform: &'a Planform,
        solution: &'a Solution,
    ) -> Result<Observer<'a>, ObservationError> {
        let expected = solution.mesh.nodes.len();
        for (state, shape) in [("unloaded", &solution.rest), ("loaded", &solution.state)] {
            let found = shape.displacement.len().min(shape.rotation.len());
            if found != expected {
                return Err(ObservationError::ForeignState {
                    state,
                    found,
                    expected,
                });
            }
        }
        let root_angle_rad = root_angle_rad(design);
        let camera = match instrument {
            Instrument::ChordRotation => None,
            Instrument::Camera => Some(camera(design, root_angle_rad)?),
        };
        let picture = match camera {
            Some(camera) => Picture::of_design(design, camera)?,
            None => None,
        };
        let lines = ChordLines::new(&solution.mesh);
        Ok(Observer {
            design,
            planform,
            solution,
            lines,
            instrument,
            camera,
            picture,
            root_angle_rad,
        })
    }

    /// Twist along the span at the stations of the design.
    pub fn profile(&self) -> TwistProfile {
        let (mut readings, mut skipped) = (Vec::new(), Vec::new());
        for station in stations(self.design, self.planform) {
            match self.read(station) {
                Ok(reading) => readings.push(reading),
                Err(reason) => skipped.push(SkippedStation { station, reason }),
            }
        }
        TwistProfile {
            readings,
            skipped,
            instrument: self.instrument,
            camera_axis: self.camera.map(|camera| camera.axis),
            root_angle_rad: self.root_angle_rad,
        }
    }

    /// Twist at the stations of the design and at 50 places evenly from base to tip, r rising, where it can be read: also what the film does
    /// between spars.
    pub fn along_span(&self) -> Vec<TwistReading> {
        let step_m = self.planform.tip_m() / (ALONG_SPAN - 1) as f64;
        let mut places = stations(self.design, self.planform);
        for r_m in (0..ALONG_SPAN).map(|k| k as f64 * step_m) {
            if places.iter().all(|other| (other.r_m - r_m).abs() > 1e-6) {
                let place = Place::OnRequest;
                places.push(Station { place, r_m });
            }
        }
        places.sort_by(|a, b| a.r_m.total_cmp(&b.r_m));
        places
            .into_iter()
            .filter_map(|station| self.read(station).ok())
            .collect()
    }

    /// Twist at `r_m`.
    pub fn twist(&self, r_m: f64) -> Result<TwistReading, SkipReason> {
        let place = if r_m == 0.0 { Place::Base } else { Place::OnRequest };
        self.read(Station { place, r_m })
    }

    /// Leading edge at `r_m`; none off it.
    pub fn leading_edge(&self, r_m: f64) -> Option<LeadingEdgeReading> {
        leading_edge_at(self.solution, r_m)
    }

    /// Displacement (m) from the unloaded shape of the point at `chord_fraction` behind the leading edge at `r_m`, in
    /// the frame in which displacements are read; none off the wing.
    pub fn displacement(&self, r_m: f64, chord_fraction: f64) -> Option<Vector3<f64>> {
        let chord_m = self.planform.chord_m(r_m);
        let moved = displacement_at(self.solution, &self.lines, r_m, chord_fraction, chord_m)?;
        let (sin, cos) = self.design.observation.frame_pitch_deg.to_radians().sin_cos();
        let (y, z) = (moved.y, moved.z);
        Some(Vector3::new(moved.x, y * cos + z * sin, z * cos - y * sin))
    }

    /// What reads the twist.
    pub fn instrument(&self) -> Instrument {
        self.instrument
    }

    /// Design of the wing.
    pub fn design(&self) -> &Design {
        self.design
    }

    fn read(&self, station: Station) -> Result<TwistReading, SkipReason> {
        let Station { place, r_m } = station;
        let is_base = place == Place::Base;
        if !is_base {
            readable(self.design, self.planform, r_m)?;
        }
        let chord_m = self.planform.chord_m(r_m);
        let Solution {
            mesh, rest, state, ..
        } = self.solution;
        let edges = if is_base {
            sections_at(mesh, [rest, state], r_m, chord_m)
        } else {
            edges_at(mesh, &self.lines, [rest, state], r_m, chord_m)
        };
        let off_wing = SkipReason::OffWing {
            tip_m: self.planform.tip_m(),
        };
        let [unloaded, loaded] = edges.ok_or(off_wing)?;
        let (twist_rad, sigma_rad, bound) = match self.camera.filter(|_| !is_base) {
            None => (chord_rotation_rad(&unloaded, &loaded), None, Bound::None),
            Some(camera) => {
                let reading = match &self.picture {
                    Some(picture) => picture.read(&unloaded, &loaded, chord_m)?,
                    None => camera.read(&unloaded, &loaded, chord_m),
                };
                (reading.twist_rad, reading.sigma_rad, reading.bound)
            }
        };
        let moved = loaded.leading_m - unloaded.leading_m;
        Ok(TwistReading {
            place,
            r_m,
            chord_m,
            twist_rad,
            sigma_rad,
            bound,
            alpha_rad: self.root_angle_rad.map(|root| root - twist_rad),
            le_deflection_m: moved.z,
            le_sweep_m: moved.y,
        })
    }
}

/// Angle of the loaded chord about the span axis less that of the unloaded one, in (−π, π].
pub(super) fn chord_rotation_rad(unloaded: &Edges, loaded: &Edges) -> f64 {
    let (before, after) = (unloaded.chord(), loaded.chord());
    let sin = before.y * after.z - before.z * after.y;
    let cos = before.y * after.y + before.z * after.z;
    sin.atan2(cos)
}

fn root_angle_rad(design: &Design) -> Option<f64> {
    let flapping = design.flapping.as_ref().map(|flow| flow.stop_angle_deg.value());
    let root_angle_deg = flapping.or(design.steady.as_ref().map(|flow| flow.root_angle_deg.value()))?;
    Some(root_angle_deg.to_radians())
}

fn camera(design: &Design, root_angle_rad: Option<f64>) -> Result<Camera, ObservationError> {
    let axis = design
        .observation
        .camera_axis
        .ok_or(ObservationError::CameraWithoutAxis)?;
    let root_angle_rad = root_angle_rad.ok_or(ObservationError::CameraWithoutFlow)?;
    let distance_error_m = design.observation.camera_error_mm / 1e3;
    let camera = Camera {
        axis,
        root_angle_rad,
        distance_error_m,
    };
    if camera.seen_share().abs() < 1e-6 {
        let axis = match axis {
            CameraAxis::FlappingAxis => "flapping axis",
            CameraAxis::Stroke => "stroke",
        };
        let root_angle_deg = root_angle_rad.to_degrees();
        return Err(ObservationError::CameraSeesNothing { axis, root_angle_deg });
    }
    Ok(camera)
}

/// The twist profile of a solved wing at the stations of its design; errors as [`Observer::new`].
pub fn read_profile(
    design: &Design,
    planform: &Planform,
    solution: &Solution,
) -> Result<TwistProfile, ObservationError> {
    Ok(Observer::new(design, planform, solution)?.profile())
}

/// Twist at `r_m` by the design's instrument, rad; none where it cannot be read.
pub fn twist_at(design: &Design, planform: &Planform, solution: &Solution, r_m: f64) -> Option<f64> {
    let observer = Observer::new(design, planform, solution).ok()?;
    Some(observer.twist(r_m).ok()?.twist_rad)
}
