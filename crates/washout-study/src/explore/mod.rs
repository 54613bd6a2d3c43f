//! Searching: fronts between aims over twist profiles, the rod layout that makes a wanted profile, and what an effect does to an
//! example wing.

pub mod error;

pub mod nsga2;

pub mod front;

pub mod profile;

pub mod blades;

pub mod shape_factor;

pub mod twist_front;

pub mod rods;

pub mod signature;

pub use error::ExploreError;
pub use front::{hypervolume, is_dominated, non_dominated};
pub use nsga2::{Evaluation, Individual, Nsga2, Problem};
pub use profile::StagedTwist;
pub use shape_factor::ShapeFactor;
pub use signature::{Signature, signature};
pub use twist_front::{Efficiency, FrontPoint, TwistFront};
