//! `--stroke` and `--stroke-quasi-static` of `washout solve`: the wing over its stroke as files.

use crate::export::run::RunFolder;
use crate::export::wing::{Shape, moving_grid, solution_grid};
use crate::export::{ExportError, csv, pvd};
use crate::observation::field::twist_at_nodes;
use crate::progress::Progress;
use crate::wing::SolvedWing;
use crate::wing::stroke::{PhaseShape, StrokeSummary};
use crate::wing::stroke_periodic::periodic_stroke;
use crate::wing::stroke_quasi_static::quasi_static_stroke;

use super::Failure;

/// A wing at phases of its stroke.
#[derive(Debug)]
pub struct StrokeRun {
    /// Its rows and its mean.
    pub summary: StrokeSummary,
    /// Shapes, one a phase, as `.vtu`.
    shapes: Vec<Vec<u8>>,
}

/// The periodic motion at `count` phases.
pub fn periodic(wing: &SolvedWing, count: u16, progress: &Progress) -> Result<StrokeRun, Failure> {
    let mut shapes = Vec::new();
    let summary = periodic_stroke(wing, count, progress, |shape| draw(&mut shapes, &shape))?;
    Ok(StrokeRun { summary, shapes })
}

/// `count` phases, each solved as if it stood still.
pub fn quasi_static(wing: &SolvedWing, count: u16, progress: &Progress) -> Result<StrokeRun, Failure> {
    let mut shapes = Vec::new();
    let summary = quasi_static_stroke(wing, count, progress, |shape| draw(&mut shapes, &shape))?;
    Ok(StrokeRun { summary, shapes })
}

fn draw(shapes: &mut Vec<Vec<u8>>, shape: &PhaseShape) -> Result<(), Failure> {
    let design = shape.model.design();
    let twist_rad = twist_at_nodes(&shape.model.planform, shape.solution);
    let twist_deg = twist_rad.into_iter().map(f64::to_degrees).collect();
    let grid = match shape.instant {
        Some(now) => moving_grid(design, shape.solution, twist_deg, |point| now.in_space(point)),
        None => solution_grid(design, shape.solution, twist_deg, Shape::Deformed),
    };
    shapes.push(grid.to_vtu()?);
    Ok(())
}

impl StrokeRun {
    /// Adds the shapes, the collection that plays them, and the tables.
    pub fn add_files(&self, folder: &mut RunFolder) -> Result<(), ExportError> {
        let StrokeSummary { phases, profile, .. } = &self.summary;
        for (row, bytes) in phases.iter().zip(&self.shapes) {
            folder.add(&row.file, bytes)?;
        }
        let series: Vec<(f64, String)> = phases
            .iter()
            .map(|row| (row.phase_deg, row.file.clone()))
            .collect();
        folder.add("stroke.pvd", pvd::collection(&series).as_bytes())?;
        folder.add("stroke.csv", &csv::stroke(phases)?)?;
        folder.add("stroke-twist.csv", &csv::stroke_twist(profile)?)
    }
}
