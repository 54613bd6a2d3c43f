//! A wing in its air: the coupled equations F(u) = internal force − bench loads − air load(shape of u).

use std::sync::Arc;

use nalgebra::Vector3;

use super::air::Air;
use super::build::{built, large_share};
use super::error::CouplingError;
use super::finite::refuse_air;
use super::solution::StripLoad;
use super::strip_air::StripAir;
use super::strips::{StripShape, Strips};
use crate::aero::pressure_density;
use crate::effects::{Bound, Motion, Need, Seam, bind};
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::structure::state::State;
use crate::structure::{Beam, Compression, Equilibrium, Loads, Model, SharedAnalysis, Shell, StructureError};

/// The structure, the strips and the air of a design, with the laws by which they act on each other.
#[derive(Debug, Clone)]
pub struct Wing {
    /// The structure.
    pub model: Model,
    /// The strips of air.
    pub strips: Strips,
    /// Bench loads and gravity.
    pub bench: Loads,
    /// The air, if there is any.
    pub air: Option<Air>,
    /// Small rotations about the wing at rest, and nothing else.
    pub linear: bool,
    /// What the stroke does at the phase of the design, if an effect needs it; frozen.
    pub motion: Option<Arc<Motion>>,
    /// Analysis of the structure, shared with the wings beside.
    analysis: SharedAnalysis,
}

/// Whether an effect is made from the motion over the stroke.
pub(super) fn needs_motion(bound: &Bound) -> bool {
    bound.effect.card().needs.contains(&Need::Motion)
}

impl Wing {
    /// The wing of a design on a mesh, none of whose effects is made from its motion over the stroke.
    ///
    /// # Errors
    /// If design and mesh do not belong together, the air's laws cannot be set up, a number of the structure, of a load or of a
    /// formula is not finite, or an effect needs the motion.
    pub fn new(design: &Design, mesh: &Mesh, air_table: Option<&[[f64; 3]]>) -> Result<Self, CouplingError> {
        Wing::with_motion(design, mesh, air_table, None)
    }

    /// The same with the motion over the stroke, for the effects that are made from it.
    ///
    /// # Errors
    /// As [`Wing::new`].
    pub fn with_motion(
        design: &Design,
        mesh: &Mesh,
        air_table: Option<&[[f64; 3]]>,
        motion: Option<Arc<Motion>>,
    ) -> Result<Self, CouplingError> {
        Wing::made(design, mesh, air_table, motion, None)
    }

    /// The wing of another design on the same mesh: what both share is taken over. `seam`: where they differ, if that is by
    /// the numbers of one effect; `motion`: that over the stroke.
    ///
    /// # Errors
    /// As [`Wing::new`].
    pub fn beside(
        &self,
        design: &Design,
        mesh: &Mesh,
        air_table: Option<&[[f64; 3]]>,
        seam: Option<Seam>,
        motion: Option<Arc<Motion>>,
    ) -> Result<Self, CouplingError> {
        Wing::made(design, mesh, air_table, motion, Some((self, seam)))
    }

    fn made(
        design: &Design,
        mesh: &Mesh,
        air_table: Option<&[[f64; 3]]>,
        known: Option<Arc<Motion>>,
        beside: Option<(&Wing, Option<Seam>)>,
    ) -> Result<Self, CouplingError> {
        let effects = bind(design)?;
        let motion = match effects.iter().find(|bound| needs_motion(bound)) {
            None => None,
            Some(bound) => Some(known.ok_or_else(|| CouplingError::NeedsMotion {
                effect: bound.effect.card().name.to_string(),
            })?),
        };
        let (model, bench) = match beside {
            Some((wing, Some(Seam::Air | Seam::Picture))) => (wing.model.clone(), wing.bench.clone()),
            _ => {
                let known = beside.map(|(wing, _)| &wing.model);
                built(design, mesh, &effects, motion.as_deref(), known)?
            }
        };
        let mut strips = match beside {
            Some((wing, _)) if wing.air.is_some() => wing.strips.clone(),
            _ => Strips::new(mesh),
        };
        let large_share = large_share(design, &effects)?;
        let air = Air::new(design, &strips, &effects, large_share, air_table)?;
        let air = air.map(|air| air.with_motion(motion.clone()));
        match &air {
            Some(air) => air.try_out(&strips)?,
            None => strips = Strips::default(),
        }
        Ok(Wing {
            model,
            strips,
            bench,
            air,
            linear: large_share == 0.0,
            motion,
            analysis: beside.map(|(wing, _)| wing.analysis.clone()).unwrap_or_default(),
        })
    }

