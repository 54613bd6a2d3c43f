//! What a film or a plate is made of.

/// What a sheet is made of: isotropic, thin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    /// Young's modulus, Pa.
    pub e_pa: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Thickness, m.
    pub thickness_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Isotropic membrane force at zero strain, N/m.
    pub pretension_n_per_m: f64,
    /// How it answers to compression.
    pub compression: Compression,
}

/// How a sheet answers to compression in its plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Compression {
    /// It carries compression as tension: a plate, with the optimal triangle for its membrane action.
    ///
    /// Not for films in large rotation: the optimal triangle strains with the nodes' rotations about its normal, and
    /// where sides longer than some 100 thicknesses meet at an angle, a film's bending is too weak to hold those rotations.
    /// They then relieve the membrane: Hencky's membrane comes out 19, 18 and 13 % too soft with sides of 1250, 625 and
    /// 312 thicknesses, 4 and 0.7 % with 125 and 62. A film that carries compression is a tension field with
    /// `residual` = 1: the whole of the plane-stress law (1.4, 0.4 and 0.1 % on the same three meshes).
    Carries,
    /// It wrinkles: relaxed tension field on the constant-strain triangle.
    TensionField {
        /// Share of the stiffness kept in compression.
        residual: f64,
        /// Scale of the weak spring that holds rotations about the normal; 1 is usual.
        drilling_factor: f64,
        /// Strain, alike in all directions, by which the film is longer than its frame: it carries beyond that. What it
        /// keeps in compression does not know of it, so that the flat film is without force.
        slack: f64,
    },
}
