//! Membrane forces of a shell element, in axes that the caller chooses; its normal and its stiffness under tension.

use nalgebra::{SMatrix, SVector, UnitQuaternion, Vector3};

use super::membrane;
use super::sheet::Sheet;
use super::shell::Shell;

impl Shell {
    /// Unit normal of the deformed triangle.
    pub fn normal(&self, u: &[Vector3<f64>; 3]) -> Vector3<f64> {
        let x = self.rest.deformed(u);
        (x[1] - x[0]).cross(&(x[2] - x[0])).normalize()
    }

    /// Out-of-plane stiffness of the deformed triangle under a unit isotropic tension (1 N/m), per pair of nodes.
    ///
    /// The block of nodes i and j is the returned factor times n nᵀ, n the normal.
    pub fn unit_tension(&self) -> SMatrix<f64, 3, 3> {
        SMatrix::from_fn(|i, j| self.area_m2 * self.gradient[i].dot(&self.gradient[j]))
    }

    /// Membrane forces N_x, N_y, N_xy (N/m) in the axes that `along` gives at rest: its projection is x.
    pub fn membrane_force(
        &self,
        sheet: &Sheet,
        u: &[Vector3<f64>; 3],
        q: &[UnitQuaternion<f64>; 3],
        along: &Vector3<f64>,
    ) -> [f64; 3] {
        let frame = self.frame(u);
        let p = frame.local_freedoms(&self.rest, u, q);
        let n = match self.film(sheet, &p) {
            Some(film) => film.force,
            None => self.elastic_force(sheet, &p),
        };
        self.turned_force(&n, along)
    }

    /// Its change to first order about the rest with displacements, for linear kinematics.
    pub fn membrane_force_linear(
        &self,
        sheet: &Sheet,
        u: &[Vector3<f64>; 3],
        along: &Vector3<f64>,
    ) -> [f64; 3] {
        let mut p = SVector::<f64, 18>::zeros();
        for (i, u) in u.iter().enumerate() {
            p.fixed_rows_mut::<3>(6 * i)
                .copy_from(&(self.rest.axes.transpose() * u));
        }
        let stiffness = membrane::isotropic(sheet.e_pa * sheet.thickness_m, sheet.poisson);
        self.turned_force(&(stiffness * self.strain(&p)), along)
    }

    fn elastic_force(&self, sheet: &Sheet, p: &SVector<f64, 18>) -> SVector<f64, 3> {
        let stiffness = membrane::isotropic(sheet.e_pa * sheet.thickness_m, sheet.poisson);
        stiffness * self.strain(p) + SVector::<f64, 3>::new(1.0, 1.0, 0.0) * sheet.pretension_n_per_m
    }

    /// Membrane force in axes whose x is the projection of `along`.
    fn turned_force(&self, n: &SVector<f64, 3>, along: &Vector3<f64>) -> [f64; 3] {
        let along = self.rest.axes.transpose() * along;
        let (sine, cosine) = along.y.atan2(along.x).sin_cos();
        let (c2, s2, cs) = (cosine * cosine, sine * sine, cosine * sine);
        [
            c2 * n[0] + s2 * n[1] + 2.0 * cs * n[2],
            s2 * n[0] + c2 * n[1] - 2.0 * cs * n[2],
            cs * (n[1] - n[0]) + (c2 - s2) * n[2],
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::sheet::Compression;

    /// Stretched along a line that stands at an angle in the plane of a tilted triangle, a sheet without lateral contraction bears E t ε
    /// along that line and nothing across; seen from axes turned against it that is N (cos²θ, sin²θ, sin θ cos θ) where they are turned back by θ: Mohr's circle.
    #[test]
    fn the_force_of_a_sheet_drawn_one_way_is_seen_from_other_axes_as_mohrs_circle_has_it() {
        let sheet = Sheet {
            e_pa: 2.5e9,
            poisson: 0.0,
            thickness_m: 6e-6,
            density_kg_m3: 1420.0,
            pretension_n_per_m: 0.0,
            compression: Compression::Carries,
        };
        let tilt = UnitQuaternion::new(Vector3::new(0.3, -0.2, 0.9));
        let corners = [[0.0, 0.0], [2e-3, 3e-4], [5e-4, 1.7e-3]].map(|[x, y]| tilt * Vector3::new(x, y, 0.0));
        let shell = Shell::new([0, 1, 2], corners, 0, &sheet).unwrap();
        let drawn = tilt * Vector3::new(0.6, 0.8, 0.0);
        let strain = 1e-6;
        let u = corners.map(|x| drawn * (strain * drawn.dot(&x)));
        let whole = sheet.e_pa * sheet.thickness_m * strain;
        for theta in [0.0_f64, 0.4, 1.1, 2.5] {
            let normal = tilt * Vector3::z();
            let along = UnitQuaternion::new(normal * -theta) * drawn;
            let wanted = [
                theta.cos().powi(2),
                theta.sin().powi(2),
                theta.sin() * theta.cos(),
            ]
            .map(|n| n * whole);
            for found in [
                shell.membrane_force(&sheet, &u, &[UnitQuaternion::identity(); 3], &along),
                shell.membrane_force_linear(&sheet, &u, &along),
            ] {
                for (found, wanted) in found.iter().zip(wanted) {
                    assert!(
                        (found - wanted).abs() < 1e-4 * whole,
                        "{theta}: {found} for {wanted}"
                    );
                }
            }
        }
    }
}
