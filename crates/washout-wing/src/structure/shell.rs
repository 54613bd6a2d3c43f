//! Three-node film and plate element: membrane and bending action, six freedoms a node, large rotation.
//!
//! Its frame follows the plane of the deformed nodes; within it the axes turn by the polar rotation of the
//! constant-strain gradient, so the frame does not depend on the numbering of the nodes. Membrane: a relaxed tension
//! field or the optimal triangle (`membrane`); bending and transverse shear: the discrete
//! Kirchhoff-Mindlin triangle (`plate`).

use nalgebra::{Matrix3, SMatrix, SVector, UnitQuaternion, Vector2, Vector3};

use super::StructureError;
use super::corotational::{Frame, Response, Rest};
use super::sheet::{Compression, Sheet};
use super::{membrane, plate};

/// Share of the shear stiffness that holds the rotations about the normal of a film, at `drilling_factor` = 1.
///
/// About as weak as a film's bending, so that it is felt as little: ten times more moves a wing-like strip by 7e-6.
const DRILLING_SHARE: f64 = 1e-5;

/// A triangle of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Shell {
    /// Its three nodes, counter-clockwise seen from its normal.
    pub nodes: [usize; 3],
    /// Index of its sheet in the model.
    pub sheet: usize,
    pub(super) rest: Rest<3>,
    pub(super) area_m2: f64,
    /// Gradients of the linear shape functions at rest, element axes, 1/m.
    pub(super) gradient: [Vector2<f64>; 3],
    /// Stiffness of all that is linear in the local freedoms, in its plane (u, v, θ_z at each node) and out of it (w, θ_x, θ_y).
    pub(super) in_plane: SMatrix<f64, 9, 9>,
    pub(super) out_of_plane: SMatrix<f64, 9, 9>,
    /// Local force at zero strain.
    pub(super) initial_force: SVector<f64, 18>,
}

impl Shell {
    /// From its corners (m).
    ///
    /// # Errors
    /// If it has no area.
    pub fn new(
        nodes: [usize; 3],
        corners: [Vector3<f64>; 3],
        sheet_index: usize,
        sheet: &Sheet,
    ) -> Result<Self, StructureError> {
        let (side, other) = (corners[1] - corners[0], corners[2] - corners[0]);
        let normal = side.cross(&other);
        if normal.norm().partial_cmp(&(1e-12 * side.norm() * other.norm()))
            != Some(std::cmp::Ordering::Greater)
        {
            return Err(StructureError::DegenerateTriangle { nodes });
        }
        let (e1, e3) = (side.normalize(), normal.normalize());
        let rest = Rest::new(corners, Matrix3::from_columns(&[e1, e3.cross(&e1), e3]));
        let plane = rest.local.map(|x| x.xy());
        let area_m2 = 0.5 * normal.norm();
        let strain = membrane::constant_strain(&plane);
        let gradient = std::array::from_fn(|i| Vector2::new(strain[(0, 2 * i)], strain[(1, 2 * i + 1)]));
        let mut shell = Shell {
            nodes,
            sheet: sheet_index,
            rest,
            area_m2,
            gradient,
            in_plane: SMatrix::zeros(),
            out_of_plane: SMatrix::zeros(),
            initial_force: SVector::zeros(),
        };
        shell.set_sheet(&plane, sheet);
        Ok(shell)
    }

