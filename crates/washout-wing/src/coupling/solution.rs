//! What a coupled solve gives: shape, strips, forces and how well the equations are met.

use super::error::CouplingError;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::structure::state::State;

/// A converged coupled solution.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The mesh it was computed on.
    pub mesh: Mesh,
    /// Shape without load, after cure (zero without film pre-tension); twist is measured from it.
    pub rest: State,
    /// Shape under load.
    pub state: State,
    /// Strips of air, from base to tip; empty without flow.
    pub strips: Vec<StripLoad>,
    /// Nodal air forces, N, wing frame at rest.
    pub air_force_n: Vec<[f64; 3]>,
    /// Pressure on each triangle, Pa, positive toward +z of the deformed film.
    pub pressure_pa: Vec<f64>,
    /// Section forces of each beam element at its middle: N, V_edge, V_flap (N), T, M_flap, M_edge (N·m).
    pub beam_force: Vec<[f64; 6]>,
    /// Membrane force of each triangle in its own axes along x and y of the reference: N_x, N_y, N_xy (N/m).
    pub membrane_force_n_per_m: Vec<[f64; 3]>,
    /// How the equations are met and what it took.
    pub report: SolveReport,
}

impl Solution {
    /// Refuses a shape in which the pitch stop of a flapping wing, which only pushes against washout, would have to pull.
    ///
    /// # Errors
    /// If it would.
    pub fn refuse_pull_of_stop(&self, design: &Design) -> Result<(), CouplingError> {
        let has_stop = design.flapping.is_some() && design.root.pitch_stiffness_n_m_per_rad.is_none();
        let moment = self.report.reaction_moment_n_m;
        // next to no load, rounding decides the sign
        let size = moment.iter().map(|part| part * part).sum::<f64>().sqrt();
        match has_stop && moment[0] > 1e-6 * size {
            true => Err(CouplingError::StopPulls {
                moment_n_m: moment[0],
            }),
            false => Ok(()),
        }
    }
}

/// One strip of air on the deformed wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripLoad {
    /// Span position at rest, m.
    pub r_m: f64,
    /// Width, m.
    pub width_m: f64,
    /// Chord, m.
    pub chord_m: f64,
    /// Speed of the air in the plane of the strip, m/s.
    pub speed_m_s: f64,
    /// Angle of attack, rad.
    pub alpha_rad: f64,
    /// Lift and drag coefficient.
    pub cl: f64,
    /// Drag coefficient.
    pub cd: f64,
    /// Centre of pressure, fraction of the chord.
    pub centre_of_pressure: f64,
    /// Normal force per length, N/m.
    pub normal_n_per_m: f64,
    /// Chordwise force per length toward the trailing edge, N/m.
    pub tangential_n_per_m: f64,
}

/// How the equations are met and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct SolveReport {
    /// Coupled residual relative to the applied load; none where there is next to no load, so that rounding is all there is of it.
    pub residual: Option<f64>,
    /// Largest change of twist in the last iteration, deg.
    pub twist_change_deg: f64,
    /// Updates of the air load: Newton steps on air and structure together, or fixed-point iterations.
    pub iterations: usize,
    /// Newton steps of the structure in all.
    pub newton_steps: usize,
    /// Negative pivots of the tangent at the solution; 0: stable branch.
    pub negative_pivots: usize,
    /// Critical dynamic pressure over that of the design; `None`: the air does not drive the wing toward divergence.
    pub critical_pressure_ratio: Option<f64>,
    /// Degrees of freedom that were solved for.
    pub dof: usize,
    /// Force and moment (about the wing base) by which the support holds the wing, N and N·m.
    pub reaction_force_n: [f64; 3],
    /// Moment of the support about the wing base, N·m; its x part is what the stop carries.
    pub reaction_moment_n_m: [f64; 3],
    /// Twist at the strips for each iteration, deg.
    pub twist_history_deg: Vec<Vec<f64>>,
}
