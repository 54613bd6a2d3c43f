//! Causes that no effect of the library is: moments and springs that somebody overlooked. On a bench, where the air does nothing, a place that is
//! soft in torsion, though the library has a loss of torsion (`rod-torsion-loss`).

use super::{Blind, BlindError, Kind};
use crate::input::measurement::Formulas;
use crate::progress::Progress;
use crate::study::draws::Draws;
use crate::study::{Campaign, Forward};
use crate::synthesize::{Hidden, hide::hide};

/// Misfit of a cause of its first size, sigma, below which no size of it can be meant.
const INVISIBLE: f64 = 1e-6;
/// Misfit that it leaves to a model that may absorb what it can, sigma: drawn evenly from this range; a soft place may stay
/// below.
const MISFIT: [f64; 2] = [12.0, 30.0];
/// Largest compliance of a soft place over that of the sound rod.
const SOFTEST: f64 = 50.0;
/// Powers of frequency and amplitude by which a moment grows.
const LAWS: [[i32; 2]; 6] = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 2], [2, 1]];

/// Where along the span something acts: a bump, a stretch with blurred ends, a slope from one place to the tip, or two bumps, of any width.
///
/// A diagnosis fits one bump of one width; a cause of nobody's library has that by chance at most.
fn shape(draws: Draws, widest: f64) -> String {
    let place = 0.2 + 0.6 * draws.uniform(5, 0);
    let width = widest * (0.3 + 0.7 * draws.uniform(5, 5));
    let bump = |place: f64| format!("exp(-((x - {place:.3}) / {width:.3})^2)");
    match (draws.uniform(5, 6) * 4.0) as usize {
        0 => bump(place),
        1 => format!(
            "0.5 * (tanh((x - {:.3}) / 0.02) - tanh((x - {:.3}) / 0.02))",
            place - width,
            place + width
        ),
        2 => format!("max(x - {place:.3}, 0) / {:.3}", 1.0 - place),
        _ => format!("({} + 0.6 * {})", bump(place), bump(1.0 - 0.5 * place)),
    }
}

/// One such cause.
///
/// # Errors
/// If the wing with it has no solution.
pub fn novel(blind: &Blind, draws: Draws, progress: &Progress) -> Result<Hidden, BlindError> {
    let sign = if draws.uniform(5, 1) < 0.5 { 1.0 } else { -1.0 };
    let flaps = (blind.study.cases.iter()).any(|case| case.loaded.design.flapping.is_some());
    let is_in_air = flaps || (blind.study.cases.iter()).any(|case| case.loaded.design.steady.is_some());
    let (acts_on, formula) = match (draws.uniform(5, 2) * 5.0) as usize {
        0..=2 if !flaps => ("moment", shape(draws, 0.25)),
        0 | 1 => {
            let [a, b] = LAWS[(draws.uniform(5, 3) * LAWS.len() as f64) as usize];
            (
                "moment",
                format!("(f / 25)^{a} * (Phi / 0.6)^{b} * {}", shape(draws, 0.25)),
            )
        }
        2 => ("moment", format!("max(f - 20, 0) / 5 * {}", shape(draws, 0.25))),
        _ if is_in_air => ("moment", format!("-twist * {}", shape(draws, 0.3))),
        _ => ("torsion", shape(draws, 0.15)),
    };
    // a first size, and the size that makes the misfit that is wanted
    let target = MISFIT[0] + (MISFIT[1] - MISFIT[0]) * draws.uniform(5, 4);
    let is_soft = acts_on == "torsion";
    let first = if is_soft { 1.0 } else { 1e-4 };
    let with = |size: f64| {
        let expression = match is_soft {
            true => format!("1 / (1 + {size:?} * {formula})"),
            false => format!("{size:?} * {formula}"),
        };
        Hidden::own("overlooked", acts_on, &expression)
    };
    let seen = |size: f64| -> Result<f64, BlindError> {
        let mut wing = blind.study.clone();
        wing.experiments.clear();
        hide(&mut wing, &[with(size)], Formulas::Same)?;
        let campaign = Campaign::new(&wing, &[], &progress.unseen())?;
        Ok(blind.outlook.distance(&campaign.predict(&campaign.start())?))
    };
    let distance = seen(first)?;
    if distance < INVISIBLE {
        return Err(BlindError::NoCase {
            kind: Kind::Novel.word(),
            reason: "what was to be overlooked moves no reading",
        });
    }
    // what is soft saturates, what is a load grows nearly in proportion: one more step does
    let mut size = first * target / distance;
    if is_soft {
        size = size.min(SOFTEST);
    }
    if let Ok(distance) = seen(size) {
        size *= (target / distance).clamp(0.5, 2.0);
    }
    Ok(with(if is_soft { size.min(SOFTEST) } else { sign * size }))
}
