//! Two-node beam element: exact linear stiffness from the section's flexibility, in a corotational frame.
//!
//! The frame follows the chord of the element and the mean of its nodal triads (Battini & Pacoste, Comput. Methods
//! Appl. Mech. Eng. 191 (2002) 1755-1789). The local 12×12 stiffness is the inverse of the exact flexibility of a
//! straight prismatic beam, so it holds for any coupled 6×6 section, does not lock in shear, and is exact for
//! loads at the nodes.

use nalgebra::{Matrix3, Matrix6, SMatrix, SVector, UnitQuaternion, Vector3};

use super::StructureError;
use super::corotational::{Frame, Response, Rest};
use super::rotation::skew;
use super::section::Section;
use super::skin::Skin;

/// A beam element.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    /// Its two nodes.
    pub nodes: [usize; 2],
    /// Index of its section in the model.
    pub section: usize,
    rest: Rest<2>,
    length_m: f64,
    stiffness: SMatrix<f64, 12, 12>,
    skin: Option<Skin>,
}

/// Freedoms that bend the element out of the wing's plane: displacement of an end along e₃, its turn about e₂, then those of the other.
const FLAP: [usize; 4] = [2, 4, 8, 10];

impl Beam {
    /// Between two nodes (m), with e₃ as near as possible to `normal`.
    ///
    /// # Errors
    /// If the nodes coincide or the normal runs along the beam.
    pub fn new(
        nodes: [usize; 2],
        ends: [Vector3<f64>; 2],
        normal: &Vector3<f64>,
        section_index: usize,
        section: &Section,
    ) -> Result<Self, StructureError> {
        let along = ends[1] - ends[0];
        let length_m = along.norm();
        let e2 = normal.cross(&along);
        if !(length_m > 0.0 && e2.norm() > 1e-9 * length_m * normal.norm()) {
            return Err(StructureError::DegenerateBeam { nodes });
        }
        let (e1, e2) = (along / length_m, e2.normalize());
        let axes = Matrix3::from_columns(&[e1, e2, e1.cross(&e2)]);
        let stiffness = local_stiffness(&section.compliance, length_m)
            .ok_or(StructureError::SectionNotPositive { lowest: 0.0 })?;
        Ok(Beam {
            nodes,
            section: section_index,
            rest: Rest::new(ends, axes),
            length_m,
            stiffness,
            skin: section.skin,
        })
    }

    /// Length at rest, m.
    pub fn length_m(&self) -> f64 {
        self.length_m
    }

    /// Axes at rest as columns, wing frame.
    pub fn axes(&self) -> &Matrix3<f64> {
        &self.rest.axes
    }

    /// Axes of the deformed element as columns, wing frame.
    pub fn deformed_axes(&self, u: &[Vector3<f64>; 2], q: &[UnitQuaternion<f64>; 2]) -> Matrix3<f64> {
        self.frame(u, q).axes
    }

    /// Energy, force and tangent in the deformed shape; the tangent at the local freedoms `guess` if there are any.
    /// `twist_rad`: the twist from end to end at which the element is without torque.
    pub fn response(
        &self,
        u: &[Vector3<f64>; 2],
        q: &[UnitQuaternion<f64>; 2],
        twist_rad: f64,
        guess: Option<&SVector<f64, 12>>,
    ) -> Response<12> {
        let frame = self.frame(u, q);
        let p = frame.local_freedoms(&self.rest, u, q);
        let about = guess.unwrap_or(&p);
        let mut response = self.local(&untwisted(about, twist_rad));
        frame.carry(about).response(&mut response);
        if guess.is_some() {
            let Response { energy, force, .. } = self.local(&untwisted(&p, twist_rad));
            response.energy = energy;
            response.force = frame.carry(&p).force(&force);
        }
        response
    }

    /// Local freedoms after a step from a shape, to first order.
    pub fn guess(
        &self,
        u: &[Vector3<f64>; 2],
        q: &[UnitQuaternion<f64>; 2],
        step: &SVector<f64, 12>,
    ) -> SVector<f64, 12> {
        let frame = self.frame(u, q);
        let p = frame.local_freedoms(&self.rest, u, q);
        p + frame.local_change(&p, step)
    }

