//! How the twist of each strip follows the periodic motion.

use nalgebra::DVector;

use super::fields::Fields;
use super::solution::Solution;
use super::strips::Strip;
use super::wing::Wing;

/// Twist of a strip: along the standing path, and by mode.
#[derive(Debug, Clone)]
pub(super) struct StripPath {
    pub r_m: f64,
    pub standing: [f64; 2],
    pub by_mode: DVector<f64>,
}

/// The paths of all strips of a wing.
pub(super) fn strip_paths(wing: &Wing, still: &Solution, fields: &Fields) -> Vec<StripPath> {
    let strips = &wing.strips;
    let [shapes, rest] = [&still.state, &still.rest].map(|state| strips.shapes(state));
    let changes = |field: &[f64]| strips.shape_changes(&fields.displacement(field));
    let by_pressure: Vec<f64> = {
        let [shape, more] = &fields.standing;
        changes(&shape.iter().zip(more).map(|(a, b)| a + b).collect::<Vec<f64>>())
    };
    let by_mode: Vec<Vec<f64>> = fields.modes.iter().map(|mode| changes(mode)).collect();
    let turn = |strip: usize, change: &[f64]| {
        let (y, z) = (shapes[6 * strip + 1], shapes[6 * strip + 2]);
        let (dy, dz) = (change[6 * strip + 1], change[6 * strip + 2]);
        (y * dz - z * dy) / (y * y + z * z)
    };
    let angle = |shapes: &[f64], strip: usize| shapes[6 * strip + 2].atan2(shapes[6 * strip + 1]);
    let path = |(index, strip): (usize, &Strip)| {
        let twist = angle(&shapes, index) - angle(&rest, index);
        StripPath {
            r_m: strip.r_m,
            standing: [twist, turn(index, &by_pressure) - twist],
            by_mode: DVector::from_iterator(by_mode.len(), by_mode.iter().map(|change| turn(index, change))),
        }
    };
    strips.strips.iter().enumerate().map(path).collect()
}
