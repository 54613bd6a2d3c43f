//! How a verb can fail, and the exit code of each way.

use std::io;
use std::path::{Path, PathBuf};

use crate::add::AddError;
use crate::blind::BlindError;
use crate::coupling::CouplingError;
use crate::diagnose::DiagnoseError;
use crate::explain::ExplainError;
use crate::explore::ExploreError;
use crate::export::ExportError;
use crate::input::InputError;
use crate::page::text::significant;
use crate::progress::Cancelled;
use crate::solve::SolveError;
use crate::study::StudyError;
use crate::sweep::SweepError;
use crate::synthesize::SynthesizeError;
use crate::wing::WingError;

/// Why a verb did not do what it should.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// A design or measurement is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The shape has no natural frequencies.
    #[error(
        "{}: the {shape} shape is not stable ({directions} directions in which it would run away), so it has no natural \
         frequencies. Try a finer mesh (--refine 2), or give the film a pre-tension (film.pretension_n_per_m)",
        design.display()
    )]
    Unstable {
        /// The design file.
        design: PathBuf,
        /// `loaded` or `unloaded`.
        shape: &'static str,
        /// Negative pivots of its tangent.
        directions: usize,
    },
    /// A sweep of which some steps settled on nothing.
    #[error(
        "{}: {steps} of the steps did not settle, so the sweep does not say whether the wing diverges there; the result \
         says at which values and what to try",
        design.display()
    )]
    Undecided {
        /// The design file.
        design: PathBuf,
        /// Steps that did not settle.
        steps: usize,
    },
    /// A wing gives no answer.
    #[error(transparent)]
    Wing(#[from] WingError),
    /// The ranges of the assumed inputs give no band.
    #[error("--uncertainty: {0}")]
    Study(StudyError),
    /// A study gives no result.
    #[error("{}: {source}", study.display())]
    OfStudy {
        /// The study file.
        study: PathBuf,
        /// Why.
        source: StudyError,
    },
    /// A study that gives no diagnosis.
    #[error("{}: {source}", study.display())]
    Diagnosis {
        /// The study file.
        study: PathBuf,
        /// Why.
        source: DiagnoseError,
    },
    /// A study that gives no explanation.
    #[error("{}: {source}", study.display())]
    Explanation {
        /// The study file.
        study: PathBuf,
        /// Why.
        source: ExplainError,
    },
    /// Measurements that cannot be made.
    #[error("{}: {source}", study.display())]
    Synthesis {
        /// The study file.
        study: PathBuf,
        /// Why.
        source: SynthesizeError,
    },
    /// A case of a blind run that cannot be tried.
    #[error("{}: {source}", study.display())]
    Blind {
        /// The study file.
        study: PathBuf,
        /// Why.
        source: BlindError,
    },
    /// A search that cannot be made.
    #[error("{}: {source}", design.display())]
    Explore {
        /// The design file.
        design: PathBuf,
        /// Why.
        source: ExploreError,
    },
    /// A sweep that cannot be made.
    #[error("{}: {source}", base.display())]
    Sweep {
        /// The design or study.
        base: PathBuf,
        /// Why.
        source: SweepError,
    },
    /// The user asked to stop work that is done in tasks; what was done is kept.
    #[error("interrupted; {kept} of {tasks} tasks are kept; go on with: {again}")]
    Unfinished {
        /// Tasks with a result.
        kept: usize,
        /// All tasks.
        tasks: usize,
        /// How to go on.
        again: String,
    },
    /// A sweep of which no case gave anything.
    #[error("none of the {cases} cases gave a result; {} says why", table.display())]
    EmptySweep {
        /// Its cases.
        cases: usize,
        /// Whether the input of each is at fault.
        is_refused: bool,
        /// Its table.
        table: PathBuf,
    },
    /// The scheduler does not do what it should.
    #[error("{command}: {reason}")]
    Scheduler {
        /// What was called.
        command: String,
        /// What it said.
        reason: String,
    },
    /// An option that this design does not allow.
    #[error("{option}: {reason}")]
    Option {
        /// The option.
        option: &'static str,
        /// Why not, and the cure.
        reason: String,
    },
    /// Nothing that a report or a picture could be made of.
    #[error(
        "{}: {reason}",
        path.display()
    )]
    NothingToShow {
        /// What was named.
        path: PathBuf,
        /// What is wrong, and the cure.
        reason: String,
    },
    /// Results cannot be written or read.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// A name that makes no file name.
    #[error("'{name}' is no name for a wing: use letters, digits, '-' and '_' only")]
    Name {
        /// The name.
        name: String,
    },
    /// Cases of `washout verify` that fail.
    #[error("{} of the cases fail: {}", failing.len(), failing.join(", "))]
    Cases {
        /// Their names.
        failing: Vec<String>,
    },
    /// A run that is not what it says it is.
    #[error("{}: {} not hold; make that run again", run.display(), if *faults == 1 { "one thing does".to_string() } else { format!("{faults} things do") })]
    Unsound {
        /// The run.
        run: PathBuf,
        /// How many things do not hold.
        faults: usize,
    },
    /// A mesh whose solve takes more memory than there is.
    #[error(
        "{}: a solve of its mesh of {nodes} nodes takes about {} GB, and {} GB may be taken.\n  Take a coarser mesh (--refine 0.5), or allow \
         more (--memory {})",
        design.display(),
        significant(*needed_gb, 2),
        significant(*allowed_gb, 2),
        significant(needed_gb.max(0.1) * 1.2, 1)
    )]
    Memory {
        /// The design file.
        design: PathBuf,
        /// Nodes of the mesh.
        nodes: usize,
        /// What a solve takes, GB.
        needed_gb: f64,
        /// What it may take, GB.
        allowed_gb: f64,
    },
    /// A case that there is not.
    #[error(
        "there is no case '{name}'{}; `washout verify --list` shows all",
        nearest.as_ref().map_or(String::new(), |nearest| format!(", did you mean '{nearest}'?"))
    )]
    UnknownCase {
        /// What was asked for.
        name: String,
        /// The case that is nearest, if one is near.
        nearest: Option<String>,
    },
    /// Standard output does not take the result.
    #[error("cannot write to standard output: {0}; send it elsewhere, or free some space there")]
    Output(io::Error),
    /// Threads cannot be started.
    #[error("cannot start the threads: {0}; give a smaller number with --threads")]
    Threads(String),
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