    /// Energy and force only.
    pub fn force(
        &self,
        u: &[Vector3<f64>; 2],
        q: &[UnitQuaternion<f64>; 2],
        twist_rad: f64,
    ) -> (f64, SVector<f64, 12>) {
        let frame = self.frame(u, q);
        let p = frame.local_freedoms(&self.rest, u, q);
        let strained = untwisted(&p, twist_rad);
        let Response { energy, force, .. } = self.local(&strained);
        (energy, frame.carry(&p).force(&force))
    }

    /// Section forces at the middle without those of a skin: N, V_edge, V_flap (N), T, M_flap, M_edge (N·m), deformed axes.
    pub fn section_forces(
        &self,
        u: &[Vector3<f64>; 2],
        q: &[UnitQuaternion<f64>; 2],
        twist_rad: f64,
    ) -> [f64; 6] {
        let frame = self.frame(u, q);
        let p = frame.local_freedoms(&self.rest, u, q);
        let f = self.stiffness * untwisted(&p, twist_rad);
        let mean = |i: usize| 0.5 * (f[6 + i] - f[i]);
        std::array::from_fn(mean)
    }

    /// The same to first order about the rest, for linear kinematics.
    pub fn section_forces_linear(
        &self,
        u: &[Vector3<f64>; 2],
        q: &[UnitQuaternion<f64>; 2],
        twist_rad: f64,
    ) -> [f64; 6] {
        let mut p = SVector::<f64, 12>::zeros();
        for i in 0..2 {
            p.fixed_rows_mut::<3>(6 * i)
                .copy_from(&(self.rest.axes.transpose() * u[i]));
            p.fixed_rows_mut::<3>(6 * i + 3)
                .copy_from(&(self.rest.axes.transpose() * q[i].scaled_axis()));
        }
        let f = self.stiffness * untwisted(&p, twist_rad);
        std::array::from_fn(|i| 0.5 * (f[6 + i] - f[i]))
    }

    fn local(&self, p: &SVector<f64, 12>) -> Response<12> {
        let force = self.stiffness * p;
        let mut response = Response {
            energy: 0.5 * p.dot(&force),
            force,
            stiffness: self.stiffness,
        };
        if let Some(skin) = &self.skin {
            self.add_skin(skin, p, &mut response);
        }
        response
    }

    /// A skin bends with the cubic that its ends make of the element; taken at two points of Gauss.
    fn add_skin(&self, skin: &Skin, p: &SVector<f64, 12>, response: &mut Response<12>) {
        for sign in [-1.0, 1.0] {
            let x = 0.5 + sign / 12.0_f64.sqrt();
            let across = (12.0 * x - 6.0) / self.length_m;
            let bends = [-across, 6.0 * x - 4.0, across, 6.0 * x - 2.0].map(|b| b / self.length_m);
            let bending: f64 = FLAP.iter().zip(bends).map(|(&at, b)| b * p[at]).sum();
            let [energy, moment, tangent] = skin.response(bending).map(|part| 0.5 * self.length_m * part);
            response.energy += energy;
            for (&i, a) in FLAP.iter().zip(bends) {
                response.force[i] += a * moment;
                for (&j, b) in FLAP.iter().zip(bends) {
                    response.stiffness[(i, j)] += a * b * tangent;
                }
            }
        }
    }

