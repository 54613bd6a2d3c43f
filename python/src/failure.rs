//! Failures of the library as exceptions of `washout.errors`.

use std::path::Path;

use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError};
use pyo3::prelude::*;
use washout::cli::Failure;
use washout::effects::EffectError;
use washout::input::{InputError, Place};
use washout::wing::WingError;

/// Exit code of work that was cancelled.
pub const INTERRUPTED: u8 = 130;

/// The exception for a failure, by its exit code: 2 input, 3 not converged, 130 interrupted, any other.
pub fn raised(py: Python<'_>, failure: &Failure) -> PyErr {
    let message = failure.to_string();
    let class = match failure.exit_code() {
        INTERRUPTED => return PyKeyboardInterrupt::new_err(message),
        3 => "NotConverged",
        2 => "InputError",
        _ => "WashoutError",
    };
    let made = match failure {
        Failure::Input(error) | Failure::Wing(WingError::Input(error)) => of_input(py, &message, error),
        Failure::Wing(WingError::Effect { place, source }) => of_effect(py, &message, place, source),
        _ => {
            let file = file_of(failure).map(|path| path.display().to_string());
            made(py, class, (message, file))
        }
    };
    made.unwrap_or_else(|error| error)
}

/// The exception for an argument that is refused.
pub fn refused(py: Python<'_>, message: &str) -> PyErr {
    made(py, "InputError", (message, None::<String>)).unwrap_or_else(|error| error)
}

/// The exception where no thread can be started.
pub fn without_threads(error: &std::io::Error) -> PyErr {
    PyOSError::new_err(format!("no thread can be started for the work: {error}"))
}

/// The exception for anything else.
pub fn other(py: Python<'_>, message: &str) -> PyErr {
    made(py, "WashoutError", (message, None::<String>)).unwrap_or_else(|error| error)
}

fn of_input(py: Python<'_>, message: &str, error: &InputError) -> PyResult<PyErr> {
    let place = &error.place;
    let details = (
        message,
        &place.file,
        place.line,
        place.column,
        &error.key,
        &error.value,
        error.problem.to_string(),
        &error.cure,
    );
    made(py, "InputError", details)
}

fn of_effect(py: Python<'_>, message: &str, place: &Place, error: &EffectError) -> PyResult<PyErr> {
    let key = error.key().unwrap_or_default();
    let details = (
        message,
        &place.file,
        place.line,
        place.column,
        key,
        "",
        error.to_string(),
        "",
    );
    made(py, "InputError", details)
}

fn made<'py>(py: Python<'py>, class: &str, details: impl pyo3::call::PyCallArgs<'py>) -> PyResult<PyErr> {
    let class = py.import("washout.errors")?.getattr(class)?;
    Ok(PyErr::from_value(class.call1(details)?))
}

/// The design or study that a failure is about.
fn file_of(failure: &Failure) -> Option<&Path> {
    match failure {
        Failure::Wing(
            WingError::Design { design, .. }
            | WingError::Solve { design, .. }
            | WingError::Phase { design, .. }
            | WingError::NoMeasurement { design },
        )
        | Failure::Unstable { design, .. }
        | Failure::Undecided { design, .. }
        | Failure::Explore { design, .. } => Some(design),
        Failure::OfStudy { study, .. }
        | Failure::Diagnosis { study, .. }
        | Failure::Synthesis { study, .. }
        | Failure::Blind { study, .. } => Some(study),
        _ => None,
    }
}
