//! A line on standard error while it is a terminal, and Ctrl-C.

use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use super::{Line, Progress};

impl Line for ProgressBar {
    fn show(&self, message: &str) {
        self.set_message(message.to_string());
    }

    fn elapsed(&self) -> Duration {
        ProgressBar::elapsed(self)
    }

    fn clear(&self) {
        self.finish_and_clear();
    }
}

impl Progress {
    /// A handle that shows a line on standard error when that is a terminal.
    pub fn shown() -> Self {
        if !std::io::stderr().is_terminal() {
            return Progress::quiet();
        }
        let bar = ProgressBar::new_spinner();
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} [{elapsed}]") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(120));
        Progress {
            line: Some(Arc::new(bar)),
            ..Progress::quiet()
        }
    }

    /// Makes Ctrl-C (or a request to end, SIGTERM) cancel this handle; a second one ends the process at once with exit code 130.
    ///
    /// Does nothing if the process has another handler already.
    pub fn cancel_on_interrupt(&self) {
        let cancelled = Arc::clone(&self.cancelled);
        let handler = move || {
            if cancelled.swap(true, Ordering::SeqCst) {
                std::process::exit(130);
            }
        };
        // A second handler in one process is refused; the first one keeps working.
        let _ = ctrlc::set_handler(handler);
    }
}
