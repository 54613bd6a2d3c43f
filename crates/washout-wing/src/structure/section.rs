//! Stiffness of a beam's cross-section: 6×6 from shape and material, from plies, or as given.
//!
//! Order of strains and forces: axial, shear edge (in the wing plane), shear flap (across it), twist,
//! bending flap (out of the plane), bending edge (in it). Beam axes: e₁ along the beam, e₃ along the normal of the
//! wing, e₂ = e₃ × e₁; so "edge" is along e₂ and flap bending turns about e₂.

use nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector3};

use super::StructureError;
use super::skin::Skin;

/// Elastic and inertial properties of a section about its reference axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Strains per force: 1/N, 1/(N·m), 1/(N·m²); a zero row of a shear strain means rigid in that shear.
    pub compliance: Matrix6<f64>,
    /// Mass per length, kg/m.
    pub mass_kg_m: f64,
    /// Moments of inertia per length about e₁, e₂, e₃, kg·m.
    pub inertia_kg_m: Vector3<f64>,
    /// Points at which stress is read: (e₂, e₃) from the axis, m; empty for given stiffnesses.
    pub fibres: Vec<Fibre>,
    /// Torsional shear stress at the surface per unit twist rate, Pa·m.
    pub shear_per_twist_rate_pa_m: f64,
    /// A skin beside it, if any.
    pub skin: Option<Skin>,
}

/// A fibre at which axial stress is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fibre {
    /// Place across the section along e₂, m.
    pub edge_m: f64,
    /// Place along e₃, m.
    pub flap_m: f64,
    /// Modulus along the beam there, Pa.
    pub modulus_pa: f64,
}

/// Elastic constants along a beam, Pa and kg/m³.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamMaterial {
    /// Young's modulus along the beam, Pa.
    pub e_pa: f64,
    /// Shear modulus, Pa.
    pub g_pa: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// A ply of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlyStiffness {
    /// Thickness, m.
    pub thickness_m: f64,
    /// Plane-stress stiffness in the strip's axes (x along, y across), Pa.
    pub q_pa: Matrix3<f64>,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

impl Section {
    /// From a full stiffness matrix, order as in the module's head.
    ///
    /// # Errors
    /// If it is not symmetric and positive definite.
    pub fn from_stiffness(stiffness: &Matrix6<f64>, mass_kg_m: f64) -> Result<Self, StructureError> {
        let scale = Matrix6::from_diagonal(
            &stiffness
                .diagonal()
                .map(|d| if d > 0.0 { 1.0 / d.sqrt() } else { 1.0 }),
        );
        let scaled = scale * stiffness * scale;
        if !scaled.iter().all(|part| part.is_finite()) {
            return Err(StructureError::SectionNotPositive { lowest: f64::NAN });
        }
        let lowest = SymmetricEigen::new(scaled).eigenvalues.min();
        let inverse = stiffness.try_inverse().filter(|_| lowest > 1e-12);
        let compliance = inverse.ok_or(StructureError::SectionNotPositive { lowest })?;
        Ok(Section {
            compliance: 0.5 * (compliance + compliance.transpose()),
            mass_kg_m,
            inertia_kg_m: Vector3::zeros(),
            fibres: Vec::new(),
            shear_per_twist_rate_pa_m: 0.0,
            skin: None,
        })
    }

    /// From uncoupled stiffnesses EA (N), GJ, EI flap, EI edge (N·m²); rigid in shear.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::structure::Section;
    ///
    /// let section = Section::uncoupled(1e5, 0.02, 0.05, 0.05);
    /// assert!((section.gj_n_m2() - 0.02).abs() < 1e-15);
    /// ```
    pub fn uncoupled(ea_n: f64, gj_n_m2: f64, ei_flap_n_m2: f64, ei_edge_n_m2: f64) -> Self {
        let mut compliance = Matrix6::<f64>::zeros();
        for (i, k) in [(0, ea_n), (3, gj_n_m2), (4, ei_flap_n_m2), (5, ei_edge_n_m2)] {
            compliance[(i, i)] = 1.0 / k;
        }
        Section {
            compliance,
            mass_kg_m: 0.0,
            inertia_kg_m: Vector3::zeros(),
            fibres: Vec::new(),
            shear_per_twist_rate_pa_m: 0.0,
            skin: None,
        }
    }

