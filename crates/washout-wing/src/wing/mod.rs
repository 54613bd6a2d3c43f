//! A wing read and meshed, and a wing solved: what everybody asks who needs a twist.

pub mod error;

pub mod model;

pub mod solved;

pub mod discretization;

pub mod flights;

pub mod flown;

pub mod lift_ratios;

pub mod stroke;

pub mod stroke_periodic;

pub mod stroke_quasi_static;

pub mod divergence;

pub mod other_equilibria;

pub use discretization::{DiscretizationError, Meshes};
pub use error::WingError;
pub use flown::{Flown, TwistSource};
pub use model::WingModel;
pub use other_equilibria::OtherEquilibrium;
pub use solved::SolvedWing;
