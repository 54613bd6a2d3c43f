//! A design solved with all that is asked for besides its loaded shape: what the mesh leaves, stresses, the band of its assumed inputs, its
//! stroke.

mod asked;

mod band;

mod error;

mod solved_design;

pub use asked::{Asked, OverStroke};
pub use error::SolveError;
pub use solved_design::SolvedDesign;