    fn frame(&self, u: &[Vector3<f64>; 2], q: &[UnitQuaternion<f64>; 2]) -> Frame<2, 12> {
        let x = self.rest.deformed(u);
        let chord = x[1] - x[0];
        let length = chord.norm();
        let e1 = chord / length;
        let e2_rest: Vector3<f64> = self.rest.axes.column(1).into();
        let arms = q.map(|q| q * e2_rest);
        let mean = 0.5 * (arms[0] + arms[1]);
        let e3 = e1.cross(&mean).normalize();
        let axes = Matrix3::from_columns(&[e1, e3.cross(&e1), e3]);
        let to_frame = axes.transpose();
        let mean = to_frame * mean;
        let eta = mean.x / mean.y;
        let mut spin = SMatrix::<f64, 3, 12>::zeros();
        for (node, sign) in [(0, 1.0), (1, -1.0)] {
            let arm = to_frame * arms[node];
            let at = 6 * node;
            spin[(0, at + 2)] = sign * eta / length;
            spin[(0, at + 3)] = 0.5 * arm.y / mean.y;
            spin[(0, at + 4)] = -0.5 * arm.x / mean.y;
            spin[(1, at + 2)] = sign / length;
            spin[(2, at + 1)] = -sign / length;
        }
        Frame {
            axes,
            position: x.map(|x| to_frame * x),
            spin,
        }
    }
}

/// Local freedoms less a twist from end to end.
fn untwisted(p: &SVector<f64, 12>, twist_rad: f64) -> SVector<f64, 12> {
    let mut strained = *p;
    strained[3] += 0.5 * twist_rad;
    strained[9] -= 0.5 * twist_rad;
    strained
}

