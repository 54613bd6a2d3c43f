//! The stroke in motion for the viewer: shapes at phases, and where the rod is at each.
//!
//! Shapes stand in the frame of the rod, as what they differ by from the unloaded wing: small numbers, and the viewer can draw the
//! unloaded wing at the same place in space.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Point3, Rotation3, Vector3};

use crate::export::ExportError;
use crate::export::vtu::Grid;
use crate::page::text::significant;
use crate::wing::stroke::{MovingRow, PhaseRow};

use super::numbers::{component_of, finite, joined, micrometres};

/// Numbers that a stroke may put into a page, about 1.5 MB of text; of more phases every second is shown, or every third.
const MOST_NUMBERS: usize = 300_000;
/// Numbers of a point at one phase: three of its place, twist, pressure.
const PER_POINT: usize = 5;

/// A wing at phases of its stroke.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    phases: Vec<Phase>,
    /// How many phases were solved.
    solved: usize,
}

#[derive(Debug, Clone, PartialEq)]
struct Phase {
    /// Row of the phase in the document, at `/stroke/phases`.
    row: usize,
    pose: Pose,
    /// How far each point is from where it is unloaded, mm, frame of the rod.
    moved_mm: Vec<[f64; 3]>,
    twist_deg: Vec<f64>,
    pressure_pa: Vec<f64>,
}

/// From the frame of the rod to space.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pose {
    turn: Matrix3<f64>,
    shift_mm: Vector3<f64>,
}

impl Pose {
    /// Pitch about the span, the offset of the base, the sweep about the axis of the stroke, and the mirror of the second
    /// half-stroke, as [`crate::coupling::instant::Instant::in_space`] has them.
    fn new(phase_deg: f64, moving: &MovingRow, root_offset_mm: f64) -> Pose {
        let about =
            |axis, angle_deg: f64| Rotation3::from_axis_angle(&axis, angle_deg.to_radians()).into_inner();
        let is_first_half = (phase_deg.to_radians() / PI).round().rem_euclid(2.0) == 0.0;
        let side = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, if is_first_half { 1.0 } else { -1.0 }));
        let swept = side * about(Vector3::y_axis(), moving.sweep_deg);
        Pose {
            turn: swept * about(Vector3::x_axis(), moving.pitch_deg),
            shift_mm: swept * Vector3::x() * root_offset_mm,
        }
    }

    fn back(&self, point_mm: [f64; 3]) -> Vector3<f64> {
        self.turn.transpose() * (Point3::from(point_mm).coords - self.shift_mm)
    }
}

impl Stroke {
    /// Rows of the phases that are shown of `rows` at a mesh of `points`.
    pub fn shown(rows: &[PhaseRow], points: usize) -> impl Iterator<Item = usize> {
        let step = (rows.len() * points * PER_POINT).div_ceil(MOST_NUMBERS).max(1);
        (0..rows.len()).step_by(step)
    }

    /// From the shapes of phases in space, each with its row; none where a row is not of a motion.
    pub fn new(
        rows: &[PhaseRow],
        shapes: &[(usize, Grid)],
        rest_mm: &[[f64; 3]],
        root_offset_mm: f64,
    ) -> Option<Stroke> {
        let phase = |(row, shape): &(usize, Grid)| {
            let own = rows.get(*row)?;
            let pose = Pose::new(own.phase_deg, own.moving.as_ref()?, root_offset_mm);
            let points = shape.points_mm.len();
            let moved = shape.points_mm.iter().zip(rest_mm);
            let values = |name| component_of(&shape.point_arrays, name, 0, points);
            (points == rest_mm.len()).then_some(Phase {
                row: *row,
                pose,
                moved_mm: moved
                    .map(|(&point, &rest)| (pose.back(point) - Vector3::from(rest)).into())
                    .collect(),
                twist_deg: values("twist_deg")?,
                pressure_pa: values("pressure_pa")?,
            })
        };
        let phases: Option<Vec<Phase>> = shapes.iter().map(phase).collect();
        let phases = phases.filter(|phases| !phases.is_empty())?;
        Some(Stroke {
            phases,
            solved: rows.len(),
        })
    }

