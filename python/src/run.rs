//! A wing solved with all that `washout solve` gives: its summary and its files.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use washout::cli::Failure;
use washout::export::solved_run::SolvedRun;
use washout::export::json;
use washout::export::run::RunFolder;

use crate::failure::other;
use crate::solved::Solved;
use crate::worker::work;

/// A design solved as `washout solve` does it.
#[pyclass(frozen, module = "washout._washout")]
pub struct Run {
    run: Arc<SolvedRun>,
}

#[pymethods]
impl Run {
    /// The document `summary.json`, without files.
    fn summary(&self, py: Python<'_>) -> PyResult<String> {
        json::document(&self.run.summary())
            .and_then(|document| json::text(&document))
            .map_err(|error| other(py, &error.to_string()))
    }

    /// The wing in its loaded shape.
    fn solved(&self) -> Solved {
        Solved::new(self.run.solved.wing.clone())
    }

    /// Writes the folder of the run, as `washout solve --output` does.
    fn write(&self, py: Python<'_>, folder: PathBuf, report: bool) -> PyResult<PathBuf> {
        let run = Arc::clone(&self.run);
        work(py, None, move |progress| -> Result<PathBuf, Failure> {
            let mut target = RunFolder::create(&folder, "solve")?;
            run.add_files(&mut target, report)?;
            progress.check()?;
            Ok(target.commit()?)
        })
    }
}

impl Run {
    pub fn new(run: SolvedRun) -> Run {
        Run { run: Arc::new(run) }
    }
}