    /// Solid circle of the given radius (m). J = π a⁴/2, I = π a⁴/4, shear factor 0.9 (Cowper 1966, ν ≈ 0.3: 0.89).
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use std::f64::consts::PI;
    /// use washout::structure::{Section, section::BeamMaterial};
    ///
    /// let carbon = BeamMaterial { e_pa: 130e9, g_pa: 5e9, density_kg_m3: 1600.0 };
    /// let rod = Section::round(0.5e-3, &carbon);
    /// assert!((rod.gj_n_m2() / (5e9 * PI / 2.0 * 0.5e-3_f64.powi(4)) - 1.0).abs() < 1e-12);
    /// ```
    pub fn round(radius_m: f64, material: &BeamMaterial) -> Self {
        Section::tube(radius_m, 0.0, material)
    }

    /// Circular tube, outer and inner radius (m).
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::structure::{Section, section::BeamMaterial};
    ///
    /// let carbon = BeamMaterial { e_pa: 130e9, g_pa: 5e9, density_kg_m3: 1600.0 };
    /// let (rod, tube) = (Section::round(1e-3, &carbon), Section::tube(1e-3, 0.5e-3, &carbon));
    /// assert!((tube.ei_flap_n_m2() / rod.ei_flap_n_m2() - (1.0 - 0.5_f64.powi(4))).abs() < 1e-12);
    /// ```
    pub fn tube(outer_m: f64, inner_m: f64, material: &BeamMaterial) -> Self {
        let pi = std::f64::consts::PI;
        let fourth = outer_m.powi(4) - inner_m.powi(4);
        let area = pi * (outer_m.powi(2) - inner_m.powi(2));
        let i = pi / 4.0 * fourth;
        let shear_factor = if inner_m > 0.0 { 0.5 } else { 0.9 };
        // close enough that the largest bending stress in any direction is met within 0.5 %
        let rim: [(f64, f64); 32] = std::array::from_fn(|k| (pi / 16.0 * k as f64).sin_cos());
        homogeneous(material, area, [i, i], 2.0 * i, shear_factor, outer_m)
            .with_fibres(material, rim.map(|(y, z)| (y * outer_m, z * outer_m)))
    }

    /// Half of a circle of radius a (m), reference axis through the centroid; shear centre 8a/(5π) from the flat (ν = 0).
    ///
    /// J = (π/2 − 4/π) a⁴; I parallel to the flat (π/8 − 8/(9π)) a⁴; I across π/8 a⁴ (closed forms).
    /// `flat_in_plane`: flat in the plane of the wing, so the flapwise I is the one parallel to the flat.
    pub fn half_round(radius_m: f64, flat_in_plane: bool, material: &BeamMaterial) -> Self {
        let pi = std::f64::consts::PI;
        let a4 = radius_m.powi(4);
        let j = (pi / 2.0 - 4.0 / pi) * a4;
        let parallel = (pi / 8.0 - 8.0 / (9.0 * pi)) * a4;
        let across = pi / 8.0 * a4;
        let centroid = 4.0 / (3.0 * pi) * radius_m;
        // from corner to corner along the round side
        let places: [(f64, f64); 17] = std::array::from_fn(|k| {
            let (sine, cosine) = (pi / 16.0 * k as f64).sin_cos();
            (radius_m * cosine, radius_m * sine - centroid)
        });
        let (bending, fibres) = if flat_in_plane {
            ([parallel, across], places)
        } else {
            ([across, parallel], places.map(|(y, z)| (z, y)))
        };
        // Largest shear of a half-round in torsion: T / (0.35 a³) at the middle of the flat (Roark, table 10.7)
        let mut section = homogeneous(
            material,
            pi / 2.0 * radius_m.powi(2),
            bending,
            j,
            0.85,
            0.29756 / 0.35 * radius_m,
        )
        .with_fibres(material, fibres);
        // The shear centre lies off the centroid on the round side: a transverse force through the centroid twists.
        let offset = (8.0 / (5.0 * pi) - 4.0 / (3.0 * pi)) * radius_m;
        let (shear, lever) = if flat_in_plane { (1, offset) } else { (2, -offset) };
        let twist = section.compliance[(3, 3)];
        section.compliance[(shear, 3)] = lever * twist;
        section.compliance[(3, shear)] = lever * twist;
        section.compliance[(shear, shear)] += lever * lever * twist;
        section
    }

