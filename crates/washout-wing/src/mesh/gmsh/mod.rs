//! Gmsh files with the wing's sets as physical names, coordinates in metres: MSH 4.1 in text out, 4.1 and 2.2 in.
//!
//! Format: Gmsh reference manual, "MSH file format". The crate mshio has no physical names, hence a reader
//! of our own.

pub mod chains;

pub mod error;

pub mod geometry;

pub mod lines;

pub mod read;

pub mod raw;

mod sections;

pub mod version_2;

pub mod write;

pub use error::{FileDefect, GmshError};
pub use geometry::geometry;
pub use read::read;
pub use write::write;
