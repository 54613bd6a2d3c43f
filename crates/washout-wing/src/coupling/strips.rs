//! Strips of air on the mesh: how they see the shape, and how their force reaches the nodes.
//!
//! Two strips stand over each element of the leading edge, each cut at a Gauss point of the element, so that a twist
//! that is linear between the nodes does its exact work on a load that is linear too: cut in the middle instead, eight
//! elements miss the divergence of a uniform wing by 0.64 %, so by 0.32 %. A strip's points are the crossings of its plane
//! with the film's edges, each a linear interpolation of two nodes. The same weights carry shape one way and force the
//! other, so force, moment and virtual work are kept for every shape.

use crate::mesh::{ChordLines, ChordPoint, Mesh};
use crate::structure::state::State;
use nalgebra::{SVector, Vector3};

/// What a strip sees of the shape: chord vector from leading to trailing edge (m) and leading-edge tangent (per rest
/// length), wing frame.
pub type StripShape = SVector<f64, 6>;

/// Places of the two Gauss points on an element from −1 to 1: ±1/√3.
const GAUSS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// Strips of a mesh, from base to tip.
#[derive(Debug, Clone, Default)]
pub struct Strips {
    /// The strips.
    pub strips: Vec<Strip>,
}

/// One strip.
#[derive(Debug, Clone)]
pub struct Strip {
    /// Span position of its plane at rest, m.
    pub r_m: f64,
    /// Width at rest, m: half the element's.
    pub width_m: f64,
    /// Chord at rest, m.
    pub chord_m: f64,
    /// Points from leading to trailing edge.
    pub points: Vec<ChordPoint>,
    /// Chord fraction of each point.
    pub eta: Vec<f64>,
    /// Nodes of the leading edge on either side.
    pub edge: [usize; 2],
    /// Chord vector and leading-edge tangent at rest.
    pub rest: StripShape,
}

impl Strips {
    /// Two strips over each element of the leading edge that meets the film.
    pub fn new(mesh: &Mesh) -> Self {
        if mesh.triangles.is_empty() {
            return Strips::default();
        }
        let lines = ChordLines::new(mesh);
        let strip = |pair: &[usize], place: f64| {
            let [a, b] = [pair[0], pair[1]].map(|node| Vector3::from(mesh.nodes[node]));
            let length_m = b.x - a.x;
            let r_m = 0.5 * (a.x + b.x) + 0.5 * place * length_m;
            let line = lines.at(r_m)?;
            let place = |p: &ChordPoint| {
                let [m, n] = p.nodes.map(|node| Vector3::from(mesh.nodes[node]));
                p.weights[0] * m + p.weights[1] * n
            };
            let (first, last) = (line.points.first()?, line.points.last()?);
            let chord = place(last) - place(first);
            let chord_m = last.y_m - first.y_m;
            let tangent = (b - a) / length_m;
            let eta = line
                .points
                .iter()
                .map(|p| (p.y_m - first.y_m) / chord_m)
                .collect();
            let rest =
                StripShape::from_column_slice(&[chord.x, chord.y, chord.z, tangent.x, tangent.y, tangent.z]);
            (length_m > 0.0 && chord_m > 0.0).then(|| Strip {
                r_m,
                width_m: 0.5 * length_m,
                chord_m,
                eta,
                points: line.points,
                edge: [pair[0], pair[1]],
                rest,
            })
        };
        Strips {
            strips: (mesh.leading_edge.windows(2))
                .flat_map(|pair| GAUSS.map(|place| strip(pair, place)))
                .flatten()
                .collect(),
        }
    }

    /// Span position of the outer end of the last strip, m; 0 without strips.
    pub fn tip_m(&self) -> f64 {
        // the last two strips share an element, at a ± h/√3 from its middle
        match self.strips.as_slice() {
            [.., inner, outer] => 0.5 * (inner.r_m + outer.r_m) + outer.width_m,
            [only] => only.r_m + 0.5 * only.width_m,
            [] => 0.0,
        }
    }

    /// Chord at rest at a span position, m; linear between strips, and beyond the ends that of the end.
    pub fn chord_m(&self, r_m: f64) -> f64 {
        let strips = &self.strips;
        let after = strips.partition_point(|strip| strip.r_m < r_m);
        let near = strips.get(after).or(strips.last());
        let before = strips.get(after.saturating_sub(1)).or(near);
        match (before, near) {
            (Some(a), Some(b)) if b.r_m > a.r_m => {
                let share = ((r_m - a.r_m) / (b.r_m - a.r_m)).clamp(0.0, 1.0);
                a.chord_m + share * (b.chord_m - a.chord_m)
            }
            (_, Some(only)) => only.chord_m,
            _ => 0.0,
        }
    }

    /// Shapes of all strips, six values each.
    pub fn shapes(&self, state: &State) -> Vec<f64> {
        self.strips
            .iter()
            .flat_map(|strip| strip.shape(&state.displacement).data.0[0])
            .collect()
    }

    /// Change of the shapes with a change of the displacements (the linear part of [`Strips::shapes`]).
    pub fn shape_changes(&self, displacement: &[Vector3<f64>]) -> Vec<f64> {
        self.strips
            .iter()
            .flat_map(|strip| strip.shape_change(displacement).data.0[0])
            .collect()
    }
}

impl Strip {
    /// Shape of the strip under nodal displacements, m.
    pub fn shape(&self, displacement: &[Vector3<f64>]) -> StripShape {
        self.rest + self.shape_change(displacement)
    }

    fn shape_change(&self, displacement: &[Vector3<f64>]) -> StripShape {
        let at = |p: &ChordPoint| {
            p.weights[0] * displacement[p.nodes[0]] + p.weights[1] * displacement[p.nodes[1]]
        };
        let chord = at(&self.points[self.points.len() - 1]) - at(&self.points[0]);
        let tangent = (displacement[self.edge[1]] - displacement[self.edge[0]]) / (2.0 * self.width_m);
        StripShape::from_column_slice(&[chord.x, chord.y, chord.z, tangent.x, tangent.y, tangent.z])
    }

    /// Hands the forces of the points to the nodes: `take(node, share of the point, point)`.
    pub fn spread(&self, mut take: impl FnMut(usize, f64, usize)) {
        for (index, point) in self.points.iter().enumerate() {
            for (node, weight) in point.nodes.into_iter().zip(point.weights) {
                if weight != 0.0 {
                    take(node, weight, index);
                }
            }
        }
    }
}
