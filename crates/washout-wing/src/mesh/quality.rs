//! Shape of the film's elements.

use super::{Mesh, signed_area_m2};

/// Figures of a mesh. Angles of the film's triangles in the plane of the wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// Number of nodes.
    pub nodes: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of beam elements.
    pub beams: usize,
    /// Smallest angle of any triangle, deg; 60 without triangles.
    pub smallest_angle_deg: f64,
    /// The triangle that has it.
    pub worst_triangle: Option<usize>,
    /// Largest ratio of circumradius to twice the inradius; 1 for equilateral triangles.
    pub largest_aspect: f64,
    /// Area of the film, m².
    pub area_m2: f64,
}

impl Quality {
    /// The figures of a mesh.
    pub fn of(mesh: &Mesh) -> Quality {
        let mut quality = Quality {
            nodes: mesh.nodes.len(),
            triangles: mesh.triangles.len(),
            beams: mesh.beams.len(),
            smallest_angle_deg: 60.0,
            worst_triangle: None,
            largest_aspect: 1.0,
            area_m2: mesh.area_m2(),
        };
        for (index, triangle) in mesh.triangles.iter().enumerate() {
            let corners = triangle.map(|node| mesh.nodes[node]);
            let angle_deg = smallest_angle_rad(corners).to_degrees();
            if angle_deg < quality.smallest_angle_deg {
                quality.smallest_angle_deg = angle_deg;
                quality.worst_triangle = Some(index);
            }
            quality.largest_aspect = quality.largest_aspect.max(aspect(corners));
        }
        quality
    }
}

/// Smallest angle of a triangle in the x-y plane, rad; 0 or less if it is degenerate or clockwise.
pub fn smallest_angle_rad(corners: [[f64; 3]; 3]) -> f64 {
    let double_area = 2.0 * signed_area_m2(corners);
    (0..3)
        .map(|k| {
            let [o, p, q] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
            let dot = (p[0] - o[0]) * (q[0] - o[0]) + (p[1] - o[1]) * (q[1] - o[1]);
            double_area.atan2(dot)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Circumradius over twice the inradius: abc (a+b+c) / (16 A²).
fn aspect(corners: [[f64; 3]; 3]) -> f64 {
    let length = |a: [f64; 3], b: [f64; 3]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let [a, b, c] = [0, 1, 2].map(|k| length(corners[k], corners[(k + 1) % 3]));
    a * b * c * (a + b + c) / (16.0 * signed_area_m2(corners).powi(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_known_triangles() {
        let height = 0.75f64.sqrt();
        let equilateral = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, height, 0.0]];
        assert!((smallest_angle_rad(equilateral).to_degrees() - 60.0).abs() < 1e-12);
        assert!((aspect(equilateral) - 1.0).abs() < 1e-12);
        let right = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert!((smallest_angle_rad(right).to_degrees() - 45.0).abs() < 1e-12);
        assert!((aspect(right) - (1.0 + 2f64.sqrt()) / 2.0).abs() < 1e-12);
        let clockwise = [right[0], right[2], right[1]];
        assert!(smallest_angle_rad(clockwise) < 0.0);
    }
}
