//! What the air does against motions of the wing: the quasi-steady law, linear about one shape and speed.

use nalgebra::{DVector, Matrix3, Vector3};
use num_dual::DualSVec64;

use super::error::CouplingError;
use super::strips::Strip;
use super::wing::Wing;
use crate::aero::strip_force;
use crate::structure::Mode;
use crate::structure::state::State;

/// Resistance of the air at mid-stroke to motions of the wing. A strip feels the motion of its point at ¾ of the chord
/// (Pistolesi's rule).
#[derive(Debug)]
pub struct AirResistance<'a> {
    wing: &'a Wing,
    modes: &'a [Mode],
    /// Change of each strip's force with the velocity, N s/m, and the shares of its points.
    strips: Vec<(Matrix3<f64>, Vec<f64>)>,
}

impl<'a> AirResistance<'a> {
    /// In a shape; `share` of the law's.
    ///
    /// # Errors
    /// If the air's force is not finite.
    pub fn new(wing: &'a Wing, state: &State, modes: &'a [Mode], share: f64) -> Result<Self, CouplingError> {
        let shapes = wing.strips.shapes(state);
        let air = wing.strip_air(&shapes, false)?;
        let strips = wing.strips.strips.iter().zip(air).zip(shapes.chunks_exact(6));
        Ok(AirResistance {
            wing,
            modes,
            strips: strips
                .map(|((strip, air), shape)| {
                    (
                        force_by_velocity(wing, strip, shape) * (strip.width_m * share),
                        air.weights,
                    )
                })
                .collect(),
        })
    }

    /// Force against the modes when the nodes move at these velocities, m/s.
    pub fn on_modes(&self, velocity: &[Vector3<f64>]) -> DVector<f64> {
        let mut sum = DVector::zeros(self.modes.len());
        for (strip, (by_velocity, weights)) in self.wing.strips.strips.iter().zip(&self.strips) {
            let moved = |field: &[Vector3<f64>], point: usize| {
                let point = &strip.points[point];
                point.weights[0] * field[point.nodes[0]] + point.weights[1] * field[point.nodes[1]]
            };
            let last = strip.points.len() - 1;
            let force = by_velocity * (moved(velocity, 0) * 0.25 + moved(velocity, last) * 0.75);
            for (sum, mode) in sum.iter_mut().zip(self.modes) {
                let mean = (0..=last).map(|k| moved(&mode.displacement, k) * weights[k]);
                *sum += mean.sum::<Vector3<f64>>().dot(&force);
            }
        }
        sum
    }
}

/// Change of a strip's force per length with the velocity of the air, N s/m².
fn force_by_velocity(wing: &Wing, strip: &Strip, shape: &[f64]) -> Matrix3<f64> {
    type Velocity = DualSVec64<3>;
    let Some(air) = &wing.air else {
        return Matrix3::zeros();
    };
    let stream = air.flow.velocity(strip.r_m);
    let velocity = Vector3::from_fn(|i, _| Velocity::from_re(stream[i]).derivative(i));
    let fixed = |at: usize| Vector3::from_fn(|i, _| Velocity::from_re(shape[at + i]));
    let force = strip_force(&air.law, &velocity, &fixed(0), &fixed(3), strip.chord_m, &());
    Matrix3::from_fn(|i, j| {
        let by = force.force_n_per_m[i].eps;
        by.unwrap_generic(nalgebra::Const::<3>, nalgebra::Const::<1>)[j]
    })
}
