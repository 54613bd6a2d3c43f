//! Work on a thread of its own: Python's lock stays free, Ctrl-C cancels, and a callback hears how far it is.

use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use washout::cli::Failure;
use washout::progress::Progress;

use crate::failure::{INTERRUPTED, raised, without_threads};

/// How often signals are looked for.
const LOOK: Duration = Duration::from_millis(50);

/// As the main thread of a process has it.
const STACK_BYTES: usize = 8 << 20;

/// Does `job` and gives its result. `listener` is called with each line of progress, on the thread that called; an exception of
/// its own, or Ctrl-C, cancels the job and is raised when the job has stopped. A second Ctrl-C does not wait for that.
pub fn work<T: Send + 'static>(
    py: Python<'_>,
    listener: Option<Py<PyAny>>,
    job: impl FnOnce(&Progress) -> Result<T, Failure> + Send + 'static,
) -> PyResult<T> {
    let (sender, mut lines) = channel::<String>();
    // The job's end drops the sender, which ends the loop below.
    let progress = Progress::told(move |line| {
        // Nobody listens any more after a second Ctrl-C.
        let _ = sender.send(line.to_string());
    });
    let cancelling = progress.unseen();
    let worker = thread::Builder::new()
        .stack_size(STACK_BYTES)
        .spawn(move || job(&progress))
        .map_err(|error| without_threads(&error))?;
    let mut stopped: Option<PyErr> = None;
    loop {
        let waiting = &mut lines;
        let heard = py.detach(move || waiting.recv_timeout(LOOK));
        let told = match (&heard, &listener) {
            (Err(RecvTimeoutError::Disconnected), _) => break,
            (Ok(line), Some(listener)) if stopped.is_none() => listener.call1(py, (line,)).map(drop),
            _ => Ok(()),
        };
        match (told.and_then(|()| py.check_signals()), stopped.is_some()) {
            (Ok(()), _) => {}
            (Err(error), false) => {
                cancelling.cancel();
                stopped = Some(error);
            }
            (Err(error), true) => return Err(error),
        }
    }
    let result = py.detach(|| worker.join());
    match (result, stopped) {
        // The failure says what was kept.
        (Ok(Err(failure)), Some(error))
            if failure.exit_code() == INTERRUPTED && error.is_instance_of::<PyKeyboardInterrupt>(py) =>
        {
            Err(raised(py, &failure))
        }
        (_, Some(error)) => Err(error),
        (Ok(result), None) => result.map_err(|failure| raised(py, &failure)),
        (Err(panic), None) => resume_unwind(panic),
    }
}
