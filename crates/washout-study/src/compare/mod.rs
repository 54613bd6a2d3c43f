//! Measured minus modelled: row by row, along the span in degrees and in σ, stages side by side, and in words.
//!
//! Errors are measured minus modelled: positive where the wing does more than the model says.

pub mod compared_study;

pub mod comparison;

pub mod design_comparison;

pub mod integrated;

pub mod ladder;

pub mod reading;

pub mod reference;

pub mod row;

pub mod span;

pub mod stages;

pub mod study;

pub mod study_comparison;

pub mod study_words;

pub mod verdict;

pub mod wing;

pub use compared_study::ComparedStudy;
pub use comparison::Comparison;
pub use design_comparison::DesignComparison;
pub use ladder::{StepGroup, StudyLadderStep};
pub use reading::Reading;
pub use row::{ComparedRow, NotCompared};
pub use span::{ComparedStation, ProfileOrigin, SpanComparison};
pub use stages::{FittedStage, ModelledStages};
pub use study_comparison::{StudyCase, StudyComparison, StudyRow};
pub use wing::compare;
