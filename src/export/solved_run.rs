//! A design solved, as the summary and the files of its run.

use crate::progress::Progress;
use crate::solve::{Asked, SolveError, SolvedDesign};
use crate::wing::WingModel;
use crate::wing::stroke::{PhaseShape, StrokeSummary};

use super::collect::{Solved, summarize, write_files};
use super::run::RunFolder;
use super::summary::RunSummary;
use super::warnings::of_stroke;
use super::wing::{Shape, moving_grid, solution_grid};
use super::{ExportError, csv, pvd};
use crate::observation::field::twist_at_nodes;

/// A design solved, with all that was asked for besides; nothing of it is written yet.
#[derive(Debug)]
pub struct SolvedRun {
    /// The design, solved.
    pub solved: SolvedDesign,
    /// Shapes over the stroke, one a phase, as `.vtu`.
    shapes: Vec<Vec<u8>>,
}

impl SolvedRun {
    /// Solves.
    ///
    /// # Errors
    /// As [`SolvedDesign::new`]; or if a shape holds what VTK cannot say.
    pub fn new<E: From<SolveError> + From<ExportError>>(
        wing: &WingModel,
        asked: &Asked,
        progress: &Progress,
    ) -> Result<SolvedRun, E> {
        let mut shapes = Vec::new();
        let solved = SolvedDesign::drawing(wing, asked, |shape| shapes.push(drawn(shape)), progress)?;
        Ok(SolvedRun {
            solved,
            shapes: shapes.into_iter().collect::<Result<_, _>>()?,
        })
    }

    /// Its summary, as `summary.json` has it, but with no files.
    pub fn summary(&self) -> RunSummary {
        let mut summary = summarize(&Solved::of(&self.solved));
        if let Some(stroke) = &self.solved.stroke {
            summary.warnings.extend(of_stroke(stroke));
            summary.stroke = Some(stroke.clone());
        }
        summary
    }

    /// Adds all its files to a folder and gives the summary among them; `with_report`: the report too.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn add_files(&self, folder: &mut RunFolder, with_report: bool) -> Result<RunSummary, ExportError> {
        let mut summary = self.summary();
        if let Some(stroke) = &self.solved.stroke {
            add_stroke(folder, stroke, &self.shapes)?;
        }
        write_files(folder, &Solved::of(&self.solved), &mut summary, with_report)?;
        Ok(summary)
    }
}

fn drawn(shape: &PhaseShape) -> Result<Vec<u8>, ExportError> {
    let design = shape.model.design();
    let twist_rad = twist_at_nodes(&shape.model.planform, shape.solution);
    let twist_deg = twist_rad.into_iter().map(f64::to_degrees).collect();
    let grid = match shape.instant {
        Some(now) => moving_grid(design, shape.solution, twist_deg, |point| now.in_space(point)),
        None => solution_grid(design, shape.solution, twist_deg, Shape::Deformed),
    };
    grid.to_vtu()
}

/// Adds the shapes, the collection that plays them, and the tables.
fn add_stroke(folder: &mut RunFolder, stroke: &StrokeSummary, shapes: &[Vec<u8>]) -> Result<(), ExportError> {
    for (row, bytes) in stroke.phases.iter().zip(shapes) {
        folder.add(&row.file, bytes)?;
    }
    let rows = stroke.phases.iter();
    let series: Vec<(f64, String)> = rows.map(|row| (row.phase_deg, row.file.clone())).collect();
    folder.add("stroke.pvd", pvd::collection(&series).as_bytes())?;
    folder.add("stroke.csv", &csv::stroke(&stroke.phases)?)?;
    folder.add("stroke-twist.csv", &csv::stroke_twist(&stroke.profile)?)
}
