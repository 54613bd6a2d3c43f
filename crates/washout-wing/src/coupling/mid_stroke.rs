//! The design at mid-stroke, about which its motion is found.

use super::error::CouplingError;
use crate::effects::{Card, Need, bind};
use crate::input::design::Design;

/// Names of a design's effects that are made from its motion, or act nowhere but off mid-stroke: the motion is found
/// without them.
///
/// # Errors
/// If its effects are not what their cards ask for.
pub fn left_out(design: &Design) -> Result<Vec<String>, CouplingError> {
    let bound = bind(design)?;
    let cards = bound.iter().map(|bound| bound.effect.card());
    Ok(cards
        .filter(is_left_out)
        .map(|card| card.name.to_string())
        .collect())
}

fn is_left_out(card: &Card) -> bool {
    let moves = |need: &Need| matches!(need, Need::Motion | Need::OffMidStroke);
    card.needs.iter().any(moves)
}

/// The design with those of its effects alone that act on its motion: what it moves as.
///
/// # Errors
/// As [`left_out`].
pub fn moving(design: &Design) -> Result<Design, CouplingError> {
    let bound = bind(design)?;
    let cards = bound.iter().map(|bound| bound.effect.card());
    let acting: Vec<String> = (cards.filter(|card| !is_left_out(card)))
        .map(|card| card.name.to_string())
        .collect();
    let mut moving = design.clone();
    moving.effects.retain(|name, _| acting.contains(name));
    Ok(moving)
}

/// The design at mid-stroke, as it moves.
pub(super) fn at_mid_stroke(design: &Design) -> Result<Design, CouplingError> {
    let mut still = moving(design)?;
    if let Some(flapping) = &mut still.flapping {
        flapping.phase_deg = 0.0.into();
    }
    Ok(still)
}
