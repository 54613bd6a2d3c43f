//! Local action of a shell element: energy, force and stiffness in the freedoms of its moving frame.

use nalgebra::{SVector, Vector3};

use super::corotational::Response;
use super::membrane::{self, FilmResponse};
use super::sheet::{Compression, Sheet};
use super::shell::Shell;

/// Local freedoms in the plane of the element: displacements and rotations about its normal.
const IN_PLANE: [usize; 9] = [0, 1, 5, 6, 7, 11, 12, 13, 17];
/// Local freedoms out of it: deflections and rotations of the normal.
const OUT_OF_PLANE: [usize; 9] = [2, 3, 4, 8, 9, 10, 14, 15, 16];

impl Shell {
    /// Writes the response in local freedoms; gives that of the film in it.
    pub(super) fn local(
        &self,
        sheet: &Sheet,
        p: &SVector<f64, 18>,
        carried: f64,
        local: &mut Response<18>,
    ) -> Option<FilmResponse> {
        let film = self.film(sheet, p);
        (local.energy, local.force) = self.with_film(p, self.linear_force(p), film.as_ref());
        local.stiffness.fill(0.0);
        let k = &mut local.stiffness.data.0;
        for (part, places) in [(&self.in_plane, IN_PLANE), (&self.out_of_plane, OUT_OF_PLANE)] {
            for (column, &j) in part.data.0.iter().zip(&places) {
                for (own, &i) in column.iter().zip(&places) {
                    k[j][i] = *own;
                }
            }
        }
        if let Some(film) = &film {
            let elastic = membrane::isotropic(sheet.e_pa * sheet.thickness_m, sheet.poisson);
            let tangent = film.tangent + carried * (elastic - film.tangent);
            for (node, slope) in self.gradient.iter().enumerate() {
                let [x, y] = [slope.x * self.area_m2, slope.y * self.area_m2];
                let by_strain = |b: Vector3<f64>| tangent * b;
                let forces = [
                    by_strain(Vector3::new(x, 0.0, y)),
                    by_strain(Vector3::new(0.0, y, x)),
                ];
                for (column, force) in forces.into_iter().enumerate() {
                    for (other, slope) in self.gradient.iter().enumerate() {
                        let column = &mut k[6 * node + column];
                        column[6 * other] += slope.x * force.x + slope.y * force.z;
                        column[6 * other + 1] += slope.y * force.y + slope.x * force.z;
                    }
                }
            }
        }
        film
    }

    pub(super) fn local_force(&self, sheet: &Sheet, p: &SVector<f64, 18>) -> (f64, SVector<f64, 18>) {
        let film = self.film(sheet, p);
        self.with_film(p, self.linear_force(p), film.as_ref())
    }

    /// Local force at `p` by the law of a film that is linear about the local freedoms `about`, where it answers as given.
    pub(super) fn local_force_by(
        &self,
        film: Option<&FilmResponse>,
        about: &SVector<f64, 18>,
        p: &SVector<f64, 18>,
    ) -> SVector<f64, 18> {
        let film = film.map(|film| FilmResponse {
            force: film.force + film.tangent * (self.strain(p) - self.strain(about)),
            ..*film
        });
        self.with_film(p, self.linear_force(p), film.as_ref()).1
    }

    /// Force of all that is linear in the local freedoms.
    fn linear_force(&self, p: &SVector<f64, 18>) -> SVector<f64, 18> {
        let mut force = self.initial_force;
        for (part, places) in [(&self.in_plane, IN_PLANE), (&self.out_of_plane, OUT_OF_PLANE)] {
            let mut sum = [0.0; 9];
            for (column, &j) in part.data.0.iter().zip(&places) {
                for (sum, own) in sum.iter_mut().zip(column) {
                    *sum += own * p[j];
                }
            }
            for (sum, &i) in sum.into_iter().zip(&places) {
                force[i] += sum;
            }
        }
        force
    }

    /// Energy and local force of all that is linear and of a film.
    fn with_film(
        &self,
        p: &SVector<f64, 18>,
        linear: SVector<f64, 18>,
        film: Option<&FilmResponse>,
    ) -> (f64, SVector<f64, 18>) {
        let mut force = linear;
        let mut energy = 0.5 * p.dot(&(linear + self.initial_force));
        if let Some(film) = film {
            energy += film.energy * self.area_m2;
            let pull = film.force * self.area_m2;
            for (node, slope) in self.gradient.iter().enumerate() {
                force[6 * node] += slope.x * pull.x + slope.y * pull.z;
                force[6 * node + 1] += slope.y * pull.y + slope.x * pull.z;
            }
        }
        (energy, force)
    }

    /// Strain (ε_x, ε_y, γ_xy) of the constant-strain triangle.
    pub(super) fn strain(&self, p: &SVector<f64, 18>) -> Vector3<f64> {
        let mut strain = Vector3::zeros();
        for (node, slope) in self.gradient.iter().enumerate() {
            let (u, v) = (p[6 * node], p[6 * node + 1]);
            strain.x += slope.x * u;
            strain.y += slope.y * v;
            strain.z += slope.y * u + slope.x * v;
        }
        strain
    }

    pub(super) fn film(&self, sheet: &Sheet, p: &SVector<f64, 18>) -> Option<FilmResponse> {
        let Compression::TensionField { residual, slack, .. } = sheet.compression else {
            return None;
        };
        let stretching = sheet.e_pa * sheet.thickness_m;
        let shrinkage = sheet.pretension_n_per_m * (1.0 - sheet.poisson) / stretching;
        let strain = self.strain(p) + Vector3::new(shrinkage, shrinkage, 0.0);
        Some(membrane::tension_field(
            &strain,
            stretching,
            sheet.poisson,
            residual,
            slack,
        ))
    }
}
