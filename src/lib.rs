//! washout: the twist of a flexible wing under air load, and which physics a model of it lacks.
//!
//! ```text
//! input ─→ geometry ─→ mesh ─┬→ structure ─┬→ effects ─→ coupling ─→ observation ─→ lift ─→ study ─→ compare
//! designs   outline    nodes  │  beams, film │  added      air and      twist as an    means    bands    measured
//! measure-  rod and    and    └→ aero ───────┘  physics    structure    instrument     over the          minus
//! ments     spars      sets      flow, strips              together     sees it        stroke            modelled
//!
//!                            verify: published cases ←─ structure, coupling
//!
//! explore: fronts over twist profiles, rods for a wanted twist ←─ lift, study
//!
//! diagnose: which effect a model lacks, or none that is known ←─ study
//!
//! export: any result into bytes ←─ plot: pictures from numbers
//! cli: one file per verb   progress: for every room   origin: what results are made of   task: parts of long work
//! ```
//!
//! Data flows one way; `tests/floor_plan` keeps it so. The shortest way through: `examples/first_run.rs`.

pub mod progress;

pub mod origin;

pub mod task;

pub mod input;

pub mod geometry;

pub mod mesh;

pub mod structure;

pub mod aero;

pub mod effects;

pub mod coupling;

pub mod observation;

pub mod lift;

pub mod verify;

pub mod study;

pub mod explore;

pub mod synthesize;

pub mod compare;

pub mod sweep;

pub mod diagnose;

pub mod blind;

pub mod plot;

pub mod export;

pub mod cli;
