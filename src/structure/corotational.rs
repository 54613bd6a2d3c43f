//! The corotational frame: turns a small-deformation element into one for large rotations.
//!
//! An element of N nodes has local deformational freedoms p = (d₁, θ₁, …): displacement and rotation vector of
//! each node against a frame that moves with the element. Energy U(p), force ∂U/∂p and stiffness come from
//! the element; this file carries them to the wing frame, consistently with the motion of the frame, so that
//! the force is the exact gradient of U and rigid motions cost nothing.
//! Source: Nour-Omid & Rankin 1991; Felippa & Haugen 2005 (see `rotation`).

use nalgebra::{Matrix3, SMatrix, SVector, UnitQuaternion, Vector3};

use super::rotation::{moment_correction, rotation_vector, skew, spin_moment, spin_to_vector};

/// The moving frame of an element of N nodes and D = 6 N freedoms.
#[derive(Debug, Clone)]
pub struct Frame<const N: usize, const D: usize> {
    /// Axes of the frame as columns, wing frame.
    pub axes: Matrix3<f64>,
    /// Positions of the nodes from their centroid, frame axes, m.
    pub position: [Vector3<f64>; N],
    /// Spin of the frame for a unit change of each freedom, frame axes.
    pub spin: SMatrix<f64, 3, D>,
}

/// Energy, force and stiffness of an element.
#[derive(Debug, Clone)]
pub struct Response<const D: usize> {
    /// Strain energy, J.
    pub energy: f64,
    /// Gradient of the energy: forces N, moments N·m.
    pub force: SVector<f64, D>,
    /// Symmetric second derivative of the energy.
    pub stiffness: SMatrix<f64, D, D>,
}

/// Rest data of an element that the frame needs.
#[derive(Debug, Clone)]
pub struct Rest<const N: usize> {
    /// Axes at rest as columns.
    pub axes: Matrix3<f64>,
    /// Positions of the nodes from their centroid, wing frame, m.
    pub global: [Vector3<f64>; N],
    /// The same in the element's axes at rest.
    pub local: [Vector3<f64>; N],
}

impl<const N: usize> Rest<N> {
    /// From node positions (m) and axes at rest.
    pub fn new(nodes: [Vector3<f64>; N], axes: Matrix3<f64>) -> Self {
        let centroid = nodes.iter().sum::<Vector3<f64>>() / N as f64;
        let global = nodes.map(|x| x - centroid);
        Rest {
            axes,
            global,
            local: global.map(|x| axes.transpose() * x),
        }
    }

    /// Positions from the centroid in the deformed shape, wing frame, m.
    pub fn deformed(&self, displacement: &[Vector3<f64>; N]) -> [Vector3<f64>; N] {
        let mean = displacement.iter().sum::<Vector3<f64>>() / N as f64;
        std::array::from_fn(|i| self.global[i] + (displacement[i] - mean))
    }
}

impl<const N: usize, const D: usize> Frame<N, D> {
    /// Local deformational freedoms p of a shape.
    pub fn local_freedoms(
        &self,
        rest: &Rest<N>,
        displacement: &[Vector3<f64>; N],
        rotation: &[UnitQuaternion<f64>; N],
    ) -> SVector<f64, D> {
        let to_frame = self.axes.transpose();
        let turned = to_frame - rest.axes.transpose();
        let mean = displacement.iter().sum::<Vector3<f64>>() / N as f64;
        let mut p = SVector::<f64, D>::zeros();
        for i in 0..N {
            let d = to_frame * (displacement[i] - mean) + turned * rest.global[i];
            let local = to_frame * rotation[i].to_rotation_matrix().matrix() * rest.axes;
            p.fixed_rows_mut::<3>(6 * i).copy_from(&d);
            p.fixed_rows_mut::<3>(6 * i + 3)
                .copy_from(&rotation_vector(&local));
        }
        p
    }

    /// Change of the local freedoms p to first order with a change of displacements and spins (wing frame).
    pub fn local_change(&self, p: &SVector<f64, D>, change: &SVector<f64, D>) -> SVector<f64, D> {
        let to_frame = self.axes.transpose();
        let mut turned = SVector::<f64, D>::zeros();
        for i in 0..2 * N {
            turned
                .fixed_rows_mut::<3>(3 * i)
                .copy_from(&(to_frame * change.fixed_rows::<3>(3 * i)));
        }
        let spin = self.spin * turned;
        let mut mean = Vector3::<f64>::zeros();
        for i in 0..N {
            mean += turned.fixed_rows::<3>(6 * i) / N as f64;
        }
        for i in 0..N {
            let moved: Vector3<f64> = turned.fixed_rows::<3>(6 * i) - mean - spin.cross(&self.position[i]);
            let theta: Vector3<f64> = p.fixed_rows::<3>(6 * i + 3).into();
            let bent: Vector3<f64> = spin_to_vector(&theta) * (turned.fixed_rows::<3>(6 * i + 3) - spin);
            turned.fixed_rows_mut::<3>(6 * i).copy_from(&moved);
            turned.fixed_rows_mut::<3>(6 * i + 3).copy_from(&bent);
        }
        turned
    }

    /// Carries the local force to the wing frame.
    pub fn global_force(&self, p: &SVector<f64, D>, local_force: &SVector<f64, D>) -> SVector<f64, D> {
        let (force, _) = self.projected(p, local_force);
        self.turned(&force)
    }

