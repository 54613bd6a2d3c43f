//! The corotational frame: turns a small-deformation element into one for large rotations.
//!
//! An element of N nodes has local deformational freedoms p = (d₁, θ₁, …): displacement and rotation vector of
//! each node against a frame that moves with the element. Energy U(p), force ∂U/∂p and stiffness come from
//! the element; this file carries them to the wing frame, consistently with the motion of the frame, so that
//! the force is the exact gradient of U and rigid motions cost nothing.
//! Source: Nour-Omid & Rankin 1991; Felippa & Haugen 2005 (see `rotation`).

use nalgebra::{Matrix3, SMatrix, SVector, UnitQuaternion, Vector3};

use super::rotation::{moment_correction, rotation_vector, skew, spin_to_vector};

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

impl<const D: usize> Response<D> {
    /// To be written.
    pub fn zero() -> Self {
        Response {
            energy: 0.0,
            force: SVector::zeros(),
            stiffness: SMatrix::zeros(),
        }
    }
}

/// Rest data of an element that the frame needs.
#[derive(Debug, Clone, PartialEq)]
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

    /// What carries forces and responses from local freedoms p to the wing frame.
    pub fn carry(&self, p: &SVector<f64, D>) -> Carry<'_, N, D> {
        let theta = std::array::from_fn(|i| p.fixed_rows::<3>(6 * i + 3).into());
        let spin_to_vector = theta.map(|theta| spin_to_vector(&theta));
        let to_frame = self.axes.transpose();
        Carry {
            frame: self,
            theta,
            spin_to_vector,
            about: spin_to_vector.map(|h| h * to_frame),
            along: to_frame,
        }
    }
}

/// The way from local freedoms to the wing frame.
#[derive(Debug)]
pub struct Carry<'a, const N: usize, const D: usize> {
    frame: &'a Frame<N, D>,
    /// Local rotation vector of each node.
    theta: [Vector3<f64>; N],
    /// Change of each with a spin, frame axes.
    spin_to_vector: [Matrix3<f64>; N],
    /// The same of spins in the wing frame.
    about: [Matrix3<f64>; N],
    /// Displacements in frame axes from those in the wing frame.
    along: Matrix3<f64>,
}

