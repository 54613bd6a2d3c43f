//! What limits how far the numbers of a run hold.

use super::summary::RunSummary;
use super::text::{number, significant};

/// Below this ratio of the lowest natural frequency to that of the flapping, the shape does not follow its load.
pub const SLOW_RATIO: f64 = 1.5;

/// Sentences for a reader who must not take the numbers for more than they are; none if nothing is the matter.
pub fn warnings(summary: &RunSummary) -> Vec<String> {
    let (solve, numbers) = (&summary.solve, &summary.engineering);
    let mut warnings = Vec::new();
    if solve.negative_pivots > 0 {
        warnings.push(format!(
            "the loaded shape is not stable ({} negative pivots): the real wing would leave it",
            solve.negative_pivots
        ));
    }
    if let Some(ratio) = numbers.frequency_ratio.filter(|ratio| *ratio < SLOW_RATIO) {
        warnings.push(format!(
            "the lowest natural frequency in air is only {} times that of the flapping: twist at mid-stroke is not the \
             quasi-static one",
            number(ratio, 2)
        ));
    }
    for (part, extreme) in [
        ("rod, in shear", &numbers.rod_shear_stress),
        ("rod, in bending", &numbers.rod_bending_stress),
        ("spars", &numbers.spar_stress),
        ("film", &numbers.film_stress),
    ] {
        let Some(extreme) = extreme
            .as_ref()
            .filter(|peak| peak.margin.is_some_and(|m| m < 1.0))
        else {
            continue;
        };
        warnings.push(format!(
            "{part}: {} MPa at {} mm is beyond the strength of {} MPa",
            significant(extreme.stress_mpa, 3),
            number(extreme.r_mm, 1),
            significant(extreme.strength_mpa.unwrap_or_default(), 3)
        ));
    }
    warnings
}
