//! What can be wrong with a mesh as a whole, and the cure.

use super::BeamPart;

/// What is wrong with a mesh. Places in mm, wing frame.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Defect {
    /// An element or set names a node that does not exist.
    #[error("{by} names a node that does not exist")]
    MissingNode {
        /// Which list holds the wrong index.
        by: Member,
    },
    /// A coordinate that is not a finite number.
    #[error("a coordinate of the node is not a finite number")]
    NotFinite {
        /// The node.
        node: usize,
    },
    /// A node out of the plane of the wing.
    #[error(
        "node at ({x_mm:.4}, {y_mm:.4}) mm lies {z_mm:.6} mm off the plane z = 0; the wing at rest is flat: project it"
    )]
    OffPlane {
        /// The node.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
        /// Distance from the plane.
        z_mm: f64,
    },
    /// Two nodes in one place.
    #[error(
        "two nodes stand at ({x_mm:.4}, {y_mm:.4}) mm, so the parts there are not joined; merge them (gmsh: Coherence Mesh)"
    )]
    SamePlace {
        /// The later of the two.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// A triangle without area.
    #[error("triangle at ({x_mm:.4}, {y_mm:.4}) mm has no area; remove it or move its nodes apart")]
    NoArea {
        /// The triangle.
        triangle: usize,
        /// Its centre along the span.
        x_mm: f64,
        /// Its centre along the chord.
        y_mm: f64,
    },
    /// A triangle that is numbered clockwise.
    #[error("triangle at ({x_mm:.4}, {y_mm:.4}) mm is clockwise seen from +z; swap two of its nodes")]
    Clockwise {
        /// The triangle.
        triangle: usize,
        /// Its centre along the span.
        x_mm: f64,
        /// Its centre along the chord.
        y_mm: f64,
    },
    /// Two triangles on the same side of an edge.
    #[error(
        "triangle at ({x_mm:.4}, {y_mm:.4}) mm is inverted: it lies over its neighbour, or stands there twice; \
         move its nodes back, or remove it"
    )]
    Inverted {
        /// The triangle.
        triangle: usize,
        /// Its centre along the span.
        x_mm: f64,
        /// Its centre along the chord.
        y_mm: f64,
    },
    /// A node on an edge that does not know it.
    #[error(
        "node at ({x_mm:.4}, {y_mm:.4}) mm lies on an edge of a triangle that it does not belong to: \
         the film is torn there; split that triangle"
    )]
    Hanging {
        /// The node.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// A beam element across triangles.
    #[error(
        "{part} element at ({x_mm:.4}, {y_mm:.4}) mm does not follow an edge of the film's triangles; \
         embed the line in the surface before meshing (gmsh: Curve{{…}} In Surface{{…}})"
    )]
    OffEdges {
        /// The beam element.
        beam: usize,
        /// What it belongs to.
        part: BeamPart,
        /// Its middle along the span.
        x_mm: f64,
        /// Its middle along the chord.
        y_mm: f64,
    },
    /// A node that no element uses.
    #[error("node at ({x_mm:.4}, {y_mm:.4}) mm belongs to no element; remove it")]
    Loose {
        /// The node.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// A part of the wing that hangs on nothing.
    #[error(
        "the elements at ({x_mm:.4}, {y_mm:.4}) mm are not connected with the rod; join them or remove them"
    )]
    Unconnected {
        /// One of its nodes.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// A named set without members.
    #[error("the set `{set}` is missing or empty; give its lines that physical name")]
    MissingSet {
        /// Name of the set.
        set: &'static str,
    },
    /// The rod starts at a wrong place or is interrupted.
    #[error(
        "rod element at x = {x_mm:.4} mm does not continue the rod: its pieces must join from the root outward, along the leading edge"
    )]
    BrokenRod {
        /// The beam element.
        beam: usize,
        /// Where it starts.
        x_mm: f64,
    },
    /// A spar that is interrupted.
    #[error(
        "{part} is interrupted at ({x_mm:.4}, {y_mm:.4}) mm; it must run in one piece from leading to trailing edge"
    )]
    BrokenSpar {
        /// The beam element that does not continue it.
        beam: usize,
        /// The spar.
        part: BeamPart,
        /// Where it starts, along the span.
        x_mm: f64,
        /// Where it starts, along the chord.
        y_mm: f64,
    },
    /// A spar that does not end on an edge.
    #[error("{part} ends at ({x_mm:.4}, {y_mm:.4}) mm, which is not on the {edge} edge; lengthen it")]
    ShortSpar {
        /// The beam element at that end.
        beam: usize,
        /// The spar.
        part: BeamPart,
        /// "leading" or "trailing".
        edge: &'static str,
        /// Where it ends, along the span.
        x_mm: f64,
        /// Where it ends, along the chord.
        y_mm: f64,
    },
    /// The leading edge is not on y = 0.
    #[error(
        "node at ({x_mm:.4}, {y_mm:.4}) mm belongs to the leading edge, which must lie on y = 0; shift or turn the mesh"
    )]
    LeadingEdgeOff {
        /// The node.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// The base is not at x = 0.
    #[error("the root node at ({x_mm:.4}, {y_mm:.4}) mm must lie on x = 0; shift the mesh along x")]
    RootOff {
        /// The node.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// A set that leaves out nodes, or goes round a corner.
    #[error(
        "the set `{set}` is interrupted at ({x_mm:.4}, {y_mm:.4}) mm; its lines must follow the film's edge without a \
         gap, and not go round a corner (the tip belongs to no set)"
    )]
    Interrupted {
        /// Name of the set.
        set: &'static str,
        /// The node after the gap.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// The root does not join the two edges.
    #[error(
        "the root ends at ({x_mm:.4}, {y_mm:.4}) mm, which is not the first node of the {edge} edge; \
         it must run from the one to the other"
    )]
    RootCorner {
        /// The end of the root.
        node: usize,
        /// "leading" or "trailing".
        edge: &'static str,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
    /// A set that runs backward.
    #[error(
        "the set `{set}` is not in order at ({x_mm:.4}, {y_mm:.4}) mm; it must run outward, the root from leading to trailing edge"
    )]
    Disorder {
        /// Name of the set.
        set: &'static str,
        /// The node that should have come earlier.
        node: usize,
        /// Place along the span.
        x_mm: f64,
        /// Place along the chord.
        y_mm: f64,
    },
}

