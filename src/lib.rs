//! washout: the twist of a flexible wing under air load, and which physics a model of it lacks.
//!
//! `input → geometry → mesh → structure | aero → effects → coupling → observation → lift → study → compare`,
//! and `export` turns any result into bytes. Data flows one way; `tests/floor_plan` keeps it so.

pub mod progress;

pub mod input;

pub mod geometry;

pub mod mesh;

pub mod structure;

pub mod aero;

pub mod effects;

pub mod coupling;

pub mod observation;

pub mod lift;

pub mod study;

pub mod compare;

pub mod export;

pub mod cli;
