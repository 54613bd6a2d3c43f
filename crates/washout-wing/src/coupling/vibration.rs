//! Natural modes of a wing about its unloaded or its loaded shape, in a vacuum or with the air that it moves.

use nalgebra::Vector3;

use super::CouplingError;
use super::build::{built, large_share};
use super::cure::cured;
use super::motion::motion_needed;
use super::solution::Solution;
use super::wing::Wing;
use crate::effects::bind;
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Model, Vibration, lowest_modes};

/// A wing in equilibrium, about which it vibrates.
#[derive(Debug, Clone)]
pub struct Standing {
    /// The structure.
    pub model: Model,
    /// Its shape.
    pub state: State,
    /// The loads that hold it there; they keep still while it vibrates.
    pub loads: Loads,
    /// Mass of the air that moves with each triangle along its normal, kg/m²; empty in a vacuum.
    pub moved_air_kg_m2: Vec<f64>,
}

impl Standing {
    /// The wing without any load, after cure.
    ///
    /// # Errors
    /// If design and mesh do not belong together, or the cured shape is not found.
    pub fn unloaded(
        design: &Design,
        mesh: &Mesh,
        air_table: Option<&[[f64; 3]]>,
        progress: &Progress,
    ) -> Result<Self, CouplingError> {
        let motion = motion_needed(design, mesh, air_table, None, progress)?;
        let wing = Wing::with_motion(design, mesh, air_table, motion)?;
        let (state, _) = cured(&wing.model, &mut wing.equilibrium()?, progress)?;
        let loads = Loads::none(mesh.nodes.len());
        Ok(Standing {
            model: wing.model,
            state,
            loads,
            moved_air_kg_m2: Vec::new(),
        })
    }

    /// The wing under its air and bench loads. In linear kinematics loads do not stiffen: it vibrates as at rest.
    ///
    /// # Errors
    /// If design and mesh do not belong together.
    pub fn loaded(design: &Design, solution: &Solution) -> Result<Self, CouplingError> {
        let effects = bind(design)?;
        let (model, bench) = built(design, &solution.mesh, &effects, None, None)?;
        let nodes = model.nodes.len();
        let (mut state, mut loads) = (State::at_rest(nodes), Loads::none(nodes));
        if large_share(design, &effects)? > 0.0 {
            state = solution.state.clone();
            loads = bench;
            for (load, air) in loads.force_n.iter_mut().zip(&solution.air_force_n) {
                *load += Vector3::from(*air);
            }
        }
        Ok(Standing {
            model,
            state,
            loads,
            moved_air_kg_m2: Vec::new(),
        })
    }

    /// The same wing with the air that moves with its film: ρ π/4 c per area, spread evenly over the chord (that of a
    /// plate that moves across; Ellington 1984, part II).
    #[must_use]
    pub fn with_air(mut self, design: &Design, planform: &Planform) -> Self {
        let per_chord = design.air.density_kg_m3.value() * std::f64::consts::FRAC_PI_4;
        let nodes = &self.model.nodes;
        let middle = |corners: [usize; 3]| corners.iter().map(|&n| nodes[n].x).sum::<f64>() / 3.0;
        let shells = self.model.shells.iter();
        self.moved_air_kg_m2 = shells
            .map(|shell| per_chord * planform.chord_m(middle(shell.nodes)))
            .collect();
        self
    }

    /// Its lowest `count` modes.
    ///
    /// # Errors
    /// If they are not found, or the user asks to stop.
    pub fn modes(&self, count: usize, progress: &Progress) -> Result<Vibration, CouplingError> {
        let mut equilibrium = Equilibrium::new(&self.model)?;
        let air = &self.moved_air_kg_m2;
        let found = lowest_modes(&mut equilibrium, &self.state, &self.loads, air, count, progress)?;
        Ok(found)
    }
}
