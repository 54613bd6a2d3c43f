//! Results in, bytes out: VTK files, tables, the summary, and the run folder that holds them.

pub mod error;

pub mod file;

pub mod lock;

pub mod place;

#[cfg(feature = "cli")]
pub mod html;

pub mod json;

pub mod vtu;

pub mod vtu_read;

pub mod wing;

pub mod reference;

pub mod measurement;

#[cfg(feature = "cli")]
pub mod explanation;

#[cfg(feature = "cli")]
pub mod modes;

#[cfg(feature = "cli")]
pub mod pareto;

#[cfg(feature = "cli")]
pub mod added;

pub mod calibrated;

#[cfg(feature = "cli")]
pub mod ladder;

#[cfg(feature = "cli")]
pub mod layouts;
#[cfg(feature = "parquet")]
pub mod parquet;

#[cfg(feature = "cli")]
pub mod template;

pub mod lift;

#[cfg(feature = "cli")]
pub mod plan;

pub mod pvd;

pub mod csv;

#[cfg(feature = "cli")]
mod band;

pub mod blind;

pub mod calculix;

pub mod kratos;

pub mod nodal_loads;

#[cfg(feature = "cli")]
pub mod sweep;

pub mod tasks;

pub mod summary;

#[cfg(feature = "cli")]
pub mod engineering;

#[cfg(feature = "cli")]
pub mod collect;

#[cfg(feature = "cli")]
pub mod solved_run;

#[cfg(feature = "cli")]
pub mod run;

#[cfg(feature = "cli")]
pub mod comparison;

#[cfg(feature = "cli")]
pub mod compare_report;

#[cfg(feature = "cli")]
pub mod diagnosis;

#[cfg(feature = "cli")]
mod hypotheses;

#[cfg(feature = "cli")]
pub mod pictures;

#[cfg(feature = "cli")]
pub mod check;

#[cfg(feature = "cli")]
pub mod difference;

#[cfg(feature = "cli")]
pub mod effects;

#[cfg(feature = "cli")]
pub mod report;

#[cfg(feature = "cli")]
pub mod solved;

pub mod studies;

#[cfg(feature = "cli")]
pub mod drawn;

#[cfg(feature = "cli")]
pub mod sheet;

#[cfg(feature = "cli")]
pub mod study;

#[cfg(feature = "cli")]
pub mod trust;

#[cfg(feature = "cli")]
pub mod verification;

#[cfg(feature = "cli")]
pub mod marks;

#[cfg(feature = "cli")]
pub mod video;

#[cfg(feature = "cli")]
pub mod warnings;

pub use error::ExportError;
