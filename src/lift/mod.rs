//! Stroke means of lift, drag and power; ratios to a reference wing; what a twist profile buys.
//!
//! Blade elements of the paper's equation 1: dL = ½ρU²c C_L(α) dr, dD likewise with C_D, dP = U dD, with
//! U = 2πfΦ |cos phase| (r + r₀) and α = α_stop − θ(r, phase). One wing; SI.

pub mod error;

pub mod twist;

pub mod stroke;

pub mod ratios;

pub mod report;

mod quadrature;

#[cfg(test)]
mod paper;

pub use error::LiftError;
pub use ratios::{Ratios, effective_coefficient_ratio, implied_amplitude_ratio};
pub use report::{Forces, LiftReport};
pub use stroke::{Instant, StationMeans, Stroke, StrokeMeans, forces_at_phase, stroke_means};
pub use twist::{TwistAlongSpan, TwistHistory};