    fn set_sheet(&mut self, plane: &[Vector2<f64>; 3], sheet: &Sheet) {
        let stretching = sheet.e_pa * sheet.thickness_m;
        let bending = membrane::isotropic(stretching * sheet.thickness_m.powi(2) / 12.0, sheet.poisson);
        let softness = plate::softness_m2(sheet.thickness_m, sheet.poisson);
        self.out_of_plane = plate::stiffness(plane, &bending, softness);
        match sheet.compression {
            Compression::Carries => {
                self.in_plane = membrane::optimal(
                    plane,
                    &membrane::isotropic(stretching, sheet.poisson),
                    membrane::HIGHER_ORDER,
                );
                // the pretension pulls at the nodes alone: lumped onto the rotations about the normal it would, where the
                // film bends, leave moments in its plane that nothing but its bending could hold
                for (i, slope) in self.gradient.iter().enumerate() {
                    self.initial_force[6 * i] += sheet.pretension_n_per_m * self.area_m2 * slope.x;
                    self.initial_force[6 * i + 1] += sheet.pretension_n_per_m * self.area_m2 * slope.y;
                }
            }
            Compression::TensionField { drilling_factor, .. } => {
                let shear = 0.5 * stretching / (1.0 + sheet.poisson);
                for node in 0..3 {
                    self.in_plane[(3 * node + 2, 3 * node + 2)] =
                        DRILLING_SHARE * drilling_factor * shear * self.area_m2 / 3.0;
                }
            }
        }
    }

    /// Area at rest, m².
    pub fn area_m2(&self) -> f64 {
        self.area_m2
    }

    /// Axes at rest as columns, wing frame.
    pub fn axes(&self) -> &Matrix3<f64> {
        &self.rest.axes
    }

    /// Energy, force and tangent in the deformed shape; the tangent at the local freedoms `guess` if there are any,
    /// and as if a film carried at least the share `carried` of compression.
    pub fn response(
        &self,
        sheet: &Sheet,
        u: &[Vector3<f64>; 3],
        q: &[UnitQuaternion<f64>; 3],
        guess: Option<&SVector<f64, 18>>,
        carried: f64,
    ) -> Response<18> {
        let mut response = Response::zero();
        self.respond(sheet, (u, q), guess, carried, &mut response);
        response
    }

    /// Writes the same.
    pub(super) fn respond(
        &self,
        sheet: &Sheet,
        (u, q): (&[Vector3<f64>; 3], &[UnitQuaternion<f64>; 3]),
        guess: Option<&SVector<f64, 18>>,
        carried: f64,
        response: &mut Response<18>,
    ) {
        let frame = self.frame(u);
        let p = frame.local_freedoms(&self.rest, u, q);
        let about = guess.unwrap_or(&p);
        self.local(sheet, about, carried, response);
        frame.carry(about).response(response);
        if guess.is_some() {
            let (energy, force) = self.local_force(sheet, &p);
            response.energy = energy;
            response.force = frame.carry(&p).force(&force);
        }
    }

    /// Local freedoms after a step from a shape, to first order.
    pub fn guess(
        &self,
        u: &[Vector3<f64>; 3],
        q: &[UnitQuaternion<f64>; 3],
        step: &SVector<f64, 18>,
    ) -> SVector<f64, 18> {
        let frame = self.frame(u);
        let p = frame.local_freedoms(&self.rest, u, q);
        p + frame.local_change(&p, step)
    }

    /// Energy and force only.
    pub fn force(
        &self,
        sheet: &Sheet,
        u: &[Vector3<f64>; 3],
        q: &[UnitQuaternion<f64>; 3],
    ) -> (f64, SVector<f64, 18>) {
        let frame = self.frame(u);
        let p = frame.local_freedoms(&self.rest, u, q);
        let (energy, force) = self.local_force(sheet, &p);
        (energy, frame.carry(&p).force(&force))
    }

    pub(super) fn frame(&self, u: &[Vector3<f64>; 3]) -> Frame<3, 18> {
        let x = self.rest.deformed(u);
        let (side, other) = (x[1] - x[0], x[2] - x[0]);
        let e3 = side.cross(&other).normalize();
        let g1 = side.normalize();
        let g2 = e3.cross(&g1);
        // deformation gradient in the plane, in axes (g1, g2)
        let mut f = nalgebra::Matrix2::<f64>::zeros();
        for (x, slope) in x.iter().zip(&self.gradient) {
            f += Vector2::new(x.dot(&g1), x.dot(&g2)) * slope.transpose();
        }
        let trace = ((f.m11 + f.m22).powi(2) + (f.m21 - f.m12).powi(2)).sqrt();
        let (sine, cosine) = ((f.m21 - f.m12) / trace, (f.m11 + f.m22) / trace);
        let e1 = cosine * g1 + sine * g2;
        let axes = Matrix3::from_columns(&[e1, e3.cross(&e1), e3]);
        let to_frame = axes.transpose();
        let position = x.map(|x| to_frame * x);
        let plane = position.map(|x| x.xy());
        let area2 = (plane[1] - plane[0]).perp(&(plane[2] - plane[0]));
        let mut spin = SMatrix::<f64, 3, 18>::zeros();
        for i in 0..3 {
            let opposite = plane[(i + 2) % 3] - plane[(i + 1) % 3];
            spin[(0, 6 * i + 2)] = opposite.x / area2;
            spin[(1, 6 * i + 2)] = opposite.y / area2;
            spin[(2, 6 * i)] = -self.gradient[i].y / trace;
            spin[(2, 6 * i + 1)] = self.gradient[i].x / trace;
        }
        Frame { axes, position, spin }
    }
}

