//! A flexible wing meshed and solved under air load: the solver of [washout](https://docs.rs/washout), which gives all of it.

pub use washout_design::{input, origin, progress};

pub mod geometry;

pub mod mesh;

pub mod structure;

pub mod aero;

pub mod effects;

pub mod coupling;

pub mod observation;

pub mod lift;

pub mod wing;

/// SHA-256 of the sources of this crate.
pub const SOURCES_SHA256: &str = env!("WASHOUT_SOURCES_SHA256");
