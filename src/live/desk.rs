//! A session that many ask at a time, and a thread that solves what was moved last.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::progress::Progress;

use super::job::{Job, Shown};
use super::ladder::Ladder;
use super::question::Question;
use super::refusal::Refusal;
use super::session::Session;
use super::state::State;
use super::table::Table;

/// How long a solve from the last shape is left to end when a newer move comes, so that the curve follows while a slider is dragged.
const PATIENCE: Duration = Duration::from_millis(300);

/// A session with what it shows.
pub struct Desk {
    inner: Mutex<Inner>,
    bell: Condvar,
}

struct Inner {
    session: Session,
    next: Option<Job>,
    running: Option<Running>,
    shown: Shown,
    question: Question,
    /// A table that was read, with the word that takes it.
    table: Option<(String, Arc<Table>)>,
    has_ended: bool,
}

/// What the thread does now.
struct Running {
    progress: Progress,
    since: Instant,
    is_following: bool,
}

impl Desk {
    /// A desk with a session, whose first shape is to be solved.
    pub fn new(session: Session) -> Arc<Desk> {
        Arc::new(Desk {
            inner: Mutex::new(Inner {
                next: Some(Job::of(&session)),
                session,
                running: None,
                shown: Shown::default(),
                question: Question::default(),
                table: None,
                has_ended: false,
            }),
            bell: Condvar::new(),
        })
    }

    /// Starts a thread that does `work`, job by job, until the desk is closed.
    ///
    /// # Errors
    /// If there can be no thread more.
    pub fn start(
        self: &Arc<Self>,
        work: impl FnOnce(&Desk) + Send + 'static,
    ) -> std::io::Result<JoinHandle<()>> {
        let desk = Arc::clone(self);
        // what is solved by recursion is solved in threads of their own: rayon's
        std::thread::Builder::new().spawn(move || work(&desk))
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The state as it is.
    pub fn state(&self) -> State {
        self.lock().session.state()
    }

    /// The session as it is.
    pub fn session(&self) -> Session {
        self.lock().session.clone()
    }

    /// Changes the session; what is to be solved then is solved.
    ///
    /// # Errors
    /// If the change is refused; then all stays as it was.
    pub fn change(&self, change: impl FnOnce(&mut Session) -> Result<(), Refusal>) -> Result<State, Refusal> {
        let mut inner = self.lock();
        let before = inner.session.clone();
        change(&mut inner.session)?;
        if !inner.session.is_alike(&before) {
            inner.next = Some(Job::of(&inner.session));
            if let Some(running) = &inner.running {
                let is_short = running.is_following && running.since.elapsed() < PATIENCE;
                if !is_short {
                    running.progress.cancel();
                }
            }
            self.bell.notify_all();
        }
        Ok(inner.session.state())
    }

    /// The next job and what it is cancelled by, once there is one; none when the desk is closed.
    pub fn next(&self) -> Option<(Job, Progress)> {
        let mut inner = self.lock();
        inner.running = None;
        loop {
            if inner.has_ended {
                return None;
            }
            if let Some(job) = inner.next.take() {
                let progress = Progress::quiet();
                inner.running = Some(Running {
                    progress: progress.clone(),
                    since: Instant::now(),
                    is_following: true,
                });
                return Some((job, progress));
            }
            inner = self.bell.wait(inner).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// That the short part of a job is over; whether it goes on, for there is no newer one.
    pub fn goes_on(&self) -> bool {
        let mut inner = self.lock();
        if let Some(running) = &mut inner.running {
            running.is_following = false;
        }
        inner.next.is_none() && !inner.has_ended
    }

    /// Changes what is shown, if `revision` is not older than that; all who wait hear of it.
    pub fn show(&self, revision: u64, change: impl FnOnce(&mut Shown)) {
        let mut inner = self.lock();
        if revision >= inner.shown.about.revision {
            change(&mut inner.shown);
            inner.shown.about.revision = revision;
            inner.shown.renew();
            self.bell.notify_all();
        }
    }

    /// The ladder of a revision.
    pub fn climb(&self, revision: u64, ladder: Ladder) {
        let mut inner = self.lock();
        if inner.session.revision() == revision {
            inner.session.climb(ladder);
        }
        drop(inner);
        self.show(revision, |_| {});
    }

    /// The shape as the page reads it, once it is newer than `after`; none if it does not become so within `wait`.
    pub fn shape(&self, after: Option<u64>, wait: Duration) -> Option<Arc<str>> {
        self.wait(wait, |inner| {
            let shown = &inner.shown;
            let is_there = shown.about.shape_revision > after.unwrap_or(0);
            is_there.then(|| Arc::clone(&shown.text))
        })
    }

    /// What is shown.
    pub fn shown(&self) -> Shown {
        self.lock().shown.clone()
    }

    /// What `found` gives of the question, once it gives something; none if it does not within `wait`.
    pub fn question<T>(&self, wait: Duration, found: impl Fn(&Question) -> Option<T>) -> Option<T> {
        self.wait(wait, |inner| found(&inner.question))
    }

    /// Changes the question; all who wait hear of it.
    pub fn ask<T>(&self, change: impl FnOnce(&mut Question) -> T) -> T {
        let given = change(&mut self.lock().question);
        self.bell.notify_all();
        given
    }

    /// Lays a table out to be taken by a word.
    pub fn lay_out(&self, word: &str, table: Table) {
        self.lock().table = Some((word.to_string(), Arc::new(table)));
    }

    /// The table that a word takes.
    pub fn laid_out(&self, word: &str) -> Option<Arc<Table>> {
        let inner = self.lock();
        let (_, table) = inner.table.as_ref().filter(|(own, _)| own == word)?;
        Some(Arc::clone(table))
    }

    /// Ends all who work or wait.
    pub fn close(&self) {
        let mut inner = self.lock();
        inner.has_ended = true;
        if let Some(running) = &inner.running {
            running.progress.cancel();
        }
        inner.question.stop();
        self.bell.notify_all();
    }

    /// What `found` gives, once it gives something; none after `wait`, or when the desk is closed.
    fn wait<T>(&self, wait: Duration, found: impl Fn(&Inner) -> Option<T>) -> Option<T> {
        let until = Instant::now() + wait;
        let mut inner = self.lock();
        loop {
            let given = found(&inner);
            let left = until.saturating_duration_since(Instant::now());
            if given.is_some() || left.is_zero() || inner.has_ended {
                return given;
            }
            let waited = self.bell.wait_timeout(inner, left);
            inner = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}