/// A member of a mesh, by its index in the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Member {
    /// A node.
    Node(usize),
    /// A triangle.
    Triangle(usize),
    /// A beam element.
    Beam(usize),
    /// One of the sets, by name.
    Set(&'static str),
}

impl std::fmt::Display for Member {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Member::Node(index) => write!(f, "node {index}"),
            Member::Triangle(index) => write!(f, "triangle {index}"),
            Member::Beam(index) => write!(f, "beam element {index}"),
            Member::Set(name) => write!(f, "the set `{name}`"),
        }
    }
}

impl Defect {
    /// The member of the mesh that is at fault.
    pub fn member(&self) -> Member {
        match *self {
            Defect::MissingNode { by } => by,
            Defect::NotFinite { node }
            | Defect::OffPlane { node, .. }
            | Defect::SamePlace { node, .. }
            | Defect::Hanging { node, .. }
            | Defect::Loose { node, .. }
            | Defect::Unconnected { node, .. }
            | Defect::LeadingEdgeOff { node, .. }
            | Defect::RootOff { node, .. }
            | Defect::Interrupted { node, .. }
            | Defect::RootCorner { node, .. }
            | Defect::Disorder { node, .. } => Member::Node(node),
            Defect::NoArea { triangle, .. }
            | Defect::Clockwise { triangle, .. }
            | Defect::Inverted { triangle, .. } => Member::Triangle(triangle),
            Defect::OffEdges { beam, .. }
            | Defect::BrokenRod { beam, .. }
            | Defect::BrokenSpar { beam, .. }
            | Defect::ShortSpar { beam, .. } => Member::Beam(beam),
            Defect::MissingSet { set } => Member::Set(set),
        }
    }
}
