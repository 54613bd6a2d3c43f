//! Comparisons and diagnoses: the documents of `washout compare` and `washout diagnose`.

use std::path::PathBuf;

use pyo3::prelude::*;
use washout::cli::compare::Compare;
use washout::cli::design_arguments::DesignArguments;
use washout::cli::diagnose::Diagnose;
use washout::cli::{Console, Failure};
use washout::export::json;
use washout::progress::Progress;

use washout::input::sheet::Sigmas;

use crate::failure::refused;
use crate::worker::work;

/// Compares a design, or a study, with its measurements, and gives the document as JSON. Files are written into `output` where it is given.
#[pyfunction]
#[pyo3(signature = (path, sets, table=None, sigma=None, hold_out=Vec::new(), case=None, reference=None, output=None, listener=None))]
#[expect(clippy::too_many_arguments, reason = "the options of the verb")]
pub fn compare(
    py: Python<'_>,
    path: PathBuf,
    sets: Vec<String>,
    table: Option<PathBuf>,
    sigma: Option<String>,
    hold_out: Vec<String>,
    case: Option<String>,
    reference: Option<PathBuf>,
    output: Option<PathBuf>,
    listener: Option<Py<PyAny>>,
) -> PyResult<String> {
    let verb = Compare {
        design: DesignArguments::of_file(&path, &sets, None),
        with: table,
        sigma: sigmas(py, sigma)?,
        hold_out,
        case,
        reference,
        output,
        report: false,
    };
    work(py, listener, move |progress| match verb.output {
        Some(_) => kept(progress, |console| verb.run(console)),
        None => Ok(json::text(&verb.document(&Console::keeping(progress.clone()))?)?),
    })
}

/// Diagnoses a study, or a design with a table of readings, and gives the document as JSON. Files are written into `output` where it is
/// given.
#[pyfunction]
#[pyo3(signature = (path, sets, effects, without, significance, seed, own_data, table=None, sigma=None, hold_out=Vec::new(), output=None, listener=None))]
#[expect(clippy::too_many_arguments, reason = "the options of the verb")]
pub fn diagnose(
    py: Python<'_>,
    path: PathBuf,
    sets: Vec<String>,
    effects: Vec<String>,
    without: Vec<String>,
    significance: f64,
    seed: i128,
    own_data: bool,
    table: Option<PathBuf>,
    sigma: Option<String>,
    hold_out: Vec<String>,
    output: Option<PathBuf>,
    listener: Option<Py<PyAny>>,
) -> PyResult<String> {
    let seed = u64::try_from(seed).map_err(|_| {
        refused(
            py,
            &format!("seed = {seed}: must lie in 0 … {}.\n  Give another one", u64::MAX),
        )
    })?;
    let verb = Diagnose {
        study: path,
        with: table,
        sigma: sigmas(py, sigma)?,
        hold_out,
        set: sets,
        effect: effects,
        without,
        on: Vec::new(),
        significance,
        plan: false,
        own_data,
        seed,
        output,
        report: false,
    };
    work(py, listener, move |progress| match verb.output {
        Some(_) => kept(progress, |console| verb.run(console)),
        None => Ok(json::text(&verb.document(&Console::keeping(progress.clone()))?)?),
    })
}

/// Standard deviations as a table takes them: `0.3`, or `0.3 deg, 0.05 mm`.
fn sigmas(py: Python<'_>, sigma: Option<String>) -> PyResult<Option<Sigmas>> {
    let parsed = sigma.map(|text| {
        text.parse()
            .map_err(|reason| refused(py, &format!("sigma = {text}: {reason}")))
    });
    parsed.transpose()
}

/// The document that a verb gives to its console.
fn kept(progress: &Progress, verb: impl FnOnce(&Console) -> Result<(), Failure>) -> Result<String, Failure> {
    let console = Console::keeping(progress.clone());
    verb(&console)?;
    Ok(console.into_kept())
}
