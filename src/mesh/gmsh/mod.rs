//! Gmsh files, MSH 4.1 in text, with the wing's sets as physical names. Coordinates in metres.
//!
//! Format: Gmsh reference manual, "MSH file format". The crate mshio has no physical names, hence a reader
//! of our own.

pub mod chains;

pub mod error;

pub mod lines;

pub mod read;

pub mod sections;

pub mod write;

pub use error::{FileDefect, GmshError};
pub use read::read;
pub use write::write;
