//! A run held against itself: are its files as they were written, are its inputs as they were, and does its shape meet the equations.

use std::fs;
use std::path::Path;

use nalgebra::{UnitQuaternion, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::run::{SOLVED, SUMMARY, Since, read_summary, since_written};
use super::summary::RunSummary;
use super::vtu::{Grid, Values};
use super::vtu_read::read_vtu;
use super::{ExportError, json};
use crate::coupling::balance::Balance;
use crate::program::{MadeOf, program_sha256};
use crate::structure::larger;
use crate::structure::state::State;
use crate::wing::{OtherEquilibrium, SolvedWing, WingError};

/// The file that holds the shape of a run.
pub const SHAPE: &str = "wing.vtu";

/// Largest residual, and largest part of load or work that is not balanced: a thousand times what a solve leaves by default, and far
/// less than shows in a number.
const APART: f64 = 1e-5;
/// No residual that a run states allows more than this: what is accepted as converged leaves at most a thousandth of the load.
const MOST: f64 = 1e-2;
/// Largest change of a twist, deg: the last digit that is shown is a hundred times larger.
const TWIST_DEG: f64 = 1e-4;

/// What a check of a run found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RunCheck {
    /// Folder of the run.
    pub run: String,
    /// The verb that wrote it.
    pub verb: String,
    /// Version of the program that wrote it; absent where no document says it.
    pub washout_version: Option<String>,
    /// Whether this program is the one that wrote it, by sources and dependencies.
    pub same_program: Option<bool>,
    /// Files of the run.
    pub files: Vec<FileSince>,
    /// Files that it was made of, by the paths that were named then.
    pub inputs: Vec<FileSince>,
    /// The shape, put into the equations again; absent for runs that hold none.
    pub balance: Option<ShapeCheck>,
    /// Other shapes in which the wing rests under the same load, as far as other options of the solver lead to them.
    #[serde(default)]
    pub other_equilibria: Vec<OtherEquilibrium>,
    /// What does not hold; empty where all does.
    pub faults: Vec<String>,
}

/// A file, and what became of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FileSince {
    /// Its name or path.
    pub file: String,
    /// What became of it.
    pub since: Since,
}

/// How a shape meets the equations, recomputed from its displacements and rotations.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ShapeCheck {
    /// Residual relative to the load.
    pub residual: f64,
    /// Sum of the loads (air, bench, gravity), wing frame.
    pub load_mn: [f64; 3],
    /// Force of supports and springs on the wing, wing frame.
    pub support_mn: [f64; 3],
    /// What the two leave, relative to the load.
    pub force_left: f64,
    /// What their moments about the wing base leave, relative to the load times the size of the wing.
    pub moment_left: f64,
    /// Virtual work of the loads on the displacement from the unloaded shape.
    pub load_work_mj: f64,
    /// The same of the internal forces.
    pub internal_work_mj: f64,
    /// What the two leave, relative to the larger.
    pub work_left: f64,
    /// Largest difference of a twist to what the run says, deg.
    pub twist_change_deg: f64,
    /// Whether there is next to no load, so that what is left of it is rounding and is not judged.
    pub next_to_no_load: bool,
    /// Difference of lift to what the run says, relative to it; absent without flow.
    pub lift_change: Option<f64>,
}

impl RunCheck {
    /// The files of a run, and what it was made of; the shape is not looked at yet.
    ///
    /// # Errors
    /// If the folder has no record of washout.
    pub fn of_files(folder: &Path) -> Result<RunCheck, ExportError> {
        let (verb, files) = since_written(folder).ok_or_else(|| ExportError::Unrecorded {
            path: folder.to_path_buf(),
        })?;
        let since = |(file, since): (String, Since)| FileSince { file, since };
        let mut check = RunCheck {
            run: folder.display().to_string(),
            verb,
            washout_version: None,
            same_program: None,
            files: files.into_iter().map(since).collect(),
            inputs: Vec::new(),
            balance: None,
            other_equilibria: Vec::new(),
            faults: Vec::new(),
        };
        if let Some(made_of) = made_of(folder, &check.files) {
            let input = |file: &crate::origin::InputFile| FileSince {
                since: Since::noted(Path::new(&file.file), &file.sha256),
                file: file.file.clone(),
            };
            check.inputs = made_of.files.iter().map(input).collect();
            check.same_program = Some(made_of.program_sha256 == program_sha256());
            check.washout_version = Some(made_of.washout_version);
        }
        check.note(&check.files.clone(), "this file of the run");
        check.note(&check.inputs.clone(), "what the run was made of");
        Ok(check)
    }

    fn note(&mut self, files: &[FileSince], what: &str) {
        let faults = files.iter().filter_map(|FileSince { file, since }| match since {
            Since::Unchanged => None,
            Since::Changed => Some(format!("{file}: {what} was changed since")),
            Since::Missing => Some(format!("{file}: {what} is not there any more, or cannot be read")),
        });
        self.faults.extend(faults);
    }

    /// Whether the run is that of a solved wing.
    pub fn is_solved_wing(&self) -> bool {
        self.verb == SOLVED
    }

    /// Notes that the shape cannot be put into the equations again.
    pub fn refuse_shape(&mut self, reason: impl std::fmt::Display) {
        self.faults.push(format!(
            "the shape cannot be put into the equations again: {reason}"
        ));
    }

    /// Whether the shape of this run can be looked at: it is a solved wing, and its files are as they were written.
    pub fn has_shape(&self) -> bool {
        let is_whole = |name: &str| {
            let whole = |own: &FileSince| own.file == name && own.since == Since::Unchanged;
            self.files.iter().any(whole)
        };
        self.is_solved_wing() && is_whole(SUMMARY) && is_whole(SHAPE)
    }

