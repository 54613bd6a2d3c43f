//! washout: the twist of a flexible wing under air load, and which physics a model of it lacks.
//!
//! ```
//! use washout::{progress::Progress, wing::WingModel};
//!
//! let wing = WingModel::open("designs/twist-v2.toml", &["flapping.half_amplitude_deg=30"])?;
//! let solved = wing.solve(&Progress::quiet())?;
//! let tip_m = 0.97 * wing.planform.length_m();
//! println!("{:.2} deg", solved.twist_at(tip_m).expect("on the wing").to_degrees());
//! # assert!((solved.twist_at(tip_m).unwrap().to_degrees() - 18.2).abs() < 0.2);
//! # Ok::<(), washout::wing::WingError>(())
//! ```
//!
//! What you meet first:
//!
//! | type | what it is |
//! |---|---|
//! | [`wing::WingModel`] | a wing read and meshed |
//! | [`wing::SolvedWing`] | its loaded shape, with twist, lift, drag and power |
//! | [`solve::SolvedDesign`] | a design solved, with what its mesh leaves, its band, its stroke, its stresses |
//! | [`observation::TwistProfile`] | twist along the span, as the design's instrument reads it |
//! | [`lift::LiftReport`] | lift, drag and power |
//! | [`input::Design`] | a design, checked |
//! | [`input::measurement::Measurement`] | measured readings |
//! | [`study::Campaign`] | a study, ready to be calibrated and diagnosed |
//! | [`compare::ComparedStudy`] | measured minus modelled |
//! | [`diagnose::StudyDiagnosis`] | what the model lacks, and how sure that is |
//! | [`effects::Effect`] | physics that can be added |
//!
//! ```text
//! input ─→ geometry ─→ mesh ─┬→ structure ─┬→ effects ─→ coupling ─→ observation ─→ lift ─→ wing ─→ study ─→ compare
//! designs   outline    nodes  │  beams, film │  added      air and      twist as an    means   read,   bands    measured
//! measure-  rod and    and    └→ aero ───────┘  physics    structure    instrument     over    meshed,          minus
//! ments     spars      sets      flow, strips              together     sees it        stroke  solved           modelled
//!
//!                            verify: published cases ←─ structure, coupling, wing
//!
//! explore: fronts over twist profiles, rods for a wanted twist ←─ wing, study
//!
//! diagnose: which effect a model lacks, or an unknown cause ←─ study
//! explain: what it would take, where there are few numbers ←─ diagnose, study
//!
//! export: any result into bytes ←─ page: what a person reads ←─ plot: pictures from numbers
//! cli: one file per verb   progress: for every room   origin: files that were read   program: what results are made of   task: parts of long work
//! ```
//!
//! The command line, pages, reports and pictures are the feature `cli`, which is on by default. A program of its own needs none of it:
//! `washout = { version = "0.1", default-features = false }` leaves out clap, plotters, resvg and fonts, and what is left is licensed
//! `MIT OR Apache-2.0`. `parquet` (off by default) writes every table as Parquet too.
//!
//! The rooms stand in four crates, so that a change is compiled with what is above it; a program names this one alone. Data flows one
//! way; `tests/floor_plan` keeps it so. The shortest way through: `examples/first_run.rs`.

#[doc(inline)]
pub use washout_design::{input, origin, progress};

#[doc(inline)]
pub use washout_wing::{aero, coupling, effects, geometry, lift, mesh, observation, structure, wing};

#[doc(inline)]
pub use washout_study::{
    blind, compare, diagnose, explain, explore, program, solve, study, sweep, synthesize, task,
};

pub mod verify;

#[cfg(feature = "cli")]
pub mod page;

#[cfg(feature = "cli")]
pub mod plot;

#[cfg(feature = "cli")]
pub mod add;

pub mod export;

#[cfg(feature = "cli")]
pub mod live;

#[cfg(feature = "cli")]
pub mod cli;
