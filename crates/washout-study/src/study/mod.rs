//! Predictions of whole studies; uncertainty of assumed inputs.

mod answers;

pub mod band;

pub mod bench;

mod best_fit;

pub mod boxed;

pub mod calibrate;

pub mod campaign;

pub mod case;

mod changes;

pub mod columns;

pub mod draws;

pub mod error;

mod experiments;

mod warm_start;

pub mod forward;

pub mod left_out;

mod normal_equations;

pub mod noise;

pub mod output;

pub mod proposal;

pub mod proposed;

pub mod quantile;

mod readings;

pub mod sample;

pub mod shares;

pub mod skipped;

pub mod surrogate;

mod task;

mod two_meshes;

pub mod uncertainty;

pub mod unknowns;

pub mod unnamed;

pub mod work;

pub use band::{OutputBand, SurrogateQuality};
pub use best_fit::best_fit;
pub use calibrate::{Fit, calibrate};
pub use campaign::Campaign;
pub use error::StudyError;
pub use forward::{Condition, Forward, Linear, MeshError, Observable, Unknown, UnknownKind, WarmStart};
pub use noise::{Discrepancy, Noise};
pub use output::{Output, ProfileOutputs};
pub use proposal::{Cost, Proposal};
pub use proposed::Proposals;
pub use shares::Share;
pub use skipped::SkippedRow;
pub use task::Task;
pub use two_meshes::{MeshLeaves, OnCoarserMesh, TwoMeshes};
pub use uncertainty::{Uncertainty, UncertaintySettings, propagate};
pub use work::Work;