#[cfg(test)]
mod tests {
    use super::super::rotation::skew;
    use super::*;

    fn sheets() -> [Sheet; 2] {
        let sheet = Sheet {
            e_pa: 2.5e9,
            poisson: 0.34,
            thickness_m: 6e-6,
            density_kg_m3: 1420.0,
            pretension_n_per_m: 3.0,
            compression: Compression::Carries,
        };
        let wrinkles = Compression::TensionField {
            residual: 1e-4,
            drilling_factor: 1.0,
            slack: 0.0,
        };
        [
            sheet,
            Sheet {
                compression: wrinkles,
                ..sheet
            },
        ]
    }

    fn corners() -> [Vector3<f64>; 3] {
        [
            Vector3::new(0.001, 0.0, 0.0002),
            Vector3::new(0.0031, 0.0004, 0.0),
            Vector3::new(0.0014, 0.0022, -0.0003),
        ]
    }

    fn shape(size: f64) -> ([Vector3<f64>; 3], [UnitQuaternion<f64>; 3]) {
        let turn = UnitQuaternion::new(Vector3::new(0.5, -0.9, 0.4));
        let x = corners();
        let wobble = |k: usize| {
            Vector3::new(
                (k as f64 * 1.7).sin(),
                (k as f64 * 2.3).cos(),
                (k as f64 * 0.9).sin(),
            )
        };
        let u = std::array::from_fn(|i| turn * (x[i] + 2e-6 * size * wobble(i)) - x[i]);
        let q = std::array::from_fn(|i| turn * UnitQuaternion::new(0.02 * size * wobble(i + 5)));
        (u, q)
    }

    #[test]
    fn force_is_the_gradient_of_the_energy() {
        for sheet in sheets() {
            let shell = Shell::new([0, 1, 2], corners(), 0, &sheet).unwrap();
            let (u, q) = shape(1.0);
            let here = shell.response(&sheet, &u, &q, None, 0.0);
            let scale = here.force.norm();
            for k in 0..18 {
                let h = if k % 6 < 3 { 2e-9 } else { 1e-5 };
                let moved = |h: f64| {
                    let (mut u, mut q) = (u, q);
                    if k % 6 < 3 {
                        u[k / 6][k % 6] += h;
                    } else {
                        q[k / 6] = UnitQuaternion::new(Vector3::ith(k % 6 - 3, h)) * q[k / 6];
                    }
                    shell.force(&sheet, &u, &q)
                };
                let (plus, minus) = (moved(h), moved(-h));
                let slope = (plus.0 - minus.0) / (2.0 * h);
                let unit = if k % 6 < 3 { scale } else { scale * 1e-3 };
                assert!(
                    (slope - here.force[k]).abs() < 1e-4 * unit,
                    "{k} {slope} {}",
                    here.force[k]
                );
            }
        }
    }

