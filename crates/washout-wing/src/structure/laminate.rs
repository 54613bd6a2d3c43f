//! Stiffness of a strip of plies, by classical lamination.

use nalgebra::{Matrix6, Vector3};

use super::StructureError;
use super::largest::largest;
use super::section::{Fibre, PlyStiffness, Section};

impl Section {
    /// Thin strip of plies, width along e₂ (m), first ply at −e₃; the middle of the stack on the axis.
    ///
    /// Classical lamination of a strip whose sides are free (N_y = N_xy = M_y = 0): the plate's compliance restricted
    /// to N_x, M_x and M_xy, with M_xy = −T/(2b) and κ_xy = −2 κ_twist; bend-twist coupling is kept.
    ///
    /// # Errors
    /// If the plies give no positive definite plate.
    pub fn laminate(width_m: f64, plies: &[PlyStiffness]) -> Result<Self, StructureError> {
        let total: f64 = plies.iter().map(|p| p.thickness_m).sum();
        let mut stack = Stack::default();
        let mut bottom = -0.5 * total;
        for ply in plies {
            bottom = stack.add(ply, width_m, bottom);
        }
        Ok(Section {
            compliance: strip_compliance(&stack.abd, width_m)?,
            mass_kg_m: stack.mass,
            inertia_kg_m: Vector3::new(
                stack.inertia_edge + stack.inertia_flap,
                stack.inertia_flap,
                stack.inertia_edge,
            ),
            fibres: stack.fibres,
            shear_per_twist_rate_pa_m: largest(plies.iter().map(|p| p.q_pa[(2, 2)])) * total,
            skin: None,
        })
    }
}

/// Sums over the plies of a strip.
#[derive(Default)]
struct Stack {
    /// Stiffness of the plate per width: A, B, B, D.
    abd: Matrix6<f64>,
    mass: f64,
    inertia_edge: f64,
    inertia_flap: f64,
    fibres: Vec<Fibre>,
}

impl Stack {
    /// Adds a ply from `bottom` on; gives its top.
    fn add(&mut self, ply: &PlyStiffness, width_m: f64, bottom: f64) -> f64 {
        let top = bottom + ply.thickness_m;
        let moments = [
            top - bottom,
            (top.powi(2) - bottom.powi(2)) / 2.0,
            (top.powi(3) - bottom.powi(3)) / 3.0,
        ];
        for i in 0..3 {
            for j in 0..3 {
                self.abd[(i, j)] += ply.q_pa[(i, j)] * moments[0];
                self.abd[(i, j + 3)] += ply.q_pa[(i, j)] * moments[1];
                self.abd[(i + 3, j)] += ply.q_pa[(i, j)] * moments[1];
                self.abd[(i + 3, j + 3)] += ply.q_pa[(i, j)] * moments[2];
            }
        }
        let along = ply
            .q_pa
            .try_inverse()
            .map_or(ply.q_pa[(0, 0)], |s| 1.0 / s[(0, 0)]);
        for z in [bottom, top] {
            for edge_m in [0.5 * width_m, -0.5 * width_m] {
                self.fibres.push(Fibre {
                    edge_m,
                    flap_m: z,
                    modulus_pa: along,
                });
            }
        }
        self.mass += ply.density_kg_m3 * width_m * moments[0];
        self.inertia_flap += ply.density_kg_m3 * width_m * moments[2];
        self.inertia_edge += ply.density_kg_m3 * width_m.powi(3) / 12.0 * moments[0];
        top
    }
}

/// Compliance of a strip whose sides are free: that of the plate, of which N_x, M_x and M_xy are kept.
fn strip_compliance(abd: &Matrix6<f64>, width_m: f64) -> Result<Matrix6<f64>, StructureError> {
    let plate = abd
        .try_inverse()
        .ok_or(StructureError::SectionNotPositive { lowest: 0.0 })?;
    let mut compliance = Matrix6::<f64>::zeros();
    // N_x per width = N/b; M_x per width = M_flap-like/b; M_xy per width = −T/(2b); κ_xy = −2 κ_twist
    let keep = [(0, 0, 1.0), (3, 5, -0.5), (4, 3, 1.0)];
    for (beam_i, plate_i, factor_i) in keep {
        for (beam_j, plate_j, factor_j) in keep {
            compliance[(beam_i, beam_j)] = plate[(plate_i, plate_j)] * factor_i * factor_j / width_m;
        }
    }
    compliance[(5, 5)] = plate[(0, 0)] * 12.0 / width_m.powi(3);
    compliance[(1, 1)] = 1.2 * plate[(2, 2)] / width_m;
    Ok(compliance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix3;

    #[test]
    fn isotropic_laminate_is_the_thin_rectangle() {
        let nu = 0.25;
        let (e, g) = (2.5, 1.0);
        let q = e / (1.0 - nu * nu);
        let ply = PlyStiffness {
            thickness_m: 0.5e-3,
            q_pa: Matrix3::new(q, nu * q, 0.0, nu * q, q, 0.0, 0.0, 0.0, g),
            density_kg_m3: 1.0,
        };
        let strip = Section::laminate(0.1, &[ply, ply]).unwrap();
        let t = 1e-3_f64;
        assert!((strip.axial_stiffness_n() / (e * 0.1 * t) - 1.0).abs() < 1e-12);
        assert!((strip.ei_flap_n_m2() / (e * 0.1 * t.powi(3) / 12.0) - 1.0).abs() < 1e-12);
        assert!((strip.ei_edge_n_m2() / (e * t * 0.1_f64.powi(3) / 12.0) - 1.0).abs() < 1e-12);
        assert!((strip.gj_n_m2() / (g * 0.1 * t.powi(3) / 3.0) - 1.0).abs() < 1e-12);
        assert!(strip.compliance[(3, 4)].abs() < 1e-9 * strip.compliance[(3, 3)]);
    }
}
