//! An effect joins the model of a study, or leaves it: fitted together with all else that is open, with the error step by step.

mod added;

mod bench;

mod effect_tables;

mod error;

mod fit;

pub mod joining;

mod moved;

pub mod own;

pub use added::Other;
pub use bench::OnBench;
pub use error::AddError;
pub use fit::{Fit, Joining};
pub use moved::{stages, with_sets, with_strength};