    /// What of it is not shown.
    pub fn note(&self) -> Option<String> {
        let (shown, solved) = (self.phases.len(), self.solved);
        (shown < solved).then(|| {
            format!(
                "Of the {solved} phases of the stroke {shown} are shown, evenly among them: all would make the page too large."
            )
        })
    }

    /// As the viewer reads it: for each phase its row, the matrix of its pose by rows with the shift (mm) behind each, what
    /// the points moved (whole micrometres) and what they are coloured by.
    ///
    /// # Errors
    /// If a value is not finite.
    pub(super) fn json(&self) -> Result<String, ExportError> {
        let mut phases = Vec::new();
        for phase in &self.phases {
            let (turn, shift) = (phase.pose.turn, phase.pose.shift_mm);
            let pose: Vec<f64> = (0..3)
                .flat_map(|k| [turn[(k, 0)], turn[(k, 1)], turn[(k, 2)], shift[k]])
                .collect();
            let moved_mm = phase.moved_mm.as_flattened();
            for (name, values) in [
                ("twist", &phase.twist_deg[..]),
                ("pressure", &phase.pressure_pa),
                ("pose", &pose),
                ("moved", moved_mm),
            ] {
                finite(name, values)?;
            }
            let values = |values: &[f64]| joined(values, |value| significant(value, 4));
            phases.push(format!(
                "{{\"row\":{},\"pose\":[{}],\"moved\":[{}],\"twist\":[{}],\"pressure\":[{}]}}",
                phase.row,
                joined(&pose, |value| significant(value, 9)),
                micrometres(moved_mm),
                values(&phase.twist_deg),
                values(&phase.pressure_pa)
            ));
        }
        Ok(format!("[{}]", phases.join(",")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::vtu::Array;

    fn row(phase_deg: f64, sweep_deg: f64, pitch_deg: f64) -> PhaseRow {
        PhaseRow {
            phase_deg,
            tip_twist_deg: None,
            stop_moment_mn_mm: None,
            moving: Some(MovingRow {
                time_ms: 0.0,
                sweep_deg,
                pitch_deg,
                is_flipping: false,
                standing_tip_twist_deg: None,
            }),
            forces: None,
            file: String::new(),
        }
    }

    #[test]
    fn a_rigid_wing_has_moved_nowhere_in_the_frame_of_its_rod() {
        // pitched by 90 deg the chord lies along z; swept by 90 deg the span lies along -z; the second half is its mirror
        let rows = [row(0.0, 0.0, 90.0), row(180.0, 90.0, 0.0)];
        let rest_mm = [[10.0, 0.0, 0.0], [10.0, 5.0, 0.0]];
        let shape = |points_mm: [[f64; 3]; 2]| Grid {
            points_mm: points_mm.to_vec(),
            triangles: Vec::new(),
            lines: Vec::new(),
            point_arrays: vec![
                Array::scalar("twist_deg", vec![0.0, 0.0]),
                Array::scalar("pressure_pa", vec![0.0, 0.0]),
            ],
            cell_arrays: Vec::new(),
        };
        let shapes = [
            (0, shape([[12.0, 0.0, 0.0], [12.0, 0.0, 5.0]])),
            (1, shape([[0.0, 0.0, 12.0], [0.0, 5.0, 12.0]])),
        ];
        let stroke = Stroke::new(&rows, &shapes, &rest_mm, 2.0).expect("a stroke");
        for moved in stroke.phases.iter().flat_map(|phase| &phase.moved_mm) {
            assert!(Vector3::from(*moved).norm() < 1e-9, "{moved:?}");
        }
        let json: serde_json::Value = serde_json::from_str(&stroke.json().expect("JSON")).expect("JSON");
        assert_eq!(json[1]["row"], 1);
        assert_eq!(json[0]["pose"].as_array().map(Vec::len), Some(12));
    }

    #[test]
    fn of_a_fine_mesh_fewer_phases_are_shown() {
        let rows: Vec<PhaseRow> = (0..36)
            .map(|index| row(10.0 * f64::from(index), 0.0, 45.0))
            .collect();
        assert_eq!(Stroke::shown(&rows, 1000).count(), 36);
        assert_eq!(Stroke::shown(&rows, 3000).count(), 18);
    }
}