    /// The structure, ready to be solved.
    ///
    /// # Errors
    /// If it cannot be analysed.
    pub fn equilibrium(&self) -> Result<Equilibrium<'_>, StructureError> {
        Ok(Equilibrium::analysed(&self.model, self.analysis.of(&self.model)?))
    }

    /// Share of the linear model: 1 alone, between 0 and 1 beside large rotation.
    pub(super) fn linear_share(&self) -> f64 {
        if self.linear {
            return 1.0;
        }
        self.model.blend.as_ref().map_or(0.0, |blend| blend.linear_share)
    }

    /// Whether a film is to carry the air in linear kinematics.
    pub fn has_linear_film(&self) -> bool {
        self.linear && !self.model.sheets.is_empty()
    }

    /// Whether a film carries next to nothing in compression.
    pub fn has_film_that_wrinkles(&self) -> bool {
        let wrinkles =
            |compression| matches!(compression, Compression::TensionField { residual, .. } if residual < 1.0);
        self.model.sheets.iter().any(|sheet| wrinkles(sheet.compression))
    }

    /// Air on each strip in the given shapes (six values a strip).
    ///
    /// # Errors
    /// If a force, or a derivative that is asked for, is not finite.
    pub fn strip_air(&self, shapes: &[f64], derivative: bool) -> Result<Vec<StripAir>, CouplingError> {
        let Some(air) = &self.air else {
            return Ok(Vec::new());
        };
        let strips = self.strips.strips.iter().zip(shapes.chunks_exact(6));
        strips
            .map(|(strip, shape)| {
                let shape = StripShape::from_column_slice(shape);
                let found = if derivative {
                    strip.air_and_derivative(air, &shape)
                } else {
                    strip.air(air, &shape)
                };
                refuse_air(strip, air, &air.flow.velocity(strip.r_m), &shape, &found)?;
                Ok(found)
            })
            .collect()
    }

    /// Forces of the air on the nodes, N.
    pub fn air_force(&self, air: &[StripAir]) -> Vec<Vector3<f64>> {
        let mut force = vec![Vector3::zeros(); self.model.nodes.len()];
        for (strip, air) in self.strips.strips.iter().zip(air) {
            strip.spread(|node, share, point| force[node] += air.on_point_n(point) * share);
        }
        force
    }

    /// Change of the nodal forces with a change of the shapes.
    pub fn air_force_change(&self, air: &[StripAir], shape_change: &[f64]) -> Vec<Vector3<f64>> {
        let mut force = vec![Vector3::zeros(); self.model.nodes.len()];
        for ((strip, air), change) in self
            .strips
            .strips
            .iter()
            .zip(air)
            .zip(shape_change.chunks_exact(6))
        {
            let change = StripShape::from_column_slice(change);
            strip.spread(|node, share, point| force[node] += air.by_shape[point] * change * share);
        }
        force
    }

    /// All loads when the strips have the given shapes.
    ///
    /// # Errors
    /// If the air's are not finite.
    pub fn loads(&self, shapes: &[f64]) -> Result<Loads, CouplingError> {
        let mut loads = self.bench.clone();
        let air = self.air_force(&self.strip_air(shapes, false)?);
        for (load, air) in loads.force_n.iter_mut().zip(air) {
            *load += air;
        }
        Ok(loads)
    }

    /// All loads on a shape: what equilibrium is judged by.
    ///
    /// # Errors
    /// If the air's are not finite.
    pub fn loads_on(&self, state: &State) -> Result<Loads, CouplingError> {
        self.loads(&self.strips.shapes(state))
    }

    /// The strips as a result.
    pub fn strip_loads(&self, air: &[StripAir]) -> Vec<StripLoad> {
        let load = |(strip, air): (&super::strips::Strip, &StripAir)| StripLoad {
            r_m: strip.r_m,
            width_m: strip.width_m,
            chord_m: strip.chord_m,
            speed_m_s: air.force.speed,
            alpha_rad: air.force.alpha,
            cl: air.force.cl,
            cd: air.force.cd,
            centre_of_pressure: air.force.centre_of_pressure,
            normal_n_per_m: air.force.normal_n_per_m,
            tangential_n_per_m: air.force.tangential_n_per_m,
        };
        self.strips.strips.iter().zip(air).map(load).collect()
    }

    /// Normal pressure on each triangle (Pa) by the law that the strips spread their force with.
    pub fn pressure(&self, mesh: &Mesh, air: &[StripAir]) -> Vec<f64> {
        let strips = &self.strips.strips;
        let at = |triangle: &[usize; 3]| {
            let centre = triangle
                .iter()
                .map(|&n| Vector3::from(mesh.nodes[n]))
                .sum::<Vector3<f64>>()
                / 3.0;
            let after = strips.partition_point(|s| s.r_m < centre.x).min(strips.len() - 1);
            let before = after.saturating_sub(1);
            let is_before = centre.x - strips[before].r_m < strips[after].r_m - centre.x;
            let near = if is_before { before } else { after };
            let (strip, air) = (&strips[near], &air[near]);
            let first = strip.points.first().map_or(0.0, |p| p.y_m);
            let eta = ((centre.y - first) / strip.chord_m).clamp(0.0, 1.0);
            let mean = air.force.normal_n_per_m / strip.chord_m;
            mean * pressure_density(air.force.centre_of_pressure, eta)
        };
        if strips.is_empty() || air.is_empty() {
            return vec![0.0; mesh.triangles.len()];
        }
        mesh.triangles.iter().map(at).collect()
    }

    /// Section forces of every beam at its middle: N, V_edge, V_flap (N), T, M_flap, M_edge (N·m).
    pub fn beam_forces(&self, rest: &State, state: &State) -> Vec<[f64; 6]> {
        let share = self.linear_share();
        let force = |(index, beam): (usize, &Beam)| {
            let (u, q) = self.model.beam_state(beam, state);
            let twist_rad = self.bench.twist_rad(index);
            let large = beam.section_forces(&u, &q, twist_rad);
            if share == 0.0 {
                return large;
            }
            let (u0, q0) = self.model.beam_state(beam, rest);
            let moved = [u[0] - u0[0], u[1] - u0[1]];
            let turned = [q[0] / q0[0], q[1] / q0[1]];
            let before = beam.section_forces(&u0, &q0, 0.0);
            let more = beam.section_forces_linear(&moved, &turned, twist_rad);
            std::array::from_fn(|i| mixed(share, before[i] + more[i], large[i]))
        };
        self.model.beams.iter().enumerate().map(force).collect()
    }

    /// Membrane force of every triangle with x along the projection of the span: N_x, N_y, N_xy (N/m).
    pub fn membrane_forces(&self, rest: &State, state: &State) -> Vec<[f64; 3]> {
        let share = self.linear_share();
        let force = |shell: &Shell| {
            let sheet = &self.model.sheets[shell.sheet];
            let (u, q) = self.model.shell_state(shell, state);
            let large = shell.membrane_force(sheet, &u, &q, &Vector3::x());
            if share == 0.0 {
                return large;
            }
            let (u0, q0) = self.model.shell_state(shell, rest);
            let before = shell.membrane_force(sheet, &u0, &q0, &Vector3::x());
            let moved = std::array::from_fn(|i| u[i] - u0[i]);
            let more = shell.membrane_force_linear(sheet, &moved, &Vector3::x());
            std::array::from_fn(|i| mixed(share, before[i] + more[i], large[i]))
        };
        self.model.shells.iter().map(force).collect()
    }

    /// Force (N) and moment about the wing base (N·m) by which the supports hold the wing: they balance the loads.
    pub fn reaction(
        &self,
        equilibrium: &Equilibrium,
        state: &State,
        loads: &Loads,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let place = |node: usize| {
            let moved = if self.linear {
                Vector3::zeros()
            } else {
                state.displacement[node]
            };
            self.model.nodes[node] + moved
        };
        let mut force = Vector3::zeros();
        let mut moment = Vector3::zeros();
        if self.linear {
            for (node, (f, m)) in loads.force_n.iter().zip(&loads.moment_n_m).enumerate() {
                force -= f;
                moment -= place(node).cross(f) + m;
            }
            for arm in &loads.arms {
                force -= arm.force_n;
                moment -= (place(arm.node) + arm.arm_m).cross(&arm.force_n);
            }
            return (force, moment);
        }
        let residual = self.model.residual(&equilibrium.pattern, state, loads);
        for (node, held) in self.model.held.iter().enumerate() {
            let at = equilibrium.pattern.freedom(node, 0);
            let held_part = |k: usize| if held[k] { residual[at + k] } else { 0.0 };
            let f = Vector3::from_fn(|k, _| held_part(k));
            let m = Vector3::from_fn(|k, _| held_part(3 + k));
            force += f;
            moment += place(node).cross(&f) + m;
        }
        (force, moment)
    }
}

/// A linear answer and that of large rotation, mixed; either alone where its share is all.
fn mixed(linear_share: f64, linear: f64, large: f64) -> f64 {
    if linear_share == 1.0 {
        return linear;
    }
    linear_share * linear + (1.0 - linear_share) * large
}
