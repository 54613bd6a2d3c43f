//! What a campaign took: solves, factorizations and derivatives, counted.

use std::fmt;
use std::ops::{AddAssign, Sub};
use std::sync::Mutex;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Counts of what was done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Work {
    /// Cases solved.
    pub solves: usize,
    /// Newton steps in all of them, with one factorization each.
    pub newton_steps: usize,
    /// Factorizations for derivatives: one for each solved case of which any are asked.
    pub factorizations: usize,
    /// Derivatives by a linear solve with these.
    pub derivatives: usize,
}

impl AddAssign for Work {
    fn add_assign(&mut self, more: Work) {
        self.solves += more.solves;
        self.newton_steps += more.newton_steps;
        self.factorizations += more.factorizations;
        self.derivatives += more.derivatives;
    }
}

impl Sub for Work {
    type Output = Work;

    fn sub(self, less: Work) -> Work {
        Work {
            solves: self.solves - less.solves,
            newton_steps: self.newton_steps - less.newton_steps,
            factorizations: self.factorizations - less.factorizations,
            derivatives: self.derivatives - less.derivatives,
        }
    }
}

impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} solves of a case in {} Newton steps; {} derivatives with {} factorizations",
            self.solves, self.newton_steps, self.derivatives, self.factorizations
        )
    }
}

/// A count that cases add to side by side.
#[derive(Debug, Default)]
pub(super) struct Tally(Mutex<Work>);

impl Tally {
    /// Adds to it.
    pub fn add(&self, more: Work) {
        *self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner()) += more;
    }

    /// The count so far.
    pub fn so_far(&self) -> Work {
        *self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}
