//! What an effect sees and may change at each seam.

use num_dual::DualSVec64;

use crate::aero::Flow;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::structure::Model;

/// Numbers of the air's seam: with derivatives by the six numbers of a strip's shape.
pub type Dual = DualSVec64<6>;

/// The structure of a wing, to be changed.
#[derive(Debug)]
pub struct Structure<'a> {
    /// The design.
    pub design: &'a Design,
    /// The mesh; `model.beams[i]` is `mesh.beams[i]`, `model.shells[i]` is `mesh.triangles[i]`.
    pub mesh: &'a Mesh,
    /// The structure.
    pub model: &'a mut Model,
}

/// Where a strip stands, and in which flow.
#[derive(Debug, Clone, Copy)]
pub struct StripPlace<'a> {
    /// The design.
    pub design: &'a Design,
    /// The flow; none on a bench.
    pub flow: Option<&'a Flow>,
    /// Span position, m.
    pub r_m: f64,
    /// Span position of the last strip's outer end, m.
    pub tip_m: f64,
    /// Chord at rest, m.
    pub chord_m: f64,
    /// Mean chord at rest, m.
    pub mean_chord_m: f64,
    /// Density of the air, kg/m³; 0 on a bench.
    pub density_kg_m3: f64,
    /// Angle of attack of the untwisted wing, rad; 0 on a bench.
    pub root_angle_rad: f64,
}
