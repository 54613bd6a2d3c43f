//! Nodes, elements and named sets of a wing; generator; Gmsh files.
//!
//! Frame of [`crate::geometry`]; metres.

/// A mesh of a wing at rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Positions of the nodes in the wing frame, m.
    pub nodes: Vec<[f64; 3]>,
    /// Membrane triangles, counter-clockwise seen from +z.
    pub triangles: Vec<[usize; 3]>,
    /// Beam elements, each between two nodes, running outward (rod) or from leading to trailing edge (spars).
    pub beams: Vec<BeamElement>,
    /// Nodes on the root chord (x smallest), from leading to trailing edge; the first is the rod's.
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
}
