//! Models of wings compared with measurements, and what they lack: the questions of [washout](https://docs.rs/washout), which gives
//! all of it.

pub use washout_design::{input, origin, progress};
pub use washout_wing::{aero, coupling, effects, geometry, lift, mesh, observation, structure, wing};

pub mod program;

pub mod task;

pub mod study;

pub mod explore;

pub mod synthesize;

pub mod compare;

pub mod solve;

pub mod sweep;

pub mod diagnose;

pub mod explain;

pub mod blind;

/// SHA-256 of the sources of this crate.
pub const SOURCES_SHA256: &str = env!("WASHOUT_SOURCES_SHA256");
