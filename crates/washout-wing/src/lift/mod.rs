//! Stroke means of lift, drag and power; ratios to a reference wing; what a twist profile buys.
//!
//! Blade elements of the paper's equation 1: dL = ½ρU²c C_L(α) dr, dD likewise with C_D, dP = U dD, with
//! U = 2πfΦ |cos phase| (r + r₀) and α = α_stop − θ(r, phase). One wing; SI.

pub mod error;

pub mod blade;

pub mod measured;

pub mod twist;

pub mod means;

pub mod stroke;

pub mod ratios;

pub mod effective;

pub mod distribution;

pub mod report;

pub mod flight;

pub mod quadrature;

#[cfg(test)]
mod paper;

pub use distribution::{SpanPoint, departure_from_ellipse, scaled_to_measured, span_distribution};
pub use effective::{EffectiveCoefficients, effective_coefficient_ratio, implied_amplitude_ratio};
pub use error::LiftError;
pub use flight::{Flight, InertialPower};
pub use means::{StationMeans, StrokeMeans};
pub use ratios::{Ratios, mean_local_lift_to_drag};
pub use report::{Forces, LiftReport};
pub use stroke::{Instant, Stroke, forces_at_phase, stroke_means};
pub use twist::{TwistAlongSpan, TwistHistory};
