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
