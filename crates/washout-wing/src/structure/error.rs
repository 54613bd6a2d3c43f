//! Why a structure cannot be built or solved.

/// Why a structure cannot be built or solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StructureError {
    /// A section stiffness is not symmetric and positive definite.
    #[error(
        "the stiffness of a section is not positive definite (smallest scaled eigenvalue {lowest:.3e}); \
         make the coupling terms smaller or the diagonal ones larger"
    )]
    SectionNotPositive {
        /// Smallest eigenvalue of the matrix scaled to a unit diagonal.
        lowest: f64,
    },
    /// A beam element has no length, or its normal runs along it.
    #[error("the beam element between nodes {} and {} has no length or no side", nodes[0], nodes[1])]
    DegenerateBeam {
        /// Its nodes.
        nodes: [usize; 2],
    },
    /// A triangle has no area.
    #[error("the triangle of nodes {}, {} and {} has no area", nodes[0], nodes[1], nodes[2])]
    DegenerateTriangle {
        /// Its nodes.
        nodes: [usize; 3],
    },
    /// A material that the design names gives no stiffness.
    #[error("material `{name}` is not in the design")]
    UnknownMaterial {
        /// Its name.
        name: String,
    },
    /// A mesh has a beam for a part that the design lacks.
    #[error(
        "the mesh has beam elements of {part}, which the design does not have; make the mesh from this design"
    )]
    UnknownPart {
        /// The part, in words.
        part: String,
    },
    /// A spar that the wing does not have is named.
    #[error("there is no spar {index}: the wing has {count}, counted from 0; name one of them")]
    NoSuchSpar {
        /// Its index.
        index: usize,
        /// Number of spars.
        count: usize,
    },
    /// The factorization met a matrix that it cannot factorize.
    #[error("the stiffness matrix is singular at node {node}; is a part of the wing without support?")]
    Singular {
        /// Node of the vanishing pivot.
        node: usize,
    },
    /// Newton's method found no equilibrium.
    #[error(
        "the structure found no equilibrium at {:.1} % of the load: relative residual {residual:.2e} after {steps} \
         Newton steps; try a finer mesh, a stiffer film or a smaller load", 100.0 * load_share
    )]
    NoEquilibrium {
        /// Share of the load at which it stopped.
        load_share: f64,
        /// Residual relative to the load there.
        residual: f64,
        /// Newton steps in all.
        steps: usize,
    },
    /// A number of it is not finite.
    #[error("{0}; correct the numbers of the design that it is made from")]
    NotFinite(#[from] NotFinite),
    /// The search for eigenvalues found none.
    #[error("the lowest mode was not found in {iterations} iterations")]
    NoMode {
        /// Iterations.
        iterations: usize,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] crate::progress::Cancelled),
}

/// A number that is not finite.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{quantity} {place} is {value}")]
pub struct NotFinite {
    /// What it is, with its unit.
    pub quantity: &'static str,
    /// Where it stands.
    pub place: String,
    /// The number.
    pub value: f64,
}
