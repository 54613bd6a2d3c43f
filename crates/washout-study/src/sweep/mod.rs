//! Many cases: keys of a design or a study over values, what each case gives, and the tasks into which a sweep is cut.
//!
//! A row is a function of the base and its own values alone: every case is solved from the base as it stands, never from
//! whichever other finished first. So the table is the same for any number of threads, tasks and machines.

pub mod axis;

pub mod content;

pub mod error;

pub mod evaluate;

pub mod plan;

pub mod points;

pub mod sensitivity;

pub mod task;

pub use axis::{Axis, Values};
pub use content::Content;
pub use error::SweepError;
pub use evaluate::{Base, Figure, Row};
pub use plan::SweepPlan;
pub use points::{Method, points};
pub use sensitivity::{Sensitivity, sensitivities};
pub use task::{Task, task_key, tasks};
