//! Progress and cancelling: a handle that long computations report to and ask whether to stop.

use std::fmt;
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// A handle to report progress to and to ask whether the user wants to stop; cheap to clone and to share.
///
/// Reports go to standard error, and only when it is a terminal; results never depend on them.
#[derive(Clone)]
pub struct Progress {
    cancelled: Arc<AtomicBool>,
    bar: Option<ProgressBar>,
    listener: Option<Listener>,
}

/// What is told everything that is said.
type Listener = Arc<dyn Fn(&str) + Send + Sync>;

impl Progress {
    /// A handle that shows nothing and can only be cancelled by [`Progress::cancel`].
    pub fn quiet() -> Self {
        Progress {
            cancelled: Arc::new(AtomicBool::new(false)),
            bar: None,
            listener: None,
        }
    }

    /// A handle that shows nothing and tells `listener`, on whatever thread it is, each line that would be shown: for programs
    /// that have a screen of their own.
    pub fn told(listener: impl Fn(&str) + Send + Sync + 'static) -> Self {
        Progress {
            listener: Some(Arc::new(listener)),
            ..Progress::quiet()
        }
    }

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
            bar: Some(bar),
            ..Progress::quiet()
        }
    }

    /// A handle that shows nothing but is cancelled together with this one: for one of many cases that run at a time.
    pub fn unseen(&self) -> Self {
        Progress {
            cancelled: Arc::clone(&self.cancelled),
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

    /// Says what is being done now; replaces what was said before.
    pub fn say(&self, message: impl fmt::Display) {
        if let Some(bar) = &self.bar {
            bar.set_message(message.to_string());
        }
        if let Some(listener) = &self.listener {
            listener(&message.to_string());
        }
    }

    /// Says how many of `total` are done, and about how much time the others take.
    pub fn count(&self, done: usize, total: usize, what: &str) {
        let rest = total.saturating_sub(done);
        let Some(bar) = self.bar.as_ref().filter(|_| done > 0 && rest > 0) else {
            self.say(format_args!("{done} of {total} {what}"));
            return;
        };
        let left = bar.elapsed().mul_f64(rest as f64 / done as f64).as_secs();
        let left = match left {
            0..120 => format!("{left} s"),
            120..7200 => format!("{} min", left / 60),
            _ => format!("{:.1} h", left as f64 / 3600.0),
        };
        self.say(format_args!("{done} of {total} {what}, about {left} left"));
    }

    /// Asks everything that holds a clone of this handle to stop.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::SeqCst);
    }

    /// Whether somebody asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::SeqCst)
    }

    /// `Err(Cancelled)` once somebody asked to stop; call it in every loop that can last.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.is_cancelled() {
            Err(Cancelled)
        } else {
            Ok(())
        }
    }

    /// Removes the line from the terminal.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

impl Default for Progress {
    fn default() -> Self {
        Progress::quiet()
    }
}

impl fmt::Debug for Progress {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Progress")
            .field("cancelled", &self.is_cancelled())
            .field("shown", &self.bar.is_some())
            .finish()
    }
}

/// The user asked to stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("interrupted; nothing was written")]
pub struct Cancelled;

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;

    #[test]
    fn every_clone_sees_that_one_was_cancelled() {
        let progress = Progress::quiet();
        let clone = progress.clone();
        assert_eq!(clone.check(), Ok(()));
        progress.cancel();
        assert_eq!(clone.check(), Err(Cancelled));
    }

    #[test]
    fn an_unseen_handle_is_cancelled_with_the_one_it_came_from() {
        let progress = Progress::quiet();
        let unseen = progress.unseen();
        progress.cancel();
        assert!(unseen.is_cancelled());
    }

    #[test]
    fn a_listener_hears_what_is_said_but_not_what_is_said_unseen() {
        let heard = Arc::new(Mutex::new(Vec::new()));
        let ear = Arc::clone(&heard);
        let progress = Progress::told(move |line| ear.lock().expect("no panic").push(line.to_string()));
        progress.say("solving");
        progress.count(1, 2, "cases");
        progress.unseen().say("one of many");
        assert_eq!(*heard.lock().expect("no panic"), ["solving", "1 of 2 cases"]);
    }

    #[test]
    fn separate_handles_are_independent() {
        let progress = Progress::quiet();
        progress.cancel();
        assert_eq!(Progress::quiet().check(), Ok(()));
    }
}
