//! What can be wrong with a Gmsh file, and the cure.

use crate::mesh::defect::Defect;

/// A mesh file that cannot be used: which file, which line, what.
#[derive(Debug, Clone, PartialEq)]
pub struct GmshError {
    /// Name of the file as the user gave it.
    pub file: String,
    /// Line, from 1, if one can be named.
    pub line: Option<usize>,
    /// What is wrong.
    pub defect: FileDefect,
}

impl std::fmt::Display for GmshError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: {}", self.file, self.defect),
            None => write!(f, "{}: {}", self.file, self.defect),
        }
    }
}

impl std::error::Error for GmshError {}

/// What is wrong with a mesh file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FileDefect {
    /// Nothing in it.
    #[error("the file is empty; write a mesh with `washout mesh`, or save one with Gmsh as MSH 4.1 text")]
    Empty,
    /// More than the reader takes.
    #[error("the file has {megabytes} MB; a mesh may have {largest_megabytes} MB: mesh it coarser")]
    Huge {
        /// Its size.
        megabytes: usize,
        /// The limit.
        largest_megabytes: usize,
    },
    /// Bytes that are no text.
    #[error("the file is binary; save it as text (gmsh: -bin off, or Mesh.Binary = 0)")]
    Binary,
    /// Not a Gmsh file.
    #[error("not a Gmsh file: it starts with `{start}` instead of $MeshFormat")]
    NotGmsh {
        /// Its first line.
        start: String,
    },
    /// A version that is neither 4.1 nor 2.2.
    #[error("MSH version `{version}`; this reads 4.1 and 2.2: save it again (gmsh: -format msh41)")]
    Version {
        /// What stands there.
        version: String,
    },
    /// A section that does not end.
    #[error(
        "the file ends inside {section}, which must close with {closing}; it was cut short: save it again"
    )]
    Truncated {
        /// The open section.
        section: String,
        /// Its last line.
        closing: String,
    },
    /// A section that is not there.
    #[error("the section {section} is missing; save the mesh with its physical groups as MSH 4.1")]
    MissingSection {
        /// The section.
        section: String,
    },
    /// A section that stands twice.
    #[error("the section {section} stands twice; keep one")]
    SectionTwice {
        /// The section.
        section: String,
    },
    /// A record with too few numbers.
    #[error("expected {expected}, found `{found}`")]
    Record {
        /// What should stand there.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// More or fewer records than announced.
    #[error("{section} should close here with {closing}, found `{found}`: the counts above it are wrong")]
    Count {
        /// The section.
        section: String,
        /// Its last line.
        closing: String,
        /// What stands there.
        found: String,
    },
    /// A name that is no set of a wing.
    #[error(
        "the set `{name}` is unknown; use rod-N, spar-N (N from 0), membrane, root, leading-edge, trailing-edge"
    )]
    UnknownSet {
        /// The name.
        name: String,
    },
    /// A set on entities of a wrong dimension.
    #[error("the set `{name}` has dimension {dimension}; {needed}")]
    SetDimension {
        /// The name.
        name: String,
        /// Its dimension in the file.
        dimension: usize,
        /// What it must be, in words.
        needed: &'static str,
    },
    /// A physical tag without a name.
    #[error("physical group {tag} (dimension {dimension}) has no name; name it in $PhysicalNames")]
    NamelessSet {
        /// The tag.
        tag: i64,
        /// Its dimension.
        dimension: usize,
    },
    /// A set that is not there.
    #[error("the set `{set}` is missing or empty; give its elements a physical group of that name")]
    MissingSet {
        /// The name.
        set: String,
    },
    /// Triangles outside of the set of the film.
    #[error(
        "the triangles of surface {entity} belong to no set; add the surface to the physical group `membrane`"
    )]
    SurfaceWithoutSet {
        /// Tag of the surface.
        entity: i64,
    },
    /// A tag that stands twice.
    #[error("node {tag} stands twice; node tags must differ (gmsh: Mesh.RenumberNodes)")]
    NodeTwice {
        /// The tag.
        tag: u64,
    },
    /// A coordinate that is not a finite number.
    #[error("the coordinate `{found}` is not a finite number")]
    Coordinate {
        /// What stands there.
        found: String,
    },
    /// An element with a node that is not in the file.
    #[error("element {element} names node {tag}, which does not exist")]
    UnknownNode {
        /// Tag of the element.
        element: u64,
        /// Tag of the node.
        tag: u64,
    },
    /// An element of another kind.
    #[error(
        "element type {kind} ({name}); a wing has points (15), 2-node lines (1) and 3-node triangles (2): \
         mesh with first-order triangles, without recombination"
    )]
    ElementType {
        /// Gmsh's number.
        kind: u64,
        /// Its name, where known.
        name: &'static str,
    },
    /// A rod piece or spar that is no simple chain.
    #[error("`{set}` is not one line from end to end: it {problem}")]
    NotAChain {
        /// The set.
        set: String,
        /// How it fails.
        problem: &'static str,
    },
    /// The mesh as a whole.
    #[error(transparent)]
    Mesh(#[from] Defect),
}
