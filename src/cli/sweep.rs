//! `washout sweep`: many cases in one table.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Args;
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::effects::bind;
use crate::export::ExportError;
use crate::export::lock::Lock;
use crate::export::pictures::sweep::scatter;
use crate::export::run::RunFolder;
use crate::export::sweep::{SweepSummary, read_plan, table, write_plan};
use crate::export::tasks::{read_part, write_part};
use crate::origin::InputFile;
use crate::progress::Progress;
use crate::sweep::points::MOST_CASES;
use crate::sweep::{
    Axis, Base, Content, Method, Row, SweepError, SweepPlan, Task, sensitivities, task_key, tasks,
};

use super::finished::finished;
use super::job::Job;
use super::tasks::{MOST_TASKS, TaskArguments, Work, beside, gone};
use crate::wing::WingError;

use super::{Console, Failure};

const VERB: &str = "sweep";

/// Arguments of `washout sweep`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout sweep designs/twist-v2.toml --vary flapping.frequency_hz=15..27:13
  washout sweep designs/twist-v2.toml --vary flapping.frequency_hz=18..26 \\
    --vary 'rod[0].section.diameter_mm=0.9..1.1' --samples 64
  # what a study says of each
  washout sweep studies/paper-wings.toml --vary material.carbon-rod.g_gpa=3..6:7
  # after an interruption: only what is missing is done
  washout sweep --resume output/twist-v2-sweep
  washout sweep designs/twist-v2.toml \\
    --vary flapping.frequency_hz=15..27:500 --slurm --partition night

Writes output/NAME-sweep/: sweep.csv (one row a case; a case that fails keeps its row and says why), scatter.svg, summary.json. The finished parts, from which an interrupted sweep goes on, are kept in output/NAME-sweep-tasks/. The table is the same bit for bit for any number of threads, tasks and machines.")]
pub struct Sweep {
    /// The design or study
    #[arg(required_unless_present = "resume")]
    pub base: Option<PathBuf>,
    /// Vary this key: LOW..HIGH:COUNT evenly, A,B,C one after the other, or LOW..HIGH with --samples; can be given many times
    #[arg(long, value_name = "KEY=VALUES", required_unless_present = "resume")]
    pub vary: Vec<String>,
    /// Change a key for all cases; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Take N samples of the ranges instead of every combination
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub samples: Option<u32>,
    /// How samples are taken [default: sobol with --samples, else grid]
    #[arg(long, value_enum, requires = "samples")]
    pub method: Option<Method>,
    /// Seed of the samples
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u32,
    /// Cases in one task: what is done at a stretch, kept, and never done again
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub task_size: u32,
    /// Folder to write into [default: output/NAME-sweep]
    #[arg(long, short, value_name = "DIR", conflicts_with = "resume")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
    /// Go on with the sweep of this folder
    #[arg(long, value_name = "DIR", conflicts_with_all = ["base", "vary", "set", "samples", "method"])]
    pub resume: Option<PathBuf>,
    /// Tasks
    #[command(flatten)]
    pub tasks: TaskArguments,
}

/// A sweep that is ready to run.
struct Ready {
    plan: SweepPlan,
    folder: PathBuf,
    parts: PathBuf,
    base: Base,
    points: Vec<Vec<String>>,
    tasks: Vec<Task>,
    files: Vec<InputFile>,
}

