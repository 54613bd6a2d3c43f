//! Where the leading edge goes: deflection across the wing plane and sweep in it.

use nalgebra::Vector3;

use crate::coupling::solution::Solution;
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh::{ChordLines, ChordPoint};

use super::edges::{Edges, leading_edge_point, sections_at};
use super::station::stations;

/// The leading edge at one station, against the unloaded shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeadingEdgeReading {
    /// Distance from the wing base at rest, m.
    pub r_m: f64,
    /// Displacement along +z, m.
    pub deflection_m: f64,
    /// Displacement toward the trailing edge (+y), m.
    pub sweep_m: f64,
    /// Slope out of the wing plane of the element that holds the station, rad, positive along +z.
    pub slope_rad: f64,
    /// Sweep angle of that element in the wing plane, rad, positive aft.
    pub sweep_rad: f64,
}

/// The leading edge at the stations of the design; stations off the leading edge are left out.
pub fn read_leading_edge(
    design: &Design,
    planform: &Planform,
    solution: &Solution,
) -> Vec<LeadingEdgeReading> {
    let places = stations(design, planform);
    places
        .iter()
        .filter_map(|station| leading_edge_at(solution, station.r_m))
        .collect()
}

/// The leading edge at `r_m`; none off it.
pub fn leading_edge_at(solution: &Solution, r_m: f64) -> Option<LeadingEdgeReading> {
    let ([a, b], weights) = leading_edge_point(&solution.mesh, r_m)?;
    let moved = |node: usize| -> Option<Vector3<f64>> {
        Some(solution.state.displacement.get(node)? - solution.rest.displacement.get(node)?)
    };
    let place = |node: usize| Vector3::from(solution.mesh.nodes[node]);
    let displacement = moved(a)? * weights[0] + moved(b)? * weights[1];
    let tangent = place(b) + moved(b)? - place(a) - moved(a)?;
    let unloaded = place(b) - place(a);
    Some(LeadingEdgeReading {
        r_m,
        deflection_m: displacement.z,
        sweep_m: displacement.y,
        slope_rad: tangent.z.atan2(tangent.x) - unloaded.z.atan2(unloaded.x),
        sweep_rad: tangent.y.atan2(tangent.x) - unloaded.y.atan2(unloaded.x),
    })
}

/// Displacement (m, wing frame) from the unloaded shape of the point at `chord_fraction` at `r_m`; none off the wing.
///
/// With a film, or ribs, the point lies on the chord line of the mesh; on a bare rod it turns with the section.
pub fn displacement_at(
    solution: &Solution,
    lines: &ChordLines,
    r_m: f64,
    chord_fraction: f64,
    chord_m: f64,
) -> Option<Vector3<f64>> {
    let Solution {
        mesh, rest, state, ..
    } = solution;
    if mesh.triangles.is_empty() {
        let [unloaded, loaded] = sections_at(mesh, [rest, state], r_m, chord_m)?;
        let at = |edges: &Edges| edges.leading_m + edges.chord() * chord_fraction;
        return Some(at(&loaded) - at(&unloaded));
    }
    let moved = |point: &ChordPoint| {
        let of = |node: usize| state.displacement[node] - rest.displacement[node];
        of(point.nodes[0]) * point.weights[0] + of(point.nodes[1]) * point.weights[1]
    };
    let line = lines.at(r_m)?;
    let (first, last) = (line.points.first()?, line.points.last()?);
    let y_m = first.y_m + chord_fraction * (last.y_m - first.y_m);
    let behind = line.points.partition_point(|point| point.y_m < y_m);
    let (a, b) = (
        &line.points[behind.saturating_sub(1)],
        &line.points[behind.min(line.points.len() - 1)],
    );
    let gap_m = b.y_m - a.y_m;
    let share = if gap_m > 0.0 { (y_m - a.y_m) / gap_m } else { 0.0 };
    Some(moved(a) * (1.0 - share) + moved(b) * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observation::imposed::{design, wing};

    #[test]
    fn a_parabola_is_read_with_its_slope_and_sweep() {
        let design = design("");
        let (planform, solution) = wing(&design, |_| 0.3, |r_m| [r_m * r_m, 4.0 * r_m * r_m]);
        let readings = read_leading_edge(&design, &planform, &solution);
        assert_eq!(readings.len(), 7);
        for reading in &readings {
            let r_m = reading.r_m;
            assert!(
                (reading.deflection_m - 4.0 * r_m * r_m).abs() < 1e-5,
                "{reading:?}"
            );
            assert!((reading.sweep_m - r_m * r_m).abs() < 1e-5, "{reading:?}");
            // The slope is that of the element, so it is off by at most half an element's length times z''.
            assert!((reading.slope_rad.tan() - 8.0 * r_m).abs() < 0.02, "{reading:?}");
            assert!((reading.sweep_rad.tan() - 2.0 * r_m).abs() < 0.01, "{reading:?}");
        }
        assert_eq!(leading_edge_at(&solution, 0.0699), None);
    }
}
