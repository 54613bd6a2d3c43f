//! A spring between a node and the ground.

use nalgebra::{Matrix3, SVector, Vector3};

use super::rotation::{moment_correction, spin_to_vector};
use super::state::State;

/// Spring between a node and the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// The node.
    pub node: usize,
    /// Stiffness against displacement along x, y, z, N/m.
    pub displacement_n_m: [f64; 3],
    /// Stiffness against the rotation vector's x, y, z, N·m/rad.
    pub rotation_n_m_rad: [f64; 3],
    /// How its stiffness against rotation grows with the turn.
    pub stiffening: Stiffening,
}

/// Growth of a stiffness k with the turn θ: M = k θ (1 + a |θ|ᵖ) about each axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffening {
    /// The factor a, rad⁻ᵖ; 0 where nothing grows.
    pub growth: f64,
    /// The power p, above 0.
    pub power: f64,
}

impl Stiffening {
    /// None: the stiffness is the same at any turn.
    pub const NONE: Stiffening = Stiffening {
        growth: 0.0,
        power: 2.0,
    };

    /// What the stiffness has grown by at a turn, as a share of it.
    fn at(&self, turn_rad: f64) -> f64 {
        self.growth * turn_rad.abs().powf(self.power)
    }
}

impl Spring {
    fn stretch(&self, state: &State) -> SVector<f64, 6> {
        let (u, turn) = (
            &state.displacement[self.node],
            state.rotation[self.node].scaled_axis(),
        );
        SVector::from([u.x, u.y, u.z, turn.x, turn.y, turn.z])
    }

    /// Energy, J.
    pub(super) fn energy(&self, state: &State) -> f64 {
        let (stiffness, stretch) = (self.displacement_n_m, self.stretch(state));
        let along = (0..3).map(|axis| stiffness[axis] * stretch[axis].powi(2));
        let about = (0..3).map(|axis| {
            let turn = stretch[3 + axis];
            let grown = 2.0 / (2.0 + self.stiffening.power) * self.stiffening.at(turn);
            self.rotation_n_m_rad[axis] * turn * turn * (1.0 + grown)
        });
        0.5 * (along.sum::<f64>() + about.sum::<f64>())
    }

    /// Force and moment on the node, N and N·m, and their derivatives by its displacement and spin.
    pub(super) fn response(&self, state: &State) -> (SVector<f64, 6>, [Matrix3<f64>; 2]) {
        let stretch = self.stretch(state);
        let theta = Vector3::new(stretch[3], stretch[4], stretch[5]);
        let along = Matrix3::from_diagonal(&Vector3::from(self.displacement_n_m));
        let at_rest = Vector3::from(self.rotation_n_m_rad);
        let grown = theta.map(|turn| self.stiffening.at(turn));
        let slope = grown.map(|own| 1.0 + (1.0 + self.stiffening.power) * own);
        let about = Matrix3::from_diagonal(&at_rest.component_mul(&slope));
        let h = spin_to_vector(&theta);
        let moment = at_rest
            .component_mul(&theta)
            .component_mul(&grown.map(|own| 1.0 + own));
        let correction = moment_correction(&theta, &moment, &h);
        let turned = h.transpose() * moment;
        let force = along * Vector3::new(stretch[0], stretch[1], stretch[2]);
        let stiffness = h.transpose() * about * h + 0.5 * (correction + correction.transpose());
        (
            SVector::from([force.x, force.y, force.z, turned.x, turned.y, turned.z]),
            [along, stiffness],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::UnitQuaternion;

    fn stiffening() -> Spring {
        Spring {
            node: 0,
            displacement_n_m: [2.0, 3.0, 5.0],
            rotation_n_m_rad: [0.7, 0.0, 0.0],
            stiffening: Stiffening {
                growth: 1.5,
                power: 3.4,
            },
        }
    }

    fn turned(by_rad: f64) -> State {
        let mut state = State::at_rest(1);
        state.rotation[0] = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), by_rad);
        state
    }

    #[test]
    fn a_spring_that_stiffens_has_the_moment_of_its_energy_and_the_stiffness_of_its_moment() {
        let (spring, at, step) = (stiffening(), 0.8, 1e-5);
        let slope = |of: &dyn Fn(f64) -> f64| (of(at + step) - of(at - step)) / (2.0 * step);
        let moment = |by: f64| spring.response(&turned(by)).0[3];
        let close =
            |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
        close(moment(at), 0.7 * at * (1.0 + 1.5 * at.powf(3.4)));
        close(moment(-at), -moment(at));
        close(slope(&|by| spring.energy(&turned(by))), moment(at));
        close(slope(&moment), spring.response(&turned(at)).1[1][(0, 0)]);
    }
}
