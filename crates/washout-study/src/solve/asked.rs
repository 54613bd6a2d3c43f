//! What can be asked for besides the loaded shape.

use std::ops::RangeInclusive;

use crate::study::StudyError;
use crate::study::uncertainty::FEWEST_SAMPLES;
use crate::wing::WingError;

use super::error::SolveError;

/// Phases of the periodic motion that can be asked for.
const PHASES: RangeInclusive<u16> = 2..=720;
/// Phases that stand still that can be asked for.
const STANDING_PHASES: RangeInclusive<u16> = 2..=99;

/// What is asked for besides the loaded shape.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Asked {
    /// Solves by which the ranges of the assumed inputs are propagated to a band, 16 or more.
    pub uncertainty: Option<usize>,
    /// Refine the mesh until it leaves no more than this share of the tip's twist.
    pub accuracy: Option<f64>,
    /// The wing over its stroke.
    pub stroke: Option<OverStroke>,
}

/// How the wing is solved over its stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OverStroke {
    /// Its periodic motion, with inertia and damping, at 2 … 720 phases of the whole stroke.
    Periodic(u16),
    /// As if each of 2 … 99 phases from mid-stroke to the reversal stood still.
    QuasiStatic(u16),
}

impl Asked {
    /// Refuses what is out of range, before anything is solved.
    ///
    /// # Errors
    /// With the option and its range.
    pub fn check(&self) -> Result<(), SolveError> {
        match self.stroke {
            Some(OverStroke::Periodic(phases)) => refuse_outside("--stroke", phases, PHASES)?,
            Some(OverStroke::QuasiStatic(phases)) => {
                refuse_outside("--stroke-quasi-static", phases, STANDING_PHASES)?;
            }
            None => {}
        }
        match self.uncertainty {
            Some(asked) if asked < FEWEST_SAMPLES => Err(SolveError::Band(StudyError::TooFewSamples {
                asked,
                fewest: FEWEST_SAMPLES,
            })),
            _ => Ok(()),
        }
    }
}

fn refuse_outside(question: &'static str, phases: u16, range: RangeInclusive<u16>) -> Result<(), WingError> {
    if range.contains(&phases) {
        return Ok(());
    }
    let reason = format!(
        "the number of phases must lie in {} … {}",
        range.start(),
        range.end()
    );
    Err(WingError::Question { question, reason })
}
