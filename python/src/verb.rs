//! Any verb of the command line, for the document that it gives with `--json`.

use clap::Parser;
use pyo3::prelude::*;
use washout::cli::misused::words;
use washout::cli::{Arguments, Console, Failure, run_on};

use crate::failure::refused;
use crate::worker::work;

/// The document of a verb as JSON; empty where the verb has none.
#[pyfunction]
#[pyo3(signature = (arguments, listener=None))]
pub fn run(py: Python<'_>, arguments: Vec<String>, listener: Option<Py<PyAny>>) -> PyResult<String> {
    let program = "washout".to_string();
    let arguments = Arguments::try_parse_from([program].into_iter().chain(arguments)).map_err(|error| {
        let message = words(&error).unwrap_or_else(|| error.render().to_string());
        refused(py, &message)
    })?;
    work(py, listener, move |progress| -> Result<String, Failure> {
        let console = Console::keeping(progress.clone());
        run_on(&console, &arguments)?;
        Ok(console.into_kept())
    })
}