impl From<AddError> for Failure {
    fn from(error: AddError) -> Failure {
        match error {
            AddError::Question { question, reason } => Failure::Option {
                option: question,
                reason,
            },
            AddError::Input(source) => Failure::Input(source),
            AddError::Study { study, source } => Failure::OfStudy { study, source },
        }
    }
}

impl From<SolveError> for Failure {
    fn from(error: SolveError) -> Failure {
        match error {
            SolveError::Wing(source) => Failure::Wing(source),
            SolveError::Band(source) => Failure::Study(source),
        }
    }
}

impl Failure {
    /// Why a study gives no diagnosis; what is at fault in the command or in a file is told as everywhere.
    pub fn of_diagnosis(study: &Path, source: DiagnoseError) -> Failure {
        match source {
            DiagnoseError::Asked { reason } => Failure::Option {
                option: "--effect",
                reason,
            },
            DiagnoseError::Input(error) => error.into(),
            source => Failure::Diagnosis {
                study: study.to_path_buf(),
                source,
            },
        }
    }

    /// The exit code of the process: 1 other, 2 input, 3 not converged, 130 interrupted.
    pub fn exit_code(&self) -> u8 {
        match self {
            Failure::Wing(error) => error.exit_code(),
            Failure::Option { .. } => 2,
            Failure::Unstable { .. } | Failure::Undecided { .. } => 3,
            Failure::Diagnosis { source, .. } => match source {
                DiagnoseError::Study(source) => source.exit_code(),
                DiagnoseError::Cancelled(_) => 130,
                _ => 2,
            },
            Failure::Explanation { source, .. } => match source {
                ExplainError::Diagnose(DiagnoseError::Study(source)) => source.exit_code(),
                ExplainError::Cancelled(_) => 130,
                _ => 2,
            },
            Failure::Synthesis { source, .. } => match source {
                SynthesizeError::Study(source) => source.exit_code(),
                _ => 2,
            },
            Failure::Explore { source, .. } => match source {
                ExploreError::Cancelled(_) => 130,
                ExploreError::Coupling(source) if source.is_not_converged() => 3,
                ExploreError::Coupling(CouplingError::Interrupted(_)) => 130,
                _ => 2,
            },
            Failure::Blind { source, .. } => match source {
                BlindError::Study(source)
                | BlindError::Synthesis(SynthesizeError::Study(source))
                | BlindError::Diagnosis(DiagnoseError::Study(source)) => source.exit_code(),
                BlindError::Diagnosis(DiagnoseError::Cancelled(_)) => 130,
                _ => 2,
            },
            Failure::Sweep { source, .. } => match source {
                SweepError::Cancelled(_) => 130,
                _ => 2,
            },
            Failure::EmptySweep { is_refused: true, .. } => 2,
            Failure::EmptySweep { .. } => 3,
            Failure::Scheduler { .. } => 1,
            Failure::Study(source) | Failure::OfStudy { source, .. } => source.exit_code(),
            Failure::Input(_) => 2,
            Failure::Name { .. } => 2,
            Failure::NothingToShow { .. } => 2,
            Failure::Export(source) if source.is_of_input() => 2,
            Failure::UnknownCase { .. } | Failure::Memory { .. } => 2,
            Failure::Export(_)
            | Failure::Output(_)
            | Failure::Threads(_)
            | Failure::Cases { .. }
            | Failure::Unsound { .. } => 1,
            Failure::Interrupted(_) | Failure::Unfinished { .. } => 130,
        }
    }
}
