//! The design at mid-stroke, about which its motion is found.

use super::error::CouplingError;
use crate::effects::{Need, bind};
use crate::input::design::Design;

/// Names of a design's effects that are made from its motion, or act nowhere but off mid-stroke: the motion is found
/// without them.
///
/// # Errors
/// If its effects are not what their cards ask for.
pub fn left_out(design: &Design) -> Result<Vec<String>, CouplingError> {
    let names = bind(design)?.into_iter().filter_map(|bound| {
        let card = bound.effect.card();
        let moves = |need: &Need| matches!(need, Need::Motion | Need::OffMidStroke);
        card.needs.iter().any(moves).then(|| card.name.to_string())
    });
    Ok(names.collect())
}

/// The design at mid-stroke, without [`left_out`].
pub(super) fn at_mid_stroke(design: &Design) -> Result<Design, CouplingError> {
    let mut still = design.clone();
    for name in left_out(design)? {
        still.effects.remove(&name);
    }
    if let Some(flapping) = &mut still.flapping {
        flapping.phase_deg = 0.0.into();
    }
    Ok(still)
}