/// Stiffness of a straight prismatic beam along e₁ for (u₁, θ₁, u₂, θ₂), from the section's compliance.
fn local_stiffness(compliance: &Matrix6<f64>, length: f64) -> Option<SMatrix<f64, 12, 12>> {
    // section forces at distance x from node 1 due to force n and moment m at node 2
    let section_forces = |x: f64| {
        let mut b = Matrix6::identity();
        b.fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&skew(&Vector3::new(length - x, 0.0, 0.0)));
        b
    };
    let mut flexibility = Matrix6::zeros();
    for sign in [-1.0, 1.0] {
        let b = section_forces(0.5 * length * (1.0 + sign / 3.0_f64.sqrt()));
        flexibility += 0.5 * length * b.transpose() * compliance * b;
    }
    let inverse = flexibility.try_inverse()?;
    let mut relative = SMatrix::<f64, 6, 12>::zeros();
    relative
        .fixed_view_mut::<6, 6>(0, 6)
        .copy_from(&Matrix6::identity());
    relative
        .fixed_view_mut::<6, 6>(0, 0)
        .copy_from(&-Matrix6::identity());
    relative
        .fixed_view_mut::<3, 3>(0, 3)
        .copy_from(&skew(&Vector3::new(length, 0.0, 0.0)));
    let k = relative.transpose() * inverse * relative;
    Some(0.5 * (k + k.transpose()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stiffness_of_a_slender_beam_is_euler_bernoulli() {
        let section = Section::uncoupled(2.0, 3.0, 5.0, 7.0);
        let l = 0.5;
        let k = local_stiffness(&section.compliance, l).unwrap();
        assert!((k[(0, 0)] - 2.0 / l).abs() < 1e-9);
        assert!((k[(3, 3)] - 3.0 / l).abs() < 1e-9);
        assert!((k[(8, 8)] - 12.0 * 5.0 / l.powi(3)).abs() < 1e-9, "flap");
        assert!((k[(7, 7)] - 12.0 * 7.0 / l.powi(3)).abs() < 1e-9, "edge");
        assert!((k[(10, 10)] - 4.0 * 5.0 / l).abs() < 1e-9);
        assert!((k[(4, 10)] - 2.0 * 5.0 / l).abs() < 1e-9);
    }

    #[test]
    fn coupled_section_has_a_coupled_element() {
        let mut c = Section::uncoupled(2.0, 3.0, 5.0, 7.0).compliance;
        c[(3, 4)] = 0.05;
        c[(4, 3)] = 0.05;
        // tip moment M about e2 turns the tip about e1 by c34 M L
        let l = 0.8;
        let k = local_stiffness(&c, l).unwrap();
        let k22 = k.fixed_view::<6, 6>(6, 6).into_owned();
        let tip = k22.try_inverse().unwrap()
            * SVector::<f64, 6>::from_column_slice(&[0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        assert!((tip[3] - 0.05 * l).abs() < 1e-12);
        assert!((tip[4] - l / 5.0).abs() < 1e-12);
    }

    /// A beam with a coupled section and a skin that gives way, and ends turned by a large rotation and somewhat bent, stretched and
    /// twisted.
    fn bent(size: f64) -> (Beam, [Vector3<f64>; 2], [UnitQuaternion<f64>; 2]) {
        let mut section = Section::uncoupled(2e3, 0.3, 0.5, 0.7);
        section.compliance[(3, 4)] = 0.6;
        section.compliance[(4, 3)] = 0.6;
        section.skin = Some(Skin {
            flap_n_m2: 0.4,
            gives_way_per_m: 0.3,
            kept: 0.2,
        });
        let ends = [Vector3::new(0.1, 0.2, -0.1), Vector3::new(0.4, 0.1, 0.3)];
        let beam = Beam::new([0, 1], ends, &Vector3::z(), 0, &section).unwrap();
        let turn = UnitQuaternion::new(Vector3::new(0.9, -1.3, 0.5));
        let wobble = |k: f64| Vector3::new((1.7 * k).sin(), (2.3 * k).cos(), (0.9 * k).sin());
        let at = |k: usize| turn * (ends[k] + 1e-4 * size * wobble(k as f64)) - ends[k];
        let spin = |k: usize| turn * UnitQuaternion::new(0.1 * size * wobble(k as f64 + 3.0));
        (beam, [at(0), at(1)], [spin(0), spin(1)])
    }

    fn nudged(
        u: &[Vector3<f64>; 2],
        q: &[UnitQuaternion<f64>; 2],
        freedom: usize,
        h: f64,
    ) -> ([Vector3<f64>; 2], [UnitQuaternion<f64>; 2]) {
        let (mut u, mut q) = (*u, *q);
        let (node, part) = (freedom / 6, freedom % 6);
        if part < 3 {
            u[node][part] += h;
        } else {
            q[node] = UnitQuaternion::new(Vector3::ith(part - 3, h)) * q[node];
        }
        (u, q)
    }

    #[test]
    fn force_is_the_gradient_of_the_energy() {
        let (beam, u, q) = bent(1.0);
        let (_, force) = beam.force(&u, &q, 0.3);
        for k in 0..12 {
            let energy = |h: f64| {
                let (u, q) = nudged(&u, &q, k, h);
                beam.force(&u, &q, 0.3).0
            };
            let h = 1e-6;
            let slope = (energy(h) - energy(-h)) / (2.0 * h);
            assert!(
                (slope - force[k]).abs() < 1e-6 * force.norm(),
                "{k}: {slope} {}",
                force[k]
            );
        }
    }

    #[test]
    fn tangent_agrees_with_differences_to_the_square_of_the_local_deformation() {
        // left out is the turning of the frame's spin map under the moment by which local forces miss the deformed
        // equilibrium, which is of second order; spins do not commute: moments leave S(m)/2, which the loads cancel
        let error = |size: f64| {
            let (beam, u, q) = bent(size);
            let here = beam.response(&u, &q, 0.0, None);
            let mut difference = SMatrix::<f64, 12, 12>::zeros();
            let h = 1e-6;
            for k in 0..12 {
                let force = |h: f64| {
                    let (u, q) = nudged(&u, &q, k, h);
                    beam.force(&u, &q, 0.0).1
                };
                difference.set_column(k, &((force(h) - force(-h)) / (2.0 * h)));
            }
            for node in 0..2 {
                let moment: Vector3<f64> = here.force.fixed_rows::<3>(6 * node + 3).into();
                let at = 6 * node + 3;
                let mut block = difference.fixed_view_mut::<3, 3>(at, at);
                block += 0.5 * skew(&moment);
            }
            (difference - here.stiffness).norm() / here.stiffness.norm()
        };
        let errors = [1.0, 0.1, 0.01].map(error);
        println!("tangent of a beam: {errors:?}");
        assert!(
            errors[0] < 1e-3 && errors[1] < 1e-5 && errors[2] < 1e-7,
            "{errors:?}"
        );
    }
}
