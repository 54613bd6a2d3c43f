//! Designs, measurements and studies, read and checked: the ground floor of [washout](https://docs.rs/washout), which gives all of
//! it. Nothing is meshed or solved here.

pub mod progress;

pub mod origin;

pub mod input;

/// SHA-256 of the sources of this crate.
pub const SOURCES_SHA256: &str = env!("WASHOUT_SOURCES_SHA256");
