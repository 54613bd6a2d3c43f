//! Motions of a flapping wing by freedom, and the masses that resist them.

use std::sync::Arc;

use super::air_resistance::AirResistance;
use super::error::CouplingError;
use super::feedback::{EXACT, Feedback};
use super::harmonic_balance::Oscillators;
use super::recycled::Recycled;
use super::solution::Solution;
use super::stroke::{Stroke, standing_path};
use super::wing::Wing;
use crate::effects::NodeLoad;
use crate::structure::pattern::Pattern;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Mode, mass_matrix};
use nalgebra::{DVector, Vector3};

/// Motions by freedom, and the masses that resist them.
#[derive(Debug, Clone)]
pub struct Fields {
    pub pattern: Arc<Pattern>,
    pub nodes: usize,
    /// Mass of the wing alone, and with the air that it moves.
    pub mass: [Vec<f64>; 2],
    /// Displacement at mid-stroke, and its rate with the pressure less that.
    pub standing: [Vec<f64>; 2],
    pub modes: Vec<Vec<f64>>,
    /// Sweep and pitch of the rod by unit angles.
    pub sweep: Vec<f64>,
    pub pitch: Vec<f64>,
}

impl Fields {
    pub fn new(
        wing: &Wing,
        equilibrium: &mut Equilibrium,
        still: &Solution,
        about: &State,
        air: &[f64],
        modes: &[Mode],
    ) -> Result<Fields, CouplingError> {
        let pattern = equilibrium.pattern.clone();
        let by_freedom = |part: &dyn Fn(usize) -> [Vector3<f64>; 2]| {
            let mut field = vec![0.0; pattern.len()];
            for node in 0..wing.model.nodes.len() {
                let [moved, turned] = part(node);
                let at = pattern.freedom(node, 0);
                field[at..at + 3].copy_from_slice(moved.as_slice());
                field[at + 3..at + 6].copy_from_slice(turned.as_slice());
            }
            field
        };
        let shape = by_freedom(&|node| {
            let turned = still.state.rotation[node] * still.rest.rotation[node].inverse();
            [
                still.state.displacement[node] - still.rest.displacement[node],
                turned.scaled_axis(),
            ]
        });
        let force = by_freedom(&|node| [Vector3::from(still.air_force_n[node]), Vector3::zeros()]);
        let shapes = wing.strips.shapes(&still.state);
        let rate = Feedback::new(wing, equilibrium, &shapes)?
            .solve(&force, EXACT, &mut Recycled::new())
            .ok_or(CouplingError::NoPeriodic {
                reason: "the wing stands at its divergence",
            })?;
        let offset_m = match wing.air.as_ref().map(|air| air.flow) {
            Some(crate::aero::Flow::Flapping { root_offset_m, .. }) => root_offset_m,
            _ => 0.0,
        };
        let place = |node: usize| wing.model.nodes[node] + about.displacement[node];
        let masses = [&[][..], air].map(|air| mass_matrix(&wing.model, &pattern, about, air));
        Ok(Fields {
            standing: [
                shape.clone(),
                rate.iter()
                    .zip(&shape)
                    .map(|(rate, shape)| rate - shape)
                    .collect(),
            ],
            modes: modes
                .iter()
                .map(|mode| by_freedom(&|node| [mode.displacement[node], mode.rotation[node]]))
                .collect(),
            sweep: by_freedom(&|node| [Vector3::z() * (place(node).x + offset_m), -Vector3::y()]),
            pitch: by_freedom(&|node| [Vector3::z() * place(node).y, Vector3::x()]),
            mass: masses,
            nodes: wing.model.nodes.len(),
            pattern,
        })
    }

    /// Force on the modes at a phase, by what moves besides themselves: inertia, and damping by air and structure.
    pub fn driving(
        &self,
        stroke: &Stroke,
        system: &Oscillators,
        air: &AirResistance,
    ) -> impl Fn(f64) -> DVector<f64> + use<> {
        let share = |field: &[f64]| {
            let momentum = self.pattern.multiply(&self.mass[1], field);
            let on = |mode: &Vec<f64>| mode.iter().zip(&momentum).map(|(a, b)| a * b).sum::<f64>();
            DVector::from_iterator(self.modes.len(), self.modes.iter().map(on))
        };
        let still = [0, 1].map(|k| share(&self.standing[k]));
        let (sweep, pitch) = (share(&self.sweep), share(&self.pitch));
        let in_air = |field: &[f64]| air.on_modes(&self.displacement(field));
        let still_in_air = [0, 1].map(|k| in_air(&self.standing[k]));
        let pitch_in_air = in_air(&self.pitch);
        let own = system.damping.clone();
        let (stroke, rate) = (*stroke, stroke.rate_rad_s);
        move |phase: f64| {
            let path = standing_path(phase);
            let [_, turning, jerking] = stroke.pitch(phase);
            let mut force = -(&sweep * stroke.sweep_acceleration(phase) + &pitch * (rate * rate * jerking));
            force -= &pitch_in_air * (rate * turning * phase.cos().abs());
            for k in 0..2 {
                force -= &still[k] * (rate * rate * path[k][2]);
                force -= &own * &still[k] * (rate * path[k][1]);
                force -= &still_in_air[k] * (rate * path[k][1] * phase.cos().abs());
            }
            force
        }
    }

    /// Forces and moments by which a mass resists an acceleration, both by freedom.
    pub fn inertia(&self, mass: &[f64], acceleration: &[f64]) -> Vec<NodeLoad> {
        let momentum = self.pattern.multiply(mass, acceleration);
        let part = |at: usize| -Vector3::from_column_slice(&momentum[at..at + 3]);
        let load = |at: usize| NodeLoad {
            force_n: part(at),
            moment_n_m: part(at + 3),
        };
        (0..self.nodes)
            .map(|node| load(self.pattern.freedom(node, 0)))
            .collect()
    }

    /// The displacements of a motion by freedom.
    pub fn displacement(&self, field: &[f64]) -> Vec<Vector3<f64>> {
        let at = |node: usize| self.pattern.freedom(node, 0);
        (0..self.nodes)
            .map(|node| Vector3::from_column_slice(&field[at(node)..at(node) + 3]))
            .collect()
    }
}
