//! The wing in motion over its stroke, as the viewer has it.

use crate::export::html::stroke::Stroke;
use crate::export::vtu::Grid;
use crate::export::wing::{Shape, moving_grid, solution_grid};
use crate::observation::field::twist_at_nodes;
use crate::progress::Progress;
use crate::wing::stroke::PhaseShape;
use crate::wing::stroke_periodic::periodic_stroke;
use crate::wing::{SolvedWing, WingError};

use super::shape::Phase;

/// Phases of the stroke that are shown.
const PHASES: u16 = 24;

/// The periodic motion of a wing, and its phases; none where it does not flap.
///
/// # Errors
/// If it has no such motion, or somebody asked to stop.
pub fn stroke(wing: &SolvedWing, progress: &Progress) -> Result<Option<(Stroke, Vec<Phase>)>, WingError> {
    let model = &wing.model;
    if model.design().flapping.is_none() {
        return Ok(None);
    }
    let mut grids = Vec::new();
    let summary = periodic_stroke(wing, PHASES, progress, |shape| -> Result<(), WingError> {
        grids.push(grid(&shape));
        Ok(())
    })?;
    progress.check()?;
    let (design, solution) = (model.design(), &wing.solution);
    let still = vec![0.0; solution.mesh.nodes.len()];
    let rest_mm = solution_grid(design, solution, still, Shape::Unloaded).points_mm;
    let rows = &summary.phases;
    let shown: Vec<usize> = Stroke::shown(rows, rest_mm.len()).collect();
    let shapes = grids
        .into_iter()
        .enumerate()
        .filter(|(row, _)| shown.contains(row));
    let shapes: Vec<(usize, Grid)> = shapes.collect();
    let root_offset_mm = 1e3 * model.planform.root_offset_m();
    let phases = rows.iter().map(|row| Phase {
        phase_deg: row.phase_deg,
        tip_twist_deg: row.tip_twist_deg,
    });
    let drawn = Stroke::new(rows, &shapes, &rest_mm, root_offset_mm);
    Ok(drawn.map(|drawn| (drawn, phases.collect())))
}

fn grid(shape: &PhaseShape) -> Grid {
    let design = shape.model.design();
    let twist_rad = twist_at_nodes(&shape.model.planform, shape.solution);
    let twist_deg = twist_rad.into_iter().map(f64::to_degrees).collect();
    match shape.instant {
        Some(now) => moving_grid(design, shape.solution, twist_deg, |point| now.in_space(point)),
        None => solution_grid(design, shape.solution, twist_deg, Shape::Deformed),
    }
}
