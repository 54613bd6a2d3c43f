//! What can be wrong with a mesh, and the cure.

use super::BeamPart;
use super::defect::Defect;
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
    File(Box<GmshError>),
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
    /// More nodes than a machine holds.
    #[error(
        "mesh: chordwise = {chordwise} with refine = {refine} makes about {nodes:.1e} nodes of so slender a wing; at most {largest:.1e} are \
         laid out: take fewer elements across the chord"
    )]
    TooMany {
        /// About how many it would be.
        nodes: f64,
        /// Largest number that is allowed.
        largest: f64,
        /// `mesh.chordwise`.
        chordwise: usize,
        /// `mesh.refine`.
        refine: f64,
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
    /// A number of bays that gives no mesh, or one beyond any use.
    #[error("ribs: bays = {bays} with mesh.refine = {refine}: keep their product between 1 and {largest}")]
    Bays {
        /// `ribs.bays`.
        bays: usize,
        /// `mesh.refine`.
        refine: f64,
        /// Largest product that is allowed.
        largest: usize,
    },
    /// Ribs outboard of the end of the rod.
    #[error(
        "ribs: the rod ends at {rod_end_mm} mm, the wing at {tip_mm} mm, and ribs outboard of the rod hang on nothing; \
         let the last [[rod]] end at {tip_mm}"
    )]
    LooseRibs {
        /// Where the rod ends.
        rod_end_mm: f64,
        /// Where the wing is cut.
        tip_mm: f64,
    },
    /// A mesh file for a wing of ribs.
    #[error("{file}: a wing of ribs is meshed by the program, not from a file; delete mesh.file, or [ribs]")]
    RibsFromFile {
        /// Mesh file.
        file: String,
    },
    /// The film stands in the mesh or in the design only.
    #[error(
        "{file}: {}; {cure}",
        if *.in_mesh { "the mesh has a membrane, but the design has no [film]" }
        else { "the design has a [film], but the mesh has no set `membrane`" }
    )]
    FilmMismatch {
        /// The mesh file.
        file: String,
        /// Whether it is the mesh that has it.
        in_mesh: bool,
        /// What to do.
        cure: &'static str,
    },
    /// Another number of rod pieces or spars.
    #[error("{file}: the mesh has {in_mesh} {part}, the design {in_design}; mesh this design again")]
    PartCount {
        /// The mesh file.
        file: String,
        /// "rod pieces" or "spars".
        part: &'static str,
        /// Number in the mesh.
        in_mesh: usize,
        /// Number in the design, on the wing as built.
        in_design: usize,
    },
    /// A rod piece or spar that ends elsewhere.
    #[error(
        "{file}: {part} {end} at {in_mesh_mm:.3} mm in the mesh, at {in_design_mm:.3} mm in the design; mesh this design again, or change the design"
    )]
    PartPlace {
        /// The mesh file.
        file: String,
        /// The part.
        part: BeamPart,
        /// Which end, in words.
        end: &'static str,
        /// Place in the mesh.
        in_mesh_mm: f64,
        /// Place in the design.
        in_design_mm: f64,
    },
    /// Another outline.
    #[error(
        "{file}: the chord at r = {at_mm:.3} mm is {in_mesh_mm:.3} mm in the mesh, {in_design_mm:.3} mm in the design; \
         mesh this design again, or take mean_chord_mm, r1_hat, r2_hat and outline out of [planform] to have the \
         outline from the mesh"
    )]
    Outline {
        /// The mesh file.
        file: String,
        /// Span position.
        at_mm: f64,
        /// Chord of the mesh there.
        in_mesh_mm: f64,
        /// Chord of the design there.
        in_design_mm: f64,
    },
    /// A span that cannot be that of the design.
    #[error(
        "{file}: the mesh ends at r = {in_mesh_mm:.3} mm, the design at {in_design_mm:.3} mm; mesh files are in metres \
         (gmsh: Mesh.ScalingFactor = 0.001 if it was drawn in mm)"
    )]
    Span {
        /// The mesh file.
        file: String,
        /// End of the mesh.
        in_mesh_mm: f64,
        /// End of the wing in the design.
        in_design_mm: f64,
    },
}

impl From<GmshError> for MeshError {
    fn from(error: GmshError) -> Self {
        MeshError::File(Box::new(error))
    }
}