    #[test]
    fn tangent_agrees_with_differences_to_the_strain() {
        // as for beams: the turning of the spin map under the element's unbalanced moment is left out, and moments
        // leave S(m)/2 at their node, which the loads cancel
        for sheet in sheets() {
            let shell = Shell::new([0, 1, 2], corners(), 0, &sheet).unwrap();
            let error = |size: f64| {
                let (u, q) = shape(size);
                let here = shell.response(&sheet, &u, &q, None, 0.0);
                let mut difference = SMatrix::<f64, 18, 18>::zeros();
                for k in 0..18 {
                    let h = if k % 6 < 3 { 1e-9 } else { 1e-6 };
                    let force = |h: f64| {
                        let (mut u, mut q) = (u, q);
                        if k % 6 < 3 {
                            u[k / 6][k % 6] += h;
                        } else {
                            q[k / 6] = UnitQuaternion::new(Vector3::ith(k % 6 - 3, h)) * q[k / 6];
                        }
                        shell.force(&sheet, &u, &q).1
                    };
                    difference.set_column(k, &((force(h) - force(-h)) / (2.0 * h)));
                }
                for node in 0..3 {
                    let at = 6 * node + 3;
                    let moment: Vector3<f64> = here.force.fixed_rows::<3>(at).into();
                    let mut block = difference.fixed_view_mut::<3, 3>(at, at);
                    block += 0.5 * skew(&moment);
                }
                // by forces, couplings and moments, each against its own size
                let part = |m: &SMatrix<f64, 18, 18>, i: usize, j: usize| {
                    let mut sum = 0.0;
                    for (row, column) in (0..18).flat_map(|r| (0..18).map(move |c| (r, c))) {
                        if (row % 6 / 3, column % 6 / 3) == (i, j) {
                            sum += m[(row, column)].powi(2);
                        }
                    }
                    sum.sqrt()
                };
                [(0, 0), (0, 1), (1, 1)]
                    .map(|(i, j)| part(&(difference - here.stiffness), i, j) / part(&here.stiffness, i, j))
            };
            let errors = [1.0, 0.1].map(error);
            println!("tangent of a shell, {:?}: {errors:?}", sheet.compression);
            for parts in errors {
                assert!(
                    parts[0] < 3e-5 && parts[1] < 1e-7 && parts[2] < 1e-7,
                    "{errors:?}"
                );
            }
            assert!(errors[1][0] < 3e-6, "{errors:?}");
        }
    }

    #[test]
    fn rigid_motion_of_a_triangle_without_tension_costs_nothing() {
        for mut sheet in sheets() {
            sheet.pretension_n_per_m = 0.0;
            let shell = Shell::new([0, 1, 2], corners(), 0, &sheet).unwrap();
            let (u, q) = shape(0.0);
            let here = shell.response(&sheet, &u, &q, None, 0.0);
            let size = u.iter().map(|u| u.norm()).sum::<f64>();
            assert!(here.force.norm() < 1e-10 * here.stiffness.norm() * size);
        }
    }

    #[test]
    fn tension_gives_the_frame_the_stiffness_of_a_membrane() {
        let [sheet, _] = sheets();
        let shell = Shell::new([0, 1, 2], corners(), 0, &sheet).unwrap();
        let (u, q) = ([Vector3::zeros(); 3], [UnitQuaternion::identity(); 3]);
        let with = shell.response(&sheet, &u, &q, None, 0.0).stiffness;
        let without = shell.linear_part(&sheet);
        let normal = shell.axes().column(2).into_owned();
        let tension = shell.unit_tension();
        for i in 0..3 {
            for j in 0..3 {
                let block = (with - without).fixed_view::<3, 3>(6 * i, 6 * j).into_owned();
                let out = normal.dot(&(block * normal));
                let expected = 3.0 * tension[(i, j)];
                assert!((out - expected).abs() < 3e-6, "{out} {expected}");
            }
        }
    }

    impl Shell {
        fn linear_part(&self, sheet: &Sheet) -> SMatrix<f64, 18, 18> {
            let mut turn = SMatrix::<f64, 18, 18>::zeros();
            for i in 0..6 {
                turn.fixed_view_mut::<3, 3>(3 * i, 3 * i)
                    .copy_from(&self.rest.axes);
            }
            let mut local = Response::zero();
            self.local(sheet, &SVector::zeros(), 0.0, &mut local);
            turn * local.stiffness * turn.transpose()
        }
    }
}
