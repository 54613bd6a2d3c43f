//! What a fit is to do.

use super::forward::WarmStart;
use super::noise::Noise;

/// What a fit is to do.
#[derive(Debug, Clone)]
pub struct Task<'a> {
    /// Observables to fit.
    pub rows: &'a [usize],
    /// Their scatter.
    pub noise: &'a Noise,
    /// Unknowns to move.
    pub free: &'a [usize],
    /// Where to start.
    pub start: &'a [f64],
    /// What the model left where it was asked before, near the start. If it is for trials, all solves of the search are.
    pub warm_start: Option<&'a WarmStart>,
    /// Q below which the fit is of use, if it is of none above: a search that is far from it is given up.
    pub of_use_below: Option<f64>,
}
