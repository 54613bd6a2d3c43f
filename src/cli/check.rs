//! `washout check`: is a run what it says it is.

use std::path::PathBuf;

use clap::Args;

use crate::export::ExportError;
use crate::export::check::{FileSince, RunCheck, SHAPE, ShapeCheck, WrittenShape};
use crate::export::run::Since;
use crate::page::text::{hanging, significant};
use crate::wing::{OtherEquilibrium, WingError, WingModel};

use super::{Console, Failure};

/// Arguments of `washout check`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout solve designs/twist-v2.toml
  # are its files and inputs unchanged, and does its shape meet the equations?
  washout check output/twist-v2

Every file of the run and every file that it was made of is held against its SHA-256. The shape of a solved wing is read from wing.vtu and put into the equations again. That gives the residual, forces and moments of loads and supports, work of loads and internal forces, twist and lift. Only the unloaded shape is solved anew, and the motion over the stroke where an effect needs it. Then the wing is solved with another accelerator, with load increments, and with a tenth and ten times of the film's drilling stiffness: a wing with one equilibrium has the same twist then; a slack or buckled film may have several. Of other runs the files are checked.

Exit code 1 if anything does not hold.")]
pub struct Check {
    /// Folder of a run
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
}

impl Check {
    /// Checks the run and prints what was found.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let mut check = RunCheck::of_files(&self.run)?;
        if check.has_shape() {
            match self.shape(console) {
                Ok((found, stated, others)) => {
                    check.add_shape(found, stated);
                    check.other_equilibria = others;
                }
                Err(interrupted @ Failure::Wing(WingError::Interrupted(_))) => return Err(interrupted),
                Err(reason) => check.refuse_shape(reason),
            }
        }
        console.result(&page(&check), &check)?;
        match check.faults.len() {
            0 => Ok(()),
            faults => Err(Failure::Unsound {
                run: self.run.clone(),
                faults,
            }),
        }
    }

    /// What is found of the shape, the residual that the run says it has, and other shapes that bear the same load.
    fn shape(&self, console: &Console) -> Result<(ShapeCheck, Option<f64>, Vec<OtherEquilibrium>), Failure> {
        let (summary, shape) = WrittenShape::read(&self.run)?;
        let wing = WingModel::new(summary.design.clone().resolved(summary.design_file.as_ref())?)?;
        if wing.mesh.nodes.len() != shape.nodes() {
            return Err(Failure::Export(ExportError::ForeignSummary {
                path: self.run.join(SHAPE),
                reason: format!(
                    "its {} nodes are not the {} of the design's mesh",
                    shape.nodes(),
                    wing.mesh.nodes.len()
                ),
            }));
        }
        let (solved, balance) = wing.at_shape(|rest| shape.on(rest), console.progress())?;
        Ok((
            ShapeCheck::new(&solved, &balance, &summary)?,
            summary.solve.residual,
            solved.other_equilibria(console.progress())?,
        ))
    }
}

fn page(check: &RunCheck) -> String {
    let verdict = match check.faults.len() {
        0 => "Everything that was checked holds.".to_string(),
        1 => "One thing does not hold.".to_string(),
        count => format!("{count} things do not hold."),
    };
    let mut text = format!("{}: {verdict}\n", check.run);
    for fault in &check.faults {
        text += &format!("  {fault}\n");
    }
    text += "\n";
    let unchanged = |files: &[FileSince]| {
        let same = files.iter().filter(|own| own.since == Since::Unchanged).count();
        format!("{same} of {} unchanged", files.len())
    };
    text += &format!("  run       washout {}\n", check.verb);
    text += &format!(
        "  files     {}\n  inputs    {}\n",
        unchanged(&check.files),
        unchanged(&check.inputs)
    );
    if let (Some(version), Some(same)) = (&check.washout_version, check.same_program) {
        let program = if same {
            "this program"
        } else {
            "another program than this; its numbers may differ"
        };
        text += &format!("  program   washout {version}, {program}\n");
    }
    match &check.balance {
        Some(shape) => {
            text += &shape_lines(shape);
            text += &others(&check.other_equilibria);
        }
        None if check.is_solved_wing() && !check.has_shape() => {
            text +=
                &format!("  shape     not checked, for {SHAPE} or summary.json is not as it was written\n");
        }
        None => {}
    }
    text
}

fn others(found: &[OtherEquilibrium]) -> String {
    if found.is_empty() {
        return "  others    none found, as far as other options of the solver have an answer\n".to_string();
    }
    found
        .iter()
        .map(|other| hanging("  others    ", &other.words(), 12))
        .collect()
}

fn shape_lines(shape: &ShapeCheck) -> String {
    let vector = |own: [f64; 3]| own.map(|part| significant(part, 4)).join(", ");
    let left = |left: f64| significant(left, 2);
    let unjudged = match shape.next_to_no_load {
        true => "  load      next to none: what is left of it is rounding, and is not judged\n",
        false => "",
    };
    let lift = shape
        .lift_change
        .map(|change| format!("  lift      {} of it from what the run says\n", left(change)));
    format!(
        "\nThe shape in {SHAPE}, put into the equations again\n  residual  {} of the load\n  loads     {} mN\n  supports  {} mN; \
         {} of the load is left, {} of its moment\n  work      of the loads {} mJ, of internal forces {} mJ; {} is left\n  \
         twist     {} deg at most from what the run says\n{}{unjudged}",
        left(shape.residual),
        vector(shape.load_mn),
        vector(shape.support_mn),
        left(shape.force_left),
        left(shape.moment_left),
        significant(shape.load_work_mj, 5),
        significant(shape.internal_work_mj, 5),
        left(shape.work_left),
        left(shape.twist_change_deg),
        lift.unwrap_or_default()
    )
}
