//! Air and structure together: load and shape transfer, residual, Newton's method, fixed point, sensitivity.

pub mod accelerate;

pub mod air;

pub mod air_resistance;

pub mod balance;

mod beside;

pub mod blade;

pub mod build;

pub mod cure;

mod cure_near;

pub mod difference;

mod fields;

pub mod engineering;

pub mod equilibrium;

pub mod error;

pub mod feedback;

mod finite;

pub mod fixed_point;

pub mod newton;

pub mod harmonic_balance;

pub mod instant;

pub mod mid_stroke;

pub mod motion;

pub mod near;

pub mod periodic;

mod overload;

mod pace;

mod pseudo_time;

pub mod recycled;

pub mod sensitivity;

pub mod solution;

mod strip_path;

pub mod strip_air;

pub mod strips;

pub mod stroke;

pub mod vibration;

pub mod wing;

pub use blade::{BladeAir, BladeSection};
pub use difference::Difference;
pub use engineering::{Engineering, Extreme};
pub use equilibrium::solve_wing;
pub use error::{CouplingError, SensitivityError};
pub use near::{Care, Near};
pub use periodic::{Periodic, PeriodicSettings, periodic};
pub use sensitivity::Sensitivity;

use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::progress::Progress;

use motion::motion_needed;
use solution::Solution;
use wing::Wing;

/// The loaded shape of a wing in its air.
///
/// `air_table`: rows alpha_deg, cl, cd for `air.coefficients = "table"`.
///
/// # Errors
/// If design and mesh do not belong together, the wing has no equilibrium that is found, the pitch stop would have to pull, or a load or
/// a result is not finite.
pub fn solve(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    progress: &Progress,
) -> Result<Solution, CouplingError> {
    solve_from(design, mesh, air_table, None, progress)
}

/// As [`solve`], from the solution of a design nearby on a mesh with the same pattern: the same shape in fewer steps. Without
/// one, or with one on another pattern, it starts from the shape without load.
///
/// # Errors
/// As [`solve`].
pub fn solve_from(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    nearby: Option<&Solution>,
    progress: &Progress,
) -> Result<Solution, CouplingError> {
    let near = nearby.map(|solution| Near {
        solution,
        step: None,
        care: Care::Full,
    });
    solve_near(design, mesh, air_table, near.as_ref(), progress)
}

/// As [`solve_from`], with as much care as is asked for: a trial is given up where Newton's method does not settle.
///
/// # Errors
/// As [`solve`].
pub fn solve_near(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    near: Option<&Near>,
    progress: &Progress,
) -> Result<Solution, CouplingError> {
    progress.check()?;
    let nearby = near.map(|near| near.solution);
    let motion = motion_needed(design, mesh, air_table, nearby, progress)?;
    let wing = Wing::with_motion(design, mesh, air_table, motion)?;
    Ok(solve_wing(design, &wing, mesh, near, progress)?.0)
}