impl Sweep {
    /// Does what is missing and writes the table.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let mut ready = self.ready()?;
        let mut again = format!("washout sweep --resume {}", ready.folder.display());
        let report = self.report.then_some("--report");
        again.extend(report.map(|option| format!(" {option}")));
        let here = std::path::absolute(&ready.folder);
        let here = here.map_err(ExportError::file("find", &ready.folder))?;
        let job = Job {
            folder: ready.parts.clone(),
            words: ["sweep", "--resume", &here.display().to_string()]
                .into_iter()
                .chain(report)
                .map(str::to_string)
                .collect(),
            from: None,
            again,
        };
        match self.tasks.finish(&mut ready, &job, console)? {
            true => ready.merge(self.report, console),
            false => Ok(()),
        }
    }

    /// The sweep of the folder, or that of the command line, checked.
    fn ready(&self) -> Result<Ready, Failure> {
        let (plan, folder) = match (&self.resume, &self.base) {
            (Some(folder), _) => match read_plan(&beside(folder))? {
                Some(plan) => (plan, folder.clone()),
                None => {
                    return Err(Failure::Option {
                        option: "--resume",
                        reason: format!("{} holds no sweep that was begun", beside(folder).display()),
                    });
                }
            },
            (None, Some(base)) => self.planned(base)?,
            (None, None) => {
                return Err(Failure::Option {
                    option: "--resume",
                    reason: "give a design, a study, or the folder of a sweep".to_string(),
                });
            }
        };
        let fault = |source: SweepError| Failure::Sweep {
            base: plan.base.clone(),
            source,
        };
        let points = plan.points().map_err(fault)?;
        let base = Base::load(&plan.base, &plan.set).map_err(fault)?;
        // a key that nothing has fails everywhere: better said now
        if let (Some(first), Some(last)) = (points.first(), points.last())
            && let Err(error) = Base::load(&plan.base, &plan.sets(first))
            && Base::load(&plan.base, &plan.sets(last)).is_err()
        {
            return Err(fault(error));
        }
        let mut refused = points.iter().map_while(|point| refused_effect(&plan, point));
        if let Some(first) = refused.next()
            && refused.count() + 1 == points.len()
        {
            return Err(first);
        }
        if self.tasks.task.is_none() {
            RunFolder::refuse(&folder, VERB)?;
        }
        let parts = beside(&folder);
        if self.resume.is_none() {
            claim(&parts, &plan)?;
        }
        let mut content = Content::new(&base);
        let tasks = tasks(&plan, &points, &mut content);
        let files = content.all_files();
        Ok(Ready {
            plan,
            folder,
            parts,
            base,
            points,
            tasks,
            files,
        })
    }

    fn planned(&self, base: &Path) -> Result<(SweepPlan, PathBuf), Failure> {
        let fault = |source: SweepError| Failure::Sweep {
            base: base.to_path_buf(),
            source,
        };
        let axes = self
            .vary
            .iter()
            .map(|text| Axis::parse(text))
            .collect::<Result<Vec<_>, _>>();
        let samples = self.samples.map_or(0, |samples| samples as usize);
        let method = self
            .method
            .unwrap_or(if samples > 0 { Method::Sobol } else { Method::Grid });
        let path = std::path::absolute(base).map_err(|error| Failure::Option {
            option: "BASE",
            reason: format!("{}: {error}", base.display()),
        })?;
        let mut plan = SweepPlan {
            base: path,
            set: self.set.clone(),
            axes: axes.map_err(fault)?,
            method,
            samples,
            seed: self.seed,
            task_size: self.task_size as usize,
        };
        let twice =
            (1..plan.axes.len()).find(|&k| plan.axes[..k].iter().any(|axis| axis.key == plan.axes[k].key));
        if let Some(k) = twice {
            return Err(Failure::Option {
                option: "--vary",
                reason: format!(
                    "{} is varied twice; give all its values at once",
                    plan.axes[k].key
                ),
            });
        }
        if self.tasks.slurm.is_wanted() {
            let cases = plan.points().map_err(fault)?.len().min(MOST_CASES);
            plan.task_size = plan.task_size.max(cases.div_ceil(MOST_TASKS));
        }
        let name = base
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let folder = self
            .output
            .clone()
            .unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-sweep")));
        Ok((plan, folder))
    }
}

/// Notes what the parts of a folder are of; refuses one that holds those of another sweep.
fn claim(parts: &Path, plan: &SweepPlan) -> Result<(), Failure> {
    let parent = parts.parent().unwrap_or(Path::new(""));
    std::fs::create_dir_all(parent).map_err(ExportError::file("create", parent))?;
    let _lock = Lock::when_free(parts)?;
    match read_plan(parts)? {
        None => Ok(write_plan(parts, plan)?),
        Some(own) if own == *plan => Ok(()),
        Some(_) => Err(Failure::Option {
            option: "--output",
            reason: format!(
                "{} holds parts of another sweep; give another folder, remove them, or go on with it by --resume",
                parts.display()
            ),
        }),
    }
}

/// Why the effects of a case of a design are refused, if they are.
fn refused_effect(plan: &SweepPlan, point: &[String]) -> Option<Failure> {
    match Base::load(&plan.base, &plan.sets(point)) {
        Ok(Base::Design(loaded, _)) => {
            let error = bind(&loaded.design).err()?;
            Some(WingError::design(&plan.base, error).into())
        }
        _ => None,
    }
}

impl Work for Ready {
    fn count(&self) -> usize {
        self.tasks.len()
    }

    fn is_done(&self, task: usize) -> Result<bool, Failure> {
        Ok(self.kept(&self.tasks[task])?.is_some())
    }

