//! Measured minus modelled: row by row, along the span in degrees and in σ, stages side by side, and in words.
//!
//! Errors are measured minus modelled: positive where the wing does more than the model says.

pub mod comparison;

pub mod integrated;

pub mod ladder;

pub mod row;

pub mod span;

pub mod stages;

pub mod study;

mod study_words;

pub mod verdict;

pub use comparison::{Comparison, compare};
pub use ladder::{RungGroup, StudyRung};
pub use row::{ComparedRow, NotCompared};
pub use span::{ComparedStation, ProfileOrigin, SpanComparison};
pub use stages::{FittedStage, ModelledStages};
pub use study::{StudyCase, StudyComparison, StudyRow};