    /// Carries a local response to the wing frame, where it stands: exact gradient, symmetric tangent.
    pub fn carry_to_global(&self, p: &SVector<f64, D>, local: &mut Response<D>) {
        let (force, unprojected) = self.projected(p, &local.force);
        let k = &mut local.stiffness;
        // Hᵀ K H and the correction for the turning moment axes
        for i in 0..N {
            let theta: Vector3<f64> = p.fixed_rows::<3>(6 * i + 3).into();
            let h = spin_to_vector(&theta);
            for j in 0..2 * N {
                let row = k.fixed_view::<3, 3>(6 * i + 3, 3 * j).into_owned();
                k.fixed_view_mut::<3, 3>(6 * i + 3, 3 * j)
                    .copy_from(&(h.transpose() * row));
            }
            for j in 0..2 * N {
                let column = k.fixed_view::<3, 3>(3 * j, 6 * i + 3).into_owned();
                k.fixed_view_mut::<3, 3>(3 * j, 6 * i + 3)
                    .copy_from(&(column * h));
            }
            let moment: Vector3<f64> = local.force.fixed_rows::<3>(6 * i + 3).into();
            let correction = moment_correction(&theta, &moment);
            let mut block = k.fixed_view_mut::<3, 3>(6 * i + 3, 6 * i + 3);
            block += 0.5 * (correction + correction.transpose());
        }
        // projection and turning of the frame: K − C G − Gᵀ Cᵀ, of rank six
        let rigid = self.rigid_rotation();
        let k_rigid = *k * rigid;
        let mut turning_all = SMatrix::<f64, D, 3>::zeros();
        let mut turning_force = SMatrix::<f64, D, 3>::zeros();
        for i in 0..N {
            let n: Vector3<f64> = force.fixed_rows::<3>(6 * i).into();
            let m: Vector3<f64> = force.fixed_rows::<3>(6 * i + 3).into();
            let n_unprojected: Vector3<f64> = unprojected.fixed_rows::<3>(6 * i).into();
            turning_all.fixed_view_mut::<3, 3>(6 * i, 0).copy_from(&skew(&n));
            turning_all
                .fixed_view_mut::<3, 3>(6 * i + 3, 0)
                .copy_from(&skew(&m));
            turning_force
                .fixed_view_mut::<3, 3>(6 * i, 0)
                .copy_from(&skew(&n_unprojected));
        }
        let both = rigid.transpose() * k_rigid + turning_force.transpose() * rigid;
        let both = 0.5 * (both + both.transpose());
        let c = k_rigid + 0.5 * (turning_all + turning_force) - 0.5 * self.spin.transpose() * both;
        let spin = self.spin.transpose();
        for column in 0..D {
            let by_spin: [f64; 3] = std::array::from_fn(|a| spin[(column, a)]);
            let by_c: [f64; 3] = std::array::from_fn(|a| c[(column, a)]);
            // only the lower triangle of blocks is read on
            for row in column - column % 3..D {
                let mut sum = 0.0;
                for a in 0..3 {
                    sum += c[(row, a)] * by_spin[a] + spin[(row, a)] * by_c[a];
                }
                k[(row, column)] -= sum;
            }
        }
        // to the wing frame
        let to_frame = self.axes.transpose();
        for i in 0..2 * N {
            for j in 0..=i {
                let block = self.axes * k.fixed_view::<3, 3>(3 * i, 3 * j) * to_frame;
                k.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&block);
                if i != j {
                    k.fixed_view_mut::<3, 3>(3 * j, 3 * i)
                        .copy_from(&block.transpose());
                }
            }
        }
        local.force = self.turned(&force);
    }

    /// Rigid rotation of the nodes about their centroid: unit spins to freedoms.
    fn rigid_rotation(&self) -> SMatrix<f64, D, 3> {
        let mut rigid = SMatrix::<f64, D, 3>::zeros();
        for i in 0..N {
            rigid
                .fixed_view_mut::<3, 3>(6 * i, 0)
                .copy_from(&-skew(&self.position[i]));
            rigid
                .fixed_view_mut::<3, 3>(6 * i + 3, 0)
                .copy_from(&Matrix3::identity());
        }
        rigid
    }

    /// Hᵀ f, projected and unprojected, frame axes.
    fn projected(
        &self,
        p: &SVector<f64, D>,
        local_force: &SVector<f64, D>,
    ) -> (SVector<f64, D>, SVector<f64, D>) {
        let mut unprojected = *local_force;
        let mut moment = Vector3::<f64>::zeros();
        for i in 0..N {
            let theta: Vector3<f64> = p.fixed_rows::<3>(6 * i + 3).into();
            let m: Vector3<f64> = local_force.fixed_rows::<3>(6 * i + 3).into();
            let m = spin_moment(&theta, &m);
            unprojected.fixed_rows_mut::<3>(6 * i + 3).copy_from(&m);
            let n: Vector3<f64> = local_force.fixed_rows::<3>(6 * i).into();
            moment += self.position[i].cross(&n) + m;
        }
        (unprojected - self.spin.transpose() * moment, unprojected)
    }

    /// From frame axes to the wing frame.
    fn turned(&self, force: &SVector<f64, D>) -> SVector<f64, D> {
        let mut turned = SVector::<f64, D>::zeros();
        for i in 0..2 * N {
            turned
                .fixed_rows_mut::<3>(3 * i)
                .copy_from(&(self.axes * force.fixed_rows::<3>(3 * i)));
        }
        turned
    }
}
