//! Published cases run through the library that the wings use: what the solver makes of them on three meshes.
//!
//! ```text
//! cases/NAME.rs ─→ run (each case on a coarse, a middle, a fine mesh, side by side) ─→ judge (error, order, pass)
//!   set-up from chain, grid, strip_wing, measured_wing; solved by answer
//! ```
//!
//! A case is plain data and one function; all of them stand in [`cases::ALL`].

pub mod case;

pub mod error;

pub mod chain;

pub mod grid;

pub mod answer;

pub mod strip_wing;

pub mod measured_wing;

pub mod buckling;

pub mod cantilever;

pub mod judge;

pub mod run;

pub mod cases;

pub use case::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, Scale};
pub use cases::{ALL, named};
pub use error::VerifyError;
pub use judge::{Judged, Outcome, Verdict};
pub use run::{Extent, run};
