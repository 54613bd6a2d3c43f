//! What is to be solved next, and what is said of it.

use std::sync::Arc;

use super::opened::{CaseWing, Opened};
use super::refusal::Refusal;
use super::session::Session;
use super::shape::{About, Read, document};
use super::values::Values;

/// A state that is to be solved.
#[derive(Clone)]
pub struct Job {
    /// Its revision.
    pub revision: u64,
    /// The case that is shown.
    pub case: usize,
    /// What was opened.
    pub opened: Arc<Opened>,
    /// What was moved.
    pub values: Values,
    /// The wing; or why there is none.
    pub wing: Result<CaseWing, Refusal>,
    /// The same as opened.
    pub first: Result<CaseWing, Refusal>,
}

impl Job {
    /// Of a session as it stands.
    pub fn of(session: &Session) -> Job {
        Job {
            revision: session.revision(),
            case: session.case(),
            opened: Arc::clone(session.opened()),
            values: session.values().clone(),
            wing: session.wing(),
            first: session.first_wing(),
        }
    }
}

/// The shape that is shown.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// What is said about it.
    pub about: About,
    /// What is read of it; none before the first.
    pub read: Option<Arc<Read>>,
    /// The wing as the viewer has it.
    pub wing: Option<Arc<str>>,
    /// All of it as the page reads it.
    pub text: Arc<str>,
}

impl Shown {
    /// Puts it into words anew, as the next revision.
    pub fn renew(&mut self) {
        self.about.shape_revision += 1;
        self.text = document(&self.about, self.read.as_deref(), self.wing.as_deref()).into();
    }
}
