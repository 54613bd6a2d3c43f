//! Leading and trailing edge of the deformed wing at a station.

use nalgebra::Vector3;

use crate::mesh::{ChordLines, ChordPoint, Mesh};
use crate::structure::state::State;

/// Leading- and trailing-edge point of one chord line, wing frame, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edges {
    /// Where the leading-edge point is.
    pub leading_m: Vector3<f64>,
    /// Where the trailing-edge point is.
    pub trailing_m: Vector3<f64>,
}

impl Edges {
    /// Chord vector from leading to trailing edge.
    pub fn chord(&self) -> Vector3<f64> {
        self.trailing_m - self.leading_m
    }
}

/// Edges at `r_m` in two shapes of the same mesh. None off the wing.
///
/// With a film, the ends of the chord line; without one, the point of the leading edge and a chord of `chord_m`
/// that turns with the section there.
pub fn edges_at<const N: usize>(
    mesh: &Mesh,
    lines: &ChordLines,
    shapes: [&State; N],
    r_m: f64,
    chord_m: f64,
) -> Option<[Edges; N]> {
    if mesh.triangles.is_empty() {
        return sections_at(mesh, shapes, r_m, chord_m);
    }
    let line = lines.at(r_m)?;
    let (first, last) = (line.points.first()?, line.points.last()?);
    Some(shapes.map(|shape| Edges {
        leading_m: place(mesh, shape, first),
        trailing_m: place(mesh, shape, last),
    }))
}

/// Edges of a chord of `chord_m` that turns with the leading edge at `r_m`: what a clamp or a bare rod does.
pub fn sections_at<const N: usize>(
    mesh: &Mesh,
    shapes: [&State; N],
    r_m: f64,
    chord_m: f64,
) -> Option<[Edges; N]> {
    let ([a, b], weights) = leading_edge_point(mesh, r_m)?;
    let point = ChordPoint {
        nodes: [a, b],
        weights,
        y_m: 0.0,
    };
    Some(shapes.map(|shape| {
        let turned = |node: usize| shape.rotation[node] * (Vector3::y() * chord_m);
        let leading_m = place(mesh, shape, &point);
        Edges {
            leading_m,
            trailing_m: leading_m + turned(a) * weights[0] + turned(b) * weights[1],
        }
    }))
}

/// The two leading-edge nodes around `r_m` and their weights; none off the leading edge.
pub fn leading_edge_point(mesh: &Mesh, r_m: f64) -> Option<([usize; 2], [f64; 2])> {
    let x = |node: usize| mesh.nodes[node][0];
    let pair = mesh
        .leading_edge
        .windows(2)
        .find(|pair| x(pair[0]) <= r_m && r_m <= x(pair[1]))?;
    let share = (r_m - x(pair[0])) / (x(pair[1]) - x(pair[0]));
    share
        .is_finite()
        .then_some(([pair[0], pair[1]], [1.0 - share, share]))
}

fn place(mesh: &Mesh, shape: &State, point: &ChordPoint) -> Vector3<f64> {
    let at = |node: usize| Vector3::from(mesh.nodes[node]) + shape.displacement[node];
    at(point.nodes[0]) * point.weights[0] + at(point.nodes[1]) * point.weights[1]
}
