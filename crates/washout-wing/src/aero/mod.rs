//! Flow, coefficients, centre of pressure, strips and chordwise pressure. Knows no structure.
//!
//! Frame: x along the span from base to tip, y along the chord from leading to trailing edge, z = x × y.
//! Everything that the coupled tangent needs is generic over [`Number`], so dual numbers give exact derivatives.

pub mod number;

pub mod error;

pub mod flow;

pub mod table;

pub mod coefficients;

mod join;

pub mod centre_of_pressure;

pub mod law;

pub mod strip;

pub mod lifting_line;

pub mod linear;

pub mod pressure;

pub use centre_of_pressure::CentreOfPressureLaw;
pub use coefficients::CoefficientLaw;
pub use error::AeroError;
pub use flow::Flow;
pub use law::AirLaw;
pub use lifting_line::LiftingLine;
pub use linear::{alpha_linear, strip_force_linear};
pub use number::Number;
pub use pressure::{pressure_density, pressure_weights};
pub use strip::{SectionAir, SectionChange, SectionCoefficients, StripForce, section_air, strip_force};