    fn run(&mut self, tasks: &[usize], progress: &Progress) -> Result<(), Failure> {
        let fault = |source: SweepError| match source {
            SweepError::Cancelled(cancelled) => Failure::Interrupted(cancelled),
            source => Failure::Sweep {
                base: self.plan.base.clone(),
                source,
            },
        };
        self.base.prepare(progress).map_err(fault)?;
        let this: &Ready = self;
        let tasks: Vec<&Task> = tasks.iter().map(|task| &this.tasks[*task]).collect();
        let total: usize = tasks.iter().map(|task| task.cases.len()).sum();
        let done = AtomicUsize::new(0);
        tasks.par_iter().try_for_each(|task| {
            let rows = task.cases.clone().into_par_iter().map(|case| {
                let point = &this.points[case];
                let sets = this.plan.sets(point);
                let row = this
                    .base
                    .row(&this.plan.base, (case, point, &sets), &progress.unseen())?;
                let count = done.fetch_add(1, Ordering::Relaxed) + 1;
                progress.count(count, total, "cases");
                Ok(row)
            });
            let rows = rows.collect::<Result<Vec<Row>, Failure>>()?;
            this.still_holds(task).map_err(fault)?;
            Ok(write_part(&this.parts, task.number, &task.key, &rows)?)
        })
    }
}

impl Ready {
    /// Refuses what may have been read from files that are not those of the task any more.
    fn still_holds(&self, task: &Task) -> Result<(), SweepError> {
        let base = Base::load(&self.plan.base, &self.plan.set)?;
        let mut content = Content::new(&base);
        let points = &self.points[task.cases.clone()];
        if task_key(&self.plan, points, &mut content) == task.key {
            return Ok(());
        }
        let now = content.all_files();
        let changed = now.iter().find(|file| !self.files.contains(file));
        Err(SweepError::Changed {
            file: changed.map_or(self.plan.base.display().to_string(), |file| file.file.clone()),
        })
    }

    /// What a task gave, if it was done.
    fn kept(&self, task: &Task) -> Result<Option<Vec<Row>>, Failure> {
        let rows: Option<Vec<Row>> = read_part(&self.parts, task.number, &task.key)?;
        Ok(rows.filter(|rows| rows.len() == task.cases.len()))
    }

    /// The table from all results, in the order of the cases.
    fn merge(&self, with_report: bool, console: &Console) -> Result<(), Failure> {
        let mut rows = Vec::new();
        for task in &self.tasks {
            rows.extend(self.kept(task)?.ok_or_else(|| gone(task.number))?);
        }
        let summary = SweepSummary::new(&self.plan, &rows, sensitivities(&self.plan, &rows), &self.files);
        let mut folder = RunFolder::create(&self.folder, VERB)?;
        folder.add("sweep.csv", &table(&self.plan, &rows)?)?;
        if let Some(picture) = scatter(&self.plan, &rows) {
            let svg = picture.to_svg().map_err(ExportError::from)?;
            folder.add("scatter.svg", svg.as_bytes())?;
        }
        let files = folder.listed_with(with_report);
        let page = summary.page(&rows);
        let written = finished(folder, with_report.then_some(&page), &summary, console)?;
        if summary.failures == summary.cases {
            return Err(Failure::EmptySweep {
                cases: summary.cases,
                is_refused: summary.refused == summary.cases,
                table: written.join("sweep.csv"),
            });
        }
        let parts = self.parts.display();
        let listed = console.listed(&written, &files);
        let after = format!("{listed}Its parts are kept in {parts}\n");
        console.answer(&page, &after, &summary)
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::cli::{Arguments, Verb};

    #[test]
    fn cases_whose_file_changed_while_they_were_solved_are_not_kept() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name).display().to_string();
        let write = |name: &str, text: &str| std::fs::write(path(name), text).expect("written");
        let table = |lift: &str| format!("alpha_deg,cl,cd\n-90,0,2\n0,0,0.1\n45,{lift},1\n90,0,2\n");
        let init = crate::input::design::INIT.replace("NAME", "wing");
        write("wing.toml", &init);
        write("air.csv", &table("1.2"));
        let words = [
            ["washout", "sweep", &path("wing.toml"), "--set", "mesh.refine=0.2"],
            [
                "--set",
                "air.coefficients=table",
                "--set",
                "air.table=air.csv",
                "--vary",
            ],
        ];
        let more = ["air.table=air.csv", "--output", &path("sweep")];
        let words = words.concat().into_iter().chain(more);
        let parsed = Arguments::try_parse_from(words).expect("arguments");
        let Verb::Sweep(sweep) = parsed.verb else {
            panic!("another verb");
        };
        let mut ready = sweep.ready().expect("a sweep");
        write("air.csv", &table("1.1"));
        let error = ready.run(&[0], &Progress::quiet()).expect_err("changed");
        assert!(error.to_string().contains("air.csv changed"), "{error}");
        assert!(!ready.is_done(0).expect("readable"));
    }
}
