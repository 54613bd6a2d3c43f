//! Nodes, elements and named sets of a wing; generator; Gmsh files.
//!
//! Frame of [`crate::geometry`]; metres.

pub mod bisect;

pub mod check;

pub mod chordline;

pub mod columns;

pub mod defect;

pub mod error;

pub mod generate;

pub mod gmsh;

pub mod import;

pub mod names;

pub mod quality;

mod ribs;

pub use chordline::{ChordLine, ChordLines, ChordPoint, chord_line};
pub use defect::Defect;
pub use error::MeshError;
pub use generate::generate;
pub use import::{MeshFile, for_design};
pub use quality::Quality;

/// A mesh of a wing at rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Positions of the nodes in the wing frame, m.
    pub nodes: Vec<[f64; 3]>,
    /// Triangles of the film, counter-clockwise seen from +z; of a wing of ribs, of the surface that the air meets.
    pub triangles: Vec<[usize; 3]>,
    /// Beam elements, each between two nodes, running outward (rod) or from leading to trailing edge (spars, ribs).
    pub beams: Vec<BeamElement>,
    /// Nodes on the root chord (x smallest), from leading to trailing edge.
    pub root: Vec<usize>,
    /// Nodes along the leading edge, from base to tip.
    pub leading_edge: Vec<usize>,
    /// Nodes along the trailing edge, from base to tip.
    pub trailing_edge: Vec<usize>,
}

/// A beam element of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BeamElement {
    /// Its two nodes.
    pub nodes: [usize; 2],
    /// What it belongs to.
    pub part: BeamPart,
}

/// The part of the design that a beam element belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BeamPart {
    /// Segment of the leading-edge rod, by its index in the design.
    Rod(usize),
    /// Spar, by its index in the design.
    Spar(usize),
    /// Stiff rib of a wing without film, counted from the base.
    Rib(usize),
}

impl Mesh {
    /// Nodes of the rod from base to its end, all its pieces; empty without a rod.
    pub fn rod_nodes(&self) -> Vec<usize> {
        self.beam_nodes(|part| matches!(part, BeamPart::Rod(_)))
    }

    /// Nodes of spar `index` (as in the design) from leading to trailing edge; empty if there is none.
    pub fn spar_nodes(&self, index: usize) -> Vec<usize> {
        self.beam_nodes(|part| part == BeamPart::Spar(index))
    }

    /// Number of spars: one more than the largest index that a beam element names.
    pub fn spar_count(&self) -> usize {
        let index = |beam: &BeamElement| match beam.part {
            BeamPart::Spar(index) => Some(index + 1),
            BeamPart::Rod(_) | BeamPart::Rib(_) => None,
        };
        self.beams.iter().filter_map(index).max().unwrap_or(0)
    }

    fn beam_nodes(&self, belongs: impl Fn(BeamPart) -> bool) -> Vec<usize> {
        let mut nodes = Vec::new();
        for beam in self.beams.iter().filter(|beam| belongs(beam.part)) {
            if nodes.is_empty() {
                nodes.push(beam.nodes[0]);
            }
            nodes.push(beam.nodes[1]);
        }
        nodes
    }

    /// Length of beam element `index`, m.
    pub fn beam_length_m(&self, index: usize) -> f64 {
        let [a, b] = self.beams[index].nodes.map(|node| self.nodes[node]);
        (b[0] - a[0]).hypot(b[1] - a[1]).hypot(b[2] - a[2])
    }

    /// Area of triangle `index`, m²; positive counter-clockwise seen from +z.
    pub fn triangle_area_m2(&self, index: usize) -> f64 {
        signed_area_m2(self.triangles[index].map(|node| self.nodes[node]))
    }

    /// Area of the film, m².
    pub fn area_m2(&self) -> f64 {
        (0..self.triangles.len())
            .map(|index| self.triangle_area_m2(index))
            .sum()
    }

    /// Smallest and largest coordinates of the nodes, m; zeros without nodes.
    pub fn bounds_m(&self) -> [[f64; 3]; 2] {
        let Some(&first) = self.nodes.first() else {
            return [[0.0; 3]; 2];
        };
        self.nodes.iter().fold([first, first], |[low, high], p| {
            [
                std::array::from_fn(|k| low[k].min(p[k])),
                std::array::from_fn(|k| high[k].max(p[k])),
            ]
        })
    }
}

/// Area of a triangle in the x-y plane, m²; positive counter-clockwise seen from +z.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// use washout::mesh::signed_area_m2;
///
/// let area = signed_area_m2([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
/// assert_eq!(area, 0.5);
/// ```
pub fn signed_area_m2([a, b, c]: [[f64; 3]; 3]) -> f64 {
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
}
