//! What a sweep is: its base, its axes, how its cases are chosen. It stands in the folder of the sweep, so that any machine can
//! take part.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axis::Axis;
use super::error::SweepError;
use super::points::{Method, points};

/// What a sweep is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SweepPlan {
    /// The design or study.
    pub base: PathBuf,
    /// Changes of the base for all cases, as `--set` takes them.
    pub set: Vec<String>,
    /// Its axes.
    pub axes: Vec<Axis>,
    /// How the cases are chosen.
    pub method: Method,
    /// How many samples, unless it is a grid.
    pub samples: usize,
    /// Seed of the samples.
    pub seed: u32,
    /// Cases in one task.
    pub task_size: usize,
}

impl SweepPlan {
    /// Values of every case, as text in the order of the axes.
    ///
    /// # Errors
    /// As [`points`].
    pub fn points(&self) -> Result<Vec<Vec<String>>, SweepError> {
        points(&self.axes, self.method, self.samples, self.seed)
    }

    /// The changes of the base for a case.
    pub fn sets(&self, point: &[String]) -> Vec<String> {
        let own = self.axes.iter().zip(point);
        let own = own.map(|(axis, value)| format!("{}={value}", axis.key));
        self.set.iter().cloned().chain(own).collect()
    }
}
