//! Beams, plate and membrane, supports, assembly, nonlinear solve, modes. Knows no air.

pub mod beam;

pub mod corotational;

pub mod error;

pub mod factor;

pub mod lanczos;

pub mod loads;

pub mod mass;

pub mod material;

pub mod membrane;

pub mod model;

pub mod modes;

pub mod newton;

pub mod pattern;

pub mod plate;

pub mod rotation;

pub mod section;

pub mod shell;

pub mod state;

pub mod strength;

pub mod wing;

pub use beam::Beam;
pub use error::StructureError;
pub use loads::{ArmForce, Loads};
pub use mass::{MassProperties, mass_matrix};
pub use model::{Model, PointMass, Spring};
pub use modes::{Mode, Vibration, lowest_modes};
pub use newton::{Equilibrium, NewtonReport, NewtonSettings};
pub use section::Section;
pub use shell::{Compression, Sheet, Shell};
pub use strength::{FilmStress, Peak, bending_peak, film_stress, torsion_peak};
pub use wing::{bench_loads, wing_model};
