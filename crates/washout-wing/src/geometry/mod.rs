//! Planform and layout; the frame and the signs.
//!
//! # Frame
//!
//! Wing frame, at rest: x (span) from the wing base to the tip, 0 ≤ x ≤ R, written r in results;
//! y (chord) from the leading edge to the trailing edge; z = x × y. The leading edge lies on y = 0, the
//! film in z = 0. The flapping axis passes through x = −r₀, y = 0.
//!
//! # Signs
//!
//! Twist θ is washout: positive where it *reduces* the local angle of attack, α(r) = α_root − θ(r).
//! With t the deformed chord vector (leading → trailing edge), θ = atan2(t_z, t_y).
//! Relative air at rest comes with U (cos α_root ŷ + sin α_root ẑ): a load along +z gives θ > 0.
//! Lift acts along û = −sin α_root ŷ + cos α_root ẑ, which is also the direction of the flapping axis
//! (upward for a horizontal stroke); gravity on a hovering wing is −9.80665 m/s² · û.
//!
//! Metres and radians inside; the design file's millimetres are converted here, once.

pub mod beta;

pub mod drawn;

pub mod error;

pub mod layout;

pub mod planform;

pub mod spline;

pub use drawn::DrawnWing;
pub use error::GeometryError;
pub use layout::Layout;
pub use planform::Planform;
