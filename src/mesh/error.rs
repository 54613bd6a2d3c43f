//! What can be wrong with a mesh, and the cure.

use super::check::Defect;
use super::gmsh::GmshError;
use crate::geometry::GeometryError;

/// No mesh. Lengths in mm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The design's geometry is impossible.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// The mesh is not sound.
    #[error("mesh: {0}")]
    Defect(#[from] Defect),
    /// The mesh file cannot be used.
    #[error(transparent)]
    File(#[from] GmshError),
    /// A density that gives no mesh, or one beyond any memory.
    #[error(
        "mesh: chordwise = {chordwise} with refine = {refine} gives {elements} elements across the chord; \
         keep it between 2 and {largest}"
    )]
    Density {
        /// `mesh.chordwise`.
        chordwise: usize,
        /// `mesh.refine`.
        refine: f64,
        /// Their product.
        elements: f64,
        /// Largest product that is allowed.
        largest: usize,
    },
    /// Mesh lines of a bay cross: the outline bends too strongly for so oblique a spar.
    #[error(
        "mesh: elements fold over near r = {at_mm:.2} mm; the spars there are too oblique for the outline: \
         turn them toward the chord, or put a spar between"
    )]
    Folded {
        /// Span position of a folded element.
        at_mm: f64,
    },
    /// Without a film a spar hangs on nothing where the rod has ended.
    #[error(
        "spar[{index}] stands at {at_mm} mm, but the rod ends at {rod_end_mm} mm and there is no film to hold it; \
         lengthen the rod, move the spar, or add [film]"
    )]
    LooseSpar {
        /// Index of the spar.
        index: usize,
        /// Its place at the leading edge.
        at_mm: f64,
        /// Where the rod ends.
        rod_end_mm: f64,
    },
}
