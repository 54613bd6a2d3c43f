//! A cantilever cut from a grid: one side clamped, a force spread over the other.

use nalgebra::Vector3;

use super::VerifyError;
use super::answer::linear;
use super::grid::Grid;

/// Small displacement of the nodes of the free end, by η, under `force_n` spread evenly over it.
///
/// # Errors
/// If the structure cannot be solved.
pub fn end_displacements(grid: &Grid, force_n: Vector3<f64>) -> Result<Vec<Vector3<f64>>, VerifyError> {
    let mut grid = grid.clone();
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let loads = grid.end_force(force_n);
    let moved = linear(&grid.model, &loads)?;
    Ok(grid.side(true).into_iter().map(|node| moved[node][0]).collect())
}

/// Displacement of the middle of the free end along a unit force spread over it.
///
/// # Errors
/// If the structure cannot be solved.
pub fn middle_of_end(grid: &Grid, direction: Vector3<f64>) -> Result<f64, VerifyError> {
    let moved = end_displacements(grid, direction)?;
    Ok(moved[moved.len() / 2].dot(&direction))
}
