//! Why a lift cannot be computed.

use thiserror::Error;

use crate::aero::AeroError;

/// A twist, flow or reference that the lift model cannot use.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LiftError {
    /// A steady stream or no flow at all.
    #[error("the design does not flap, so it has no stroke to average over; give it a [flapping] table")]
    NotFlapping,
    /// A flapping quantity that is no number or negative.
    #[error("{name} = {value} is not a stroke; give a finite value of 0 or more")]
    BadStroke {
        /// What it is, with its unit.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A measurement that says nothing of twist.
    #[error("the measurement holds no twist; name one with rows of channel twist or twist_rate")]
    NoMeasuredTwist,
    /// A profile without points.
    #[error("the twist profile has no points; give at least one [r, twist]")]
    NoTwist,
    /// A point that is not a number.
    #[error("point {point} of the twist profile is not finite; correct its r and its twist")]
    TwistNotFinite {
        /// Point, counted from 1.
        point: usize,
    },
    /// Points out of order.
    #[error(
        "point {point} of the twist profile stands at r = {r_mm} mm, not beyond {previous_mm} mm; sort the points \
         and keep one at each r"
    )]
    TwistNotRising {
        /// Point, counted from 1.
        point: usize,
        /// Its span position, mm.
        r_mm: f64,
        /// Span position of the point before, mm.
        previous_mm: f64,
    },
    /// A table of twist over the stroke without phases, out of order, or beyond a half-stroke.
    #[error(
        "entry {entry} of the twist over the stroke: phase {phase_deg} deg; give phases that rise from at least -90 \
         to at most 90 deg (0 is mid-stroke)"
    )]
    BadPhase {
        /// Entry, counted from 1; 0 when there is none.
        entry: usize,
        /// Its phase, deg.
        phase_deg: f64,
    },
    /// A strip outside the air law.
    #[error("at r = {r_mm:.2} mm: {source}")]
    Air {
        /// Span position, mm.
        r_mm: f64,
        /// What the air law says.
        source: AeroError,
    },
    /// A ratio to nothing.
    #[error(
        "{what} of the {wing} is {value}, so no ratio can be formed; choose a wing, a stroke and a twist (below the stop angle) that give some"
    )]
    NoRatio {
        /// Quantity with its unit.
        what: &'static str,
        /// Which wing or measurement.
        wing: &'static str,
        /// Its value.
        value: f64,
    },
}
