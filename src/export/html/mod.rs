//! The report: one HTML file that needs nothing else, for a browser, a printer or a colleague.
//!
//! Every number that a table shows is taken from the document that stands in the page (`summary.json`, `comparison.json`,
//! `diagnosis.json`) and says from where: `<data value="20.58…" data-of="/tip/twist_deg">20.58</data>`.

pub mod script;

pub mod document;

pub mod table;

pub mod page;

pub mod parts;

pub mod picture;

pub mod wing;

pub mod wings;

pub mod numbers;

pub mod tube;

pub mod measured;

pub mod stroke;

pub mod still;

pub mod run;

pub mod inputs;

pub mod study;

pub mod cases;

pub mod compared;

pub mod diagnosis;

pub mod effects;

pub mod folder;

pub mod frames;

pub mod live;

pub use document::{Digits, Document};
pub use page::{Page, Section};
pub use wing::Wing;

/// Name of the report in the folder of a run.
pub const REPORT: &str = "report.html";

/// How a report is known as one: this stands in its head.
const GENERATOR: &str = "<meta name=\"generator\" content=\"washout ";

/// Whether a file holds a report that washout wrote.
pub fn is_report(bytes: &[u8]) -> bool {
    String::from_utf8_lossy(&bytes[..bytes.len().min(1024)]).contains(GENERATOR)
}
