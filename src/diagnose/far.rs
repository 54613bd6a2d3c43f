//! Effects that by their derivative would lie very far out at their plausible size: they may saturate, so the model is asked.

use nalgebra::DMatrix;

use crate::study::Footing;

use super::baseline::Baseline;
use super::error::{DiagnoseError, where_solved};
use super::screening::effect_of;

/// An effect whose plausible size lies further out by its derivative than this, sigma, is looked at in the full model.
pub const STRAIGHT: f64 = 100.0;

/// For every missing effect that is so far out by its derivative, how far its plausible size is in the model, sigma, what calibration
/// takes up left out; nothing of the others, and of those without a solution there.
///
/// # Errors
/// If the user asked to stop.
pub fn far(baseline: &Baseline) -> Result<Vec<Option<f64>>, DiagnoseError> {
    let (forward, data) = (baseline.forward, &baseline.data);
    let unknowns = forward.unknowns();
    let footing = baseline.fit.footing.as_ref().map(Footing::for_trials);
    let mut found = vec![None; data.missing.len()];
    for (k, &i) in data.missing.iter().enumerate() {
        let Some((_, _, scale, _)) = effect_of(&unknowns[i]) else {
            continue;
        };
        if scale / unknowns[i].sigma * baseline.directions.lengths[k] <= STRAIGHT {
            continue;
        }
        let mut there = baseline.fit.at.clone();
        there[i] = scale;
        if let Some((moved, _)) = where_solved(forward.linearize_from(footing.as_ref(), &there, &|_| false))?
        {
            let moved = &moved.value - &baseline.fit.predicted;
            let moved = DMatrix::from_column_slice(moved.len(), 1, moved.as_slice());
            found[k] = Some(baseline.whitened.directions(&moved).norm());
        }
    }
    Ok(found)
}
