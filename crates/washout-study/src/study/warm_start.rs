//! What a solved point leaves for others nearby: its cases, their derivatives, and how their shapes answer to the unknowns.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::case::Solved;
use super::columns::Column;
use crate::coupling::{Care, Near};

/// A point at which all cases were solved.
#[derive(Debug)]
pub(super) struct SolvedPoint {
    /// Value of every unknown.
    pub at: Vec<f64>,
    /// Each case there.
    pub cases: Vec<Stand>,
}

/// A solved case, and what is known about it.
#[derive(Debug, Clone)]
pub(super) struct Stand {
    /// The case.
    pub solved: Arc<Solved>,
    /// What its instrument reads.
    pub reading: Arc<Vec<f64>>,
    /// Derivatives, by index of the unknown.
    pub columns: BTreeMap<usize, Arc<Column>>,
}

impl SolvedPoint {
    /// Whether a case is the same at another point; `touches`: whether an unknown acts on it.
    pub fn is_same(&self, at: &[f64], touches: impl Fn(usize) -> bool) -> bool {
        let mut values = self.at.iter().zip(at).enumerate();
        values.all(|(unknown, (old, new))| old.to_bits() == new.to_bits() || !touches(unknown))
    }

    /// Where the solve of a case at another point starts: its shape there to first order, as far as that is known.
    pub fn near(&self, case: usize, at: &[f64], care: Care) -> Near<'_> {
        let stand = &self.cases[case];
        let mut step: Option<Vec<f64>> = None;
        for (unknown, column) in &stand.columns {
            let change = at[*unknown] - self.at[*unknown];
            if let (Some(shape), true) = (&column.shape, change != 0.0) {
                let step = step.get_or_insert_with(|| vec![0.0; shape.len()]);
                step.iter_mut()
                    .zip(shape)
                    .for_each(|(s, rate)| *s += change * rate);
            }
        }
        Near {
            solution: &stand.solved.at.solution,
            step,
            care,
        }
    }
}
