//! Beams, plate and membrane, supports, assembly, nonlinear solve, modes. Knows no air.

pub mod analysis;

pub mod assembly;

pub mod beam;

pub mod blend;

pub mod change;

pub mod corotational;

pub mod damper;

pub mod equilibrium;

pub mod error;

pub mod factor;

pub mod finite;

mod laminate;

pub mod lanczos;

pub mod largest;

pub mod loads;

pub mod mass;

pub mod material;

pub mod membrane;

pub mod mixed;

pub mod model;

pub mod modes;

pub mod newton;

pub mod pattern;

pub mod plate;

pub mod rotation;

pub mod section;

pub mod sheet;

pub mod shell;

pub mod shell_force;
mod shell_local;

mod spring;

pub mod skin;

pub mod state;

pub mod strength;

pub mod regularisation;

pub mod wing;

pub use analysis::{Analysis, SharedAnalysis};
pub use beam::Beam;
pub use blend::Blend;
pub use damper::Damper;
pub use equilibrium::{Equilibrium, Tangent};
pub use error::{NotFinite, StructureError};
pub use finite::refuse_not_finite;
pub use largest::{larger, largest, smaller};
pub use loads::{ArmForce, BeamTwist, LinearForce, Loads};
pub use mass::{MassProperties, mass_matrix};
pub use mixed::Mixed;
pub use model::{Model, PointMass};
pub use modes::{Mode, Vibration, lowest_modes};
pub use newton::{NewtonReport, NewtonSettings};
pub use section::Section;
pub use sheet::{Compression, Sheet};
pub use shell::Shell;
pub use skin::Skin;
pub use spring::{Spring, Stiffening};
pub use strength::{FilmStress, Peak, bending_peak, film_stress, torsion_peak};
pub use wing::{
    bench_loads, innermost_rod, rod_deflection_m_n, rod_length_m, rod_twist_rad_n_m, weigh, wing_model,
    wing_model_beside,
};