impl<const N: usize, const D: usize> Carry<'_, N, D> {
    /// A local force in the wing frame.
    pub fn force(&self, local: &SVector<f64, D>) -> SVector<f64, D> {
        let (force, _) = self.projected(local);
        self.turned(&force)
    }

    /// A local response in the wing frame, where it stands: exact gradient, symmetric tangent.
    ///
    /// With N the local freedoms for those of the wing frame, were the frame at rest, G its spin, R the rigid rotations about its
    /// centroid: Nᵀ K N − C G − Gᵀ Cᵀ, where C holds what K and the force make of R. Matrices are walked by columns, which are as they
    /// stand in memory.
    pub fn response(&self, local: &mut Response<D>) {
        let (force, unprojected) = self.projected(&local.force);
        let force = self.turned(&force);
        let spin = self.spin();
        let k = &mut local.stiffness.data.0;
        for (part, columns) in k.chunks_exact_mut(3).enumerate() {
            combine(columns, self.part(part));
        }
        let mut c = self.by_rigid_rotation(k);
        for rigid in &mut c {
            self.turn_rows(rigid, 0);
        }
        for (column, rows) in k.iter_mut().enumerate() {
            // only the lower triangle of blocks is made
            self.turn_rows(rows, column / 3);
        }
        // the moment axes turn with the nodes
        for i in 0..N {
            let moment: Vector3<f64> = local.force.fixed_rows::<3>(6 * i + 3).into();
            let correction = moment_correction(&self.theta[i], &moment, &self.spin_to_vector[i]);
            let correction = self.frame.axes * (0.5 * (correction + correction.transpose())) * self.along;
            for (a, column) in c.iter_mut().enumerate() {
                for b in 0..3 {
                    k[6 * i + 3 + a][6 * i + 3 + b] += correction[(b, a)];
                    column[6 * i + 3 + b] += correction[(b, a)];
                }
            }
        }
        self.add_turning(&mut c, [&force, &self.turned(&unprojected)], &spin);
        for column in 0..D {
            let (own, by_spin) = (&mut k[column], [0, 1, 2].map(|a| spin[a][column]));
            let by_c = [0, 1, 2].map(|a| c[a][column]);
            for row in 0..D {
                let part = |a: usize| c[a][row] * by_spin[a] + spin[a][row] * by_c[a];
                own[row] -= part(0) + part(1) + part(2);
            }
        }
        for column in 0..D {
            let (before, own) = k.split_at_mut(column);
            for (row, other) in before[..column - column % 3].iter().enumerate() {
                own[0][row] = other[column];
            }
        }
        local.force = force;
    }

    /// Completes C, of which the part of the stiffness is made already.
    fn add_turning(
        &self,
        c: &mut [[f64; D]; 3],
        [force, unprojected]: [&SVector<f64, D>; 2],
        spin: &[[f64; D]; 3],
    ) {
        let three = |of: &[f64]| Vector3::new(of[0], of[1], of[2]);
        // what rigid rotations make of the force, and of moments
        let mut both = Matrix3::<f64>::zeros();
        for i in 0..N {
            let arm = self.frame.axes * self.frame.position[i];
            let pull = three(&unprojected.as_slice()[6 * i..]);
            both += skew(&pull) * skew(&arm);
            for (a, column) in c.iter().enumerate() {
                let turned = arm.cross(&three(&column[6 * i..])) + three(&column[6 * i + 3..]);
                let mut column = both.column_mut(a);
                column += turned;
            }
        }
        let both = 0.25 * (both + both.transpose());
        for (a, column) in c.iter_mut().enumerate() {
            for (at, own) in column.iter_mut().enumerate() {
                *own -= spin[0][at] * both[(0, a)] + spin[1][at] * both[(1, a)] + spin[2][at] * both[(2, a)];
            }
            for i in 0..N {
                let pulls = three(&force.as_slice()[6 * i..]) + three(&unprojected.as_slice()[6 * i..]);
                let pulls = skew(&(0.5 * pulls)).column(a).into_owned();
                let turns = skew(&(0.5 * three(&force.as_slice()[6 * i + 3..])))
                    .column(a)
                    .into_owned();
                for b in 0..3 {
                    column[6 * i + b] += pulls[b];
                    column[6 * i + 3 + b] += turns[b];
                }
            }
        }
    }

    /// Of local freedoms 3 `part` to 3 `part` + 2: their change with those of the wing frame.
    fn part(&self, part: usize) -> &Matrix3<f64> {
        match part % 2 {
            0 => &self.along,
            _ => &self.about[part / 2],
        }
    }

    /// Nᵀ column, from part `first` on.
    fn turn_rows(&self, column: &mut [f64; D], first: usize) {
        for (part, rows) in column.chunks_exact_mut(3).enumerate().skip(first) {
            let n = self.part(part);
            let own = [rows[0], rows[1], rows[2]];
            for (b, row) in rows.iter_mut().enumerate() {
                *row = n[(0, b)] * own[0] + n[(1, b)] * own[1] + n[(2, b)] * own[2];
            }
        }
    }

    /// Columns times the rigid rotations of the nodes about their centroid, wing frame, by axis of rotation.
    fn by_rigid_rotation(&self, columns: &[[f64; D]; D]) -> [[f64; D]; 3] {
        let mut rigid = [[0.0; D]; 3];
        for i in 0..N {
            let arm = self.frame.axes * self.frame.position[i];
            let [x, y, z] = [0, 1, 2].map(|a| &columns[6 * i + a]);
            let [rx, ry, rz] = [3, 4, 5].map(|a| &columns[6 * i + a]);
            for row in 0..D {
                rigid[0][row] += rx[row] + z[row] * arm.y - y[row] * arm.z;
                rigid[1][row] += ry[row] + x[row] * arm.z - z[row] * arm.x;
                rigid[2][row] += rz[row] + y[row] * arm.x - x[row] * arm.y;
            }
        }
        rigid
    }

    /// Spin of the frame, wing frame, by axis.
    fn spin(&self) -> [[f64; D]; 3] {
        let spin = self.frame.axes * self.frame.spin;
        let mut turned = [[0.0; D]; 3];
        for part in 0..2 * N {
            let block = spin.fixed_view::<3, 3>(0, 3 * part) * self.along;
            for a in 0..3 {
                for b in 0..3 {
                    turned[a][3 * part + b] = block[(a, b)];
                }
            }
        }
        turned
    }

    /// Hᵀ f, projected and unprojected, frame axes.
    fn projected(&self, local: &SVector<f64, D>) -> (SVector<f64, D>, SVector<f64, D>) {
        let mut unprojected = *local;
        let mut moment = Vector3::<f64>::zeros();
        for i in 0..N {
            let m: Vector3<f64> = local.fixed_rows::<3>(6 * i + 3).into();
            let m = self.spin_to_vector[i].tr_mul(&m);
            unprojected.fixed_rows_mut::<3>(6 * i + 3).copy_from(&m);
            let n: Vector3<f64> = local.fixed_rows::<3>(6 * i).into();
            moment += self.frame.position[i].cross(&n) + m;
        }
        (unprojected - self.frame.spin.tr_mul(&moment), unprojected)
    }

    /// From frame axes to the wing frame.
    fn turned(&self, force: &SVector<f64, D>) -> SVector<f64, D> {
        let mut turned = SVector::<f64, D>::zeros();
        for i in 0..2 * N {
            turned
                .fixed_rows_mut::<3>(3 * i)
                .copy_from(&(self.frame.axes * force.fixed_rows::<3>(3 * i)));
        }
        turned
    }
}

/// Three columns times a matrix of 3 × 3.
fn combine<const D: usize>(columns: &mut [[f64; D]], by: &Matrix3<f64>) {
    let [x, y, z] = [columns[0], columns[1], columns[2]];
    for (b, column) in columns.iter_mut().enumerate() {
        for row in 0..D {
            column[row] = x[row] * by[(0, b)] + y[row] * by[(1, b)] + z[row] * by[(2, b)];
        }
    }
}
