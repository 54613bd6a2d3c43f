//! Work in tasks on the command line: one task alone, all that are missing side by side, or a job array of them.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::progress::Progress;

use super::job::Job;
use super::slurm::{self, Slurm};
use super::{Console, Failure};

/// Most tasks that a job array is given: what Slurm allows where nobody changed it.
pub const MOST_TASKS: usize = 1000;

/// Options of a verb whose work is cut into tasks.
#[derive(Debug, Clone, Args)]
pub struct TaskArguments {
    /// Do this task alone and put nothing together; for a scheduler
    #[arg(long, value_name = "N")]
    pub task: Option<usize>,
    /// On a cluster
    #[command(flatten)]
    pub slurm: Slurm,
}

/// Work that is cut into tasks, each of which keeps its result where the others find it.
pub trait Work {
    /// How many tasks there are.
    fn count(&self) -> usize;

    /// Whether a task has its result.
    ///
    /// # Errors
    /// If the result is there but cannot be read.
    fn is_done(&self, task: usize) -> Result<bool, Failure>;

    /// Does some tasks, side by side, and keeps each result as it comes.
    ///
    /// # Errors
    /// If a task has no result, it cannot be written, or the user asked to stop.
    fn run(&mut self, tasks: &[usize], progress: &Progress) -> Result<(), Failure>;
}

impl TaskArguments {
    /// Does what is missing, here or on a cluster, or the one task that was asked for; whether this process is to put the results
    /// together.
    ///
    /// # Errors
    /// For a task that there is not, a scheduler that refuses, a task without result, and if the user asked to stop.
    pub fn finish(&self, work: &mut impl Work, job: &Job, console: &Console) -> Result<bool, Failure> {
        let progress = console.progress();
        if let Some(number) = self.task {
            let last = work.count().saturating_sub(1);
            if number > last {
                return Err(Failure::Option {
                    option: "--task",
                    reason: format!("there is no task {number}; they go from 0 to {last}"),
                });
            }
            if !work.is_done(number)? {
                work.run(&[number], progress)?;
            }
            return Ok(false);
        }
        let missing = missing(work)?;
        if missing.is_empty() {
            return Ok(self.slurm.puts_together());
        }
        if self.slurm.is_wanted() {
            if missing.last().is_some_and(|last| *last >= MOST_TASKS) {
                return Err(Failure::Option {
                    option: "--slurm",
                    reason: format!(
                        "{} tasks are more than the {MOST_TASKS} of a job array; make them larger (--task-size)",
                        work.count()
                    ),
                });
            }
            slurm::run(&self.slurm, job, &missing, &|| left(work), console)?;
            return Ok(self.slurm.puts_together() && left(work)? == 0);
        }
        match work.run(&missing, progress) {
            Err(failure) => Err(unfinished(failure, work, job)),
            Ok(()) => Ok(true),
        }
    }
}

/// An interruption with what is kept; any other failure as it is.
pub fn unfinished(failure: Failure, work: &impl Work, job: &Job) -> Failure {
    match (failure.exit_code(), left(work)) {
        (130, Ok(left)) => Failure::Unfinished {
            kept: work.count() - left,
            tasks: work.count(),
            again: job.again.clone(),
        },
        _ => failure,
    }
}

/// Tasks without a result.
fn missing(work: &impl Work) -> Result<Vec<usize>, Failure> {
    let mut missing = Vec::new();
    for task in 0..work.count() {
        if !work.is_done(task)? {
            missing.push(task);
        }
    }
    Ok(missing)
}

fn left(work: &impl Work) -> Result<usize, Failure> {
    Ok(missing(work)?.len())
}

/// Folder beside that of a run, for the parts that it is made of: `NAME-tasks`.
pub fn beside(target: &Path) -> PathBuf {
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    target.with_file_name(format!("{name}-tasks"))
}

/// Why results cannot be put together: one went away meanwhile.
pub fn gone(number: usize) -> Failure {
    Failure::Option {
        option: "--task",
        reason: format!("task {number} has no result any more; give the same command again"),
    }
}
