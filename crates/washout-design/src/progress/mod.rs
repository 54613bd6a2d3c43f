//! Progress and cancelling: a handle that long computations report to and ask whether to stop.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

#[cfg(feature = "cli")]
mod terminal;

/// A handle to report progress to and to ask whether the user wants to stop; cheap to clone and to share.
///
/// Reports go to standard error, and only when it is a terminal; results never depend on them.
#[derive(Clone)]
pub struct Progress {
    cancelled: Arc<AtomicBool>,
    line: Option<Arc<dyn Line>>,
    listener: Option<Listener>,
}

/// A line that shows what was said last.
trait Line: Send + Sync {
    /// Replaces what it shows.
    fn show(&self, message: &str);
    /// Since when it is there.
    fn elapsed(&self) -> Duration;
    /// Takes it away.
    fn clear(&self);
}

/// What is told everything that is said.
type Listener = Arc<dyn Fn(&str) + Send + Sync>;

impl Progress {
    /// A handle that shows nothing and can only be cancelled by [`Progress::cancel`].
    pub fn quiet() -> Self {
        Progress {
            cancelled: Arc::new(AtomicBool::new(false)),
            line: None,
            listener: None,
        }
    }

    /// A handle that shows nothing and tells `listener`, on whatever thread it is, each line that would be shown: for programs
    /// that have a screen of their own.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// use std::sync::mpsc::channel;
    /// use washout::progress::Progress;
    ///
    /// let (say, heard) = channel();
    /// let progress = Progress::told(move |line| drop(say.send(line.to_string())));
    /// progress.say("solving");
    /// assert_eq!(heard.recv().unwrap(), "solving");
    /// ```
    pub fn told(listener: impl Fn(&str) + Send + Sync + 'static) -> Self {
        Progress {
            listener: Some(Arc::new(listener)),
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

    /// Says what is being done now; replaces what was said before.
    pub fn say(&self, message: impl fmt::Display) {
        if let Some(line) = &self.line {
            line.show(&message.to_string());
        }
        if let Some(listener) = &self.listener {
            listener(&message.to_string());
        }
    }

    /// Says how many of `total` are done, and about how much time the others take.
    pub fn count(&self, done: usize, total: usize, what: &str) {
        let rest = total.saturating_sub(done);
        let Some(line) = self.line.as_ref().filter(|_| done > 0 && rest > 0) else {
            self.say(format_args!("{done} of {total} {what}"));
            return;
        };
        let left = line.elapsed().mul_f64(rest as f64 / done as f64).as_secs();
        let left = match left {
            0..120 => format!("{left} s"),
            120..7200 => format!("{} min", left / 60),
            _ => format!("{:.1} h", left as f64 / 3600.0),
        };
        self.say(format_args!("{done} of {total} {what}, about {left} left"));
    }

    /// Asks everything that holds a clone of this handle to stop.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// use washout::progress::Progress;
    ///
    /// let progress = Progress::quiet();
    /// let in_another_thread = progress.clone();
    /// in_another_thread.cancel();
    /// assert!(progress.check().is_err());
    /// ```
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
        if let Some(line) = &self.line {
            line.clear();
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
            .field("shown", &self.line.is_some())
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
