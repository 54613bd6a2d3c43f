//! The inverse: which rod, spars and film tension make a wanted twist, or the most lift per power.

pub mod layout;

pub mod search;

pub mod tolerance;

pub use layout::{Layout, Piece};
pub use search::{Aim, Candidate, Choices, Closer, Found, Search};
pub use tolerance::{Band, PieceBand, Tolerances, band};
