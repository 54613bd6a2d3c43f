//! Results in, bytes out: VTK files, tables, the summary, and the run folder that holds them.

pub mod error;

pub mod file;

pub mod lock;

pub mod place;

pub mod html;

pub mod json;

pub mod vtu;

pub mod vtu_read;

pub mod wing;

pub mod reference;

pub mod measurement;

pub mod modes;

pub mod pareto;

pub mod ladder;

pub mod layouts;
#[cfg(feature = "parquet")]
pub mod parquet;

pub mod template;

pub mod lift;

pub mod plan;

pub mod pvd;

pub mod csv;

mod band;

pub mod blind;

pub mod calculix;

pub mod kratos;

pub mod nodal_loads;

pub mod sweep;

pub mod tasks;

pub mod summary;

pub mod engineering;

pub mod collect;

pub mod run;

pub mod comparison;

pub mod diagnosis;

pub mod pictures;

pub mod difference;

pub mod effects;

pub mod report;

pub mod solved;

pub mod studies;

pub mod study;

pub mod trust;

pub mod verification;

pub mod video;

pub mod warnings;

pub use error::ExportError;