    /// Solid rectangle: width along e₂, thickness along e₃ (m). J by the exact series.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// use washout::structure::{Section, section::BeamMaterial};
    ///
    /// let steel = BeamMaterial { e_pa: 200e9, g_pa: 80e9, density_kg_m3: 7800.0 };
    /// let strip = Section::rectangle(10e-3, 1e-3, &steel);
    /// assert!((strip.ei_edge_n_m2() / strip.ei_flap_n_m2() - 100.0).abs() < 1e-9);
    /// ```
    pub fn rectangle(width_m: f64, thickness_m: f64, material: &BeamMaterial) -> Self {
        let area = width_m * thickness_m;
        let flap = width_m * thickness_m.powi(3) / 12.0;
        let edge = thickness_m * width_m.powi(3) / 12.0;
        let (long, short) = (width_m.max(thickness_m), width_m.min(thickness_m));
        let j = rectangle_torsion_factor(long / short) * long * short.powi(3);
        let (y, z) = (width_m / 2.0, thickness_m / 2.0);
        homogeneous(material, area, [flap, edge], j, 5.0 / 6.0, short)
            .with_fibres(material, [(y, z), (-y, z), (y, -z), (-y, -z)])
    }

    /// The section with its flapwise bending and its torsional stiffness multiplied, couplings by the square roots, so
    /// that it stays positive definite.
    #[must_use]
    pub fn with_factors(mut self, bending_flap: f64, torsion: f64) -> Self {
        if bending_flap == 1.0 && torsion == 1.0 {
            return self;
        }
        for (strain, factor) in [(4, bending_flap), (3, torsion)] {
            let root = factor.sqrt();
            for other in 0..6 {
                self.compliance[(strain, other)] /= root;
                self.compliance[(other, strain)] /= root;
            }
        }
        self
    }

    /// Axial stiffness with free bending and twist, N.
    pub fn axial_stiffness_n(&self) -> f64 {
        1.0 / self.compliance[(0, 0)]
    }

    /// Torsional stiffness with free bending, N·m².
    pub fn gj_n_m2(&self) -> f64 {
        1.0 / self.compliance[(3, 3)]
    }

    /// Flapwise bending stiffness with free twist, N·m².
    pub fn ei_flap_n_m2(&self) -> f64 {
        1.0 / self.compliance[(4, 4)]
    }

    /// Edgewise bending stiffness, N·m².
    pub fn ei_edge_n_m2(&self) -> f64 {
        1.0 / self.compliance[(5, 5)]
    }

    fn with_fibres<const K: usize>(mut self, material: &BeamMaterial, places: [(f64, f64); K]) -> Self {
        let fibre = |(edge_m, flap_m)| Fibre {
            edge_m,
            flap_m,
            modulus_pa: material.e_pa,
        };
        self.fibres = places.into_iter().map(fibre).collect();
        self
    }
}