    /// Adds what was found of the shape; `stated`: the residual that the run says it has, none for a wing with next to no load, of which
    /// rounding is all there is of what is left.
    pub fn add_shape(&mut self, found: ShapeCheck, stated: Option<f64>) {
        let mut fault = |what: &str, value: f64, limit: f64| {
            if value.is_nan() || value > limit {
                self.faults
                    .push(format!("{what} is {value:.2e}, at most {limit:.0e}"));
            }
        };
        if let Some(stated) = stated {
            let left = [
                ("the residual relative to the load", found.residual),
                ("what loads and supports leave of the load", found.force_left),
                ("what their moments leave", found.moment_left),
                (
                    "what the works of loads and internal forces leave",
                    found.work_left,
                ),
            ];
            for (what, value) in left {
                fault(what, value, (10.0 * stated).clamp(APART, MOST));
            }
        }
        fault(
            "a twist less what the run says (deg)",
            found.twist_change_deg,
            TWIST_DEG,
        );
        if let Some(change) = found.lift_change {
            fault("lift less what the run says, relative to it,", change, APART);
        }
        self.balance = Some(found);
    }
}

/// What a run was made of, as the first of its documents says that has it.
fn made_of(folder: &Path, files: &[FileSince]) -> Option<MadeOf> {
    let documents = files.iter().filter(|own| own.file.ends_with(".json"));
    documents.into_iter().find_map(|own| {
        let document: Value = json::read(&fs::read(folder.join(&own.file)).ok()?).ok()?;
        json::of(document.get("made_of")?).ok()
    })
}

/// The displacements (m) and rotations of the nodes from the unloaded shape, as a run wrote them.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenShape {
    moved_m: Vec<Vector3<f64>>,
    turned: Vec<UnitQuaternion<f64>>,
}

impl WrittenShape {
    /// That of a run, with its summary.
    ///
    /// # Errors
    /// If a file cannot be read or is damaged.
    pub fn read(folder: &Path) -> Result<(RunSummary, WrittenShape), ExportError> {
        let summary = read_summary(folder)?;
        let path = folder.join(SHAPE);
        let bytes = fs::read(&path).map_err(ExportError::file("read", &path))?;
        let grid = read_vtu(&bytes, &path)?;
        let vectors = |name: &str| {
            vectors(&grid, name).ok_or_else(|| ExportError::ForeignSummary {
                path: path.clone(),
                reason: format!("it has no {name}"),
            })
        };
        let turned = vectors("rotation_deg")?.into_iter();
        let shape = WrittenShape {
            moved_m: vectors("displacement_mm")?
                .into_iter()
                .map(|own| own * 1e-3)
                .collect(),
            turned: turned
                .map(|own| UnitQuaternion::from_scaled_axis(own * 1f64.to_radians()))
                .collect(),
        };
        Ok((summary, shape))
    }

    /// Nodes that it has.
    pub fn nodes(&self) -> usize {
        self.moved_m.len()
    }

    /// The shape under load, from the unloaded one.
    pub fn on(&self, rest: &State) -> State {
        let moved = rest.displacement.iter().zip(&self.moved_m);
        let turned = rest.rotation.iter().zip(&self.turned);
        State {
            displacement: moved.map(|(rest, own)| rest + own).collect(),
            rotation: turned.map(|(rest, own)| own * rest).collect(),
        }
    }
}

fn vectors(grid: &Grid, name: &str) -> Option<Vec<Vector3<f64>>> {
    let array = grid.point_arrays.iter().find(|array| array.name == name)?;
    match &array.values {
        Values::Real(3, values) => Some(values.chunks_exact(3).map(Vector3::from_column_slice).collect()),
        _ => None,
    }
}

impl ShapeCheck {
    /// Of a wing in the shape of a run, against what the run says of it.
    ///
    /// # Errors
    /// If the twist or the lift of that shape cannot be read.
    pub fn new(wing: &SolvedWing, balance: &Balance, summary: &RunSummary) -> Result<ShapeCheck, WingError> {
        let profile = wing.profile()?;
        let twist_change_deg = summary.profile.iter().map(|row| {
            let now = profile
                .readings
                .iter()
                .find(|now| (now.r_m * 1e3 - row.r_mm).abs() < 1e-9);
            now.map_or(f64::INFINITY, |now| {
                (now.twist_rad.to_degrees() - row.twist_deg).abs()
            })
        });
        let lift = |report: &crate::lift::LiftReport| report.solved.lift_mn;
        let lift = wing
            .lift()?
            .as_ref()
            .map(lift)
            .zip(summary.lift.as_ref().map(lift));
        let (force, moment) = balance.scale;
        let [load_work, internal_work] = [balance.load_work_j, balance.internal_work_j];
        let work = load_work.abs().max(internal_work.abs());
        let left = |difference: f64| {
            if difference == 0.0 {
                0.0
            } else {
                difference.abs() / work
            }
        };
        Ok(ShapeCheck {
            residual: balance.residual,
            load_mn: (balance.load_n * 1e3).into(),
            support_mn: (balance.support_n * 1e3).into(),
            force_left: (balance.load_n + balance.support_n).norm() / force,
            moment_left: (balance.load_moment_n_m + balance.support_moment_n_m).norm() / moment,
            load_work_mj: load_work * 1e3,
            internal_work_mj: internal_work * 1e3,
            work_left: left(load_work - internal_work),
            twist_change_deg: twist_change_deg.fold(0.0, larger),
            next_to_no_load: summary.solve.residual.is_none(),
            lift_change: lift.map(|(now, then)| match now == then {
                true => 0.0,
                false => (now - then).abs() / then.abs(),
            }),
        })
    }
}
