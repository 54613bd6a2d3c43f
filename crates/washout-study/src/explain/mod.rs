//! What it would take: the least implausible sets of changes of a model that bring a few readings within their scatter.
//!
//! The definition is in `docs/what-would-explain-it.md`.

mod answer;

mod answers;

mod changes;

pub mod choices;

mod error;

mod forecast;

mod grow;

mod inputs;

mod model;

mod prepared;

mod price;

mod ratios;

mod refit;

mod refute;

pub mod report;

mod scatter;

mod sets;

mod search;

mod settings;

mod words;

pub use answer::explain;
pub use answers::Answers;
pub use choices::{Choice, choices};
pub use error::ExplainError;
pub use model::Model;
pub use prepared::Prepared;
pub use report::Explanation;
pub use settings::Settings;