fn homogeneous(
    material: &BeamMaterial,
    area: f64,
    [flap, edge]: [f64; 2],
    j: f64,
    shear_factor: f64,
    shear_radius_m: f64,
) -> Section {
    let (e, g) = (material.e_pa, material.g_pa);
    let mut section = Section::uncoupled(e * area, g * j, e * flap, e * edge);
    section.compliance[(1, 1)] = 1.0 / (shear_factor * g * area);
    section.compliance[(2, 2)] = 1.0 / (shear_factor * g * area);
    section.mass_kg_m = material.density_kg_m3 * area;
    section.inertia_kg_m = material.density_kg_m3 * Vector3::new(flap + edge, flap, edge);
    section.shear_per_twist_rate_pa_m = g * shear_radius_m;
    section
}

/// J/(b t³) of a rectangle with b/t = `ratio` ≥ 1, by the exact series (Timoshenko & Goodier, Theory of Elasticity, §109).
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// use washout::structure::section::rectangle_torsion_factor;
///
/// // of a square, and of a thin strip
/// assert!((rectangle_torsion_factor(1.0) - 0.1406).abs() < 1e-4);
/// assert!((rectangle_torsion_factor(1000.0) - 1.0 / 3.0).abs() < 1e-3);
/// ```
pub fn rectangle_torsion_factor(ratio: f64) -> f64 {
    let pi = std::f64::consts::PI;
    let sum: f64 = (0..60)
        .map(|i| {
            let n = f64::from(2 * i + 1);
            (n * pi * ratio / 2.0).tanh() / n.powi(5)
        })
        .sum();
    (1.0 - 192.0 / (pi.powi(5) * ratio) * sum) / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: BeamMaterial = BeamMaterial {
        e_pa: 2.5,
        g_pa: 1.0,
        density_kg_m3: 1.0,
    };

    #[test]
    fn rectangle_torsion_constant_is_the_series() {
        for (ratio, expected) in [
            (1.0, 0.140577),
            (1.5, 0.195761),
            (2.0, 0.228682),
            (5.0, 0.291317),
            (100.0, 0.331233),
        ] {
            assert!(
                (rectangle_torsion_factor(ratio) - expected).abs() < 1e-6,
                "{ratio}"
            );
        }
    }

    #[test]
    fn half_round_of_one_millimetre_rod_is_23_times_a_third_of_a_millimetre_in_torsion() {
        // physics of the three wings: GJ full : half : 0.3 mm = 123 : 23.4 : 1
        let full = Section::round(0.5, &UNIT).gj_n_m2();
        let half = Section::half_round(0.5, true, &UNIT).gj_n_m2();
        let thin = Section::round(0.15, &UNIT).gj_n_m2();
        assert!((full / thin - 123.457).abs() < 0.01);
        assert!((half / thin - 23.385).abs() < 0.01);
        let half = Section::half_round(1.0, true, &UNIT);
        assert!((half.ei_flap_n_m2() / 2.5 - 0.109757).abs() < 1e-6);
        assert!((half.ei_edge_n_m2() / 2.5 - std::f64::consts::FRAC_PI_8).abs() < 1e-6);
    }

    #[test]
    fn factors_multiply_stiffness_and_take_couplings_along_by_their_roots() {
        let mut k = Matrix6::from_diagonal(&nalgebra::Vector6::new(5.0, 6.0, 7.0, 2.0, 3.0, 9.0));
        (k[(3, 4)], k[(4, 3)]) = (0.5, 0.5);
        (k[(0, 5)], k[(5, 0)]) = (1.0, 1.0);
        let section = Section::from_stiffness(&k, 0.0).unwrap().with_factors(4.0, 9.0);
        let scaled = section.compliance.try_inverse().unwrap();
        for (i, j, expected) in [(3, 3, 18.0), (4, 4, 12.0), (3, 4, 3.0), (0, 5, 1.0), (0, 0, 5.0)] {
            assert!((scaled[(i, j)] - expected).abs() < 1e-12, "{i} {j}");
        }
    }

    #[test]
    fn indefinite_stiffness_is_refused() {
        let mut k = Matrix6::identity();
        k[(3, 4)] = 1.5;
        k[(4, 3)] = 1.5;
        assert!(Section::from_stiffness(&k, 0.0).is_err());
    }
}
