//! The wing of Tang and Dowell under its own weight: sag, chordwise sag and the twist that the two make together.
//!
//! Tang & Dowell, AIAA J. 39 (2001) 1430-1441; design and measurement as shipped, with their sources.
//!
//! ```text
//!   |===============▮  root pitched nose-up by 0, 45, 90°: it sags across and along its chord,
//!   |                  and at 45° the weight outboard twists it
//! ```
//!
//! It agrees if it is within two of the standard deviations that were assumed before any comparison was run: 1 mm of 56,
//! 0.05 mm of 1.35, 0.01 of 0.12 degrees. With both bending stiffnesses a closed form gives 0.128°.

use crate::input::measurement::Channel;
use crate::progress::Progress;
use crate::verify::measured_wing::TANG_DOWELL;
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, Scale, VerifyError};

const PART: Quantity = Quantity {
    source: "measured by Tang & Dowell 2001, in AeroBeams",
    confidence: Confidence::Seen,
    scale: Scale::Largest,
    order: Order::Exempt("measured"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "tang-dowell-gravity",
    title: "Wing of Tang and Dowell under its own weight at root pitches of 0, 45 and 90°; limit: two assumed σ",
    kind: Kind::Validation,
    quantities: &[
        Quantity {
            name: "sag of the tip across the chord, 0 and 45°",
            unit: "mm",
            reference: || TANG_DOWELL.read(&at(&["0", "45"]), Channel::Deflection),
            tolerance: 2.0 / 56.327,
            ..PART
        },
        Quantity {
            name: "sag of the tip along the chord, 45 and 90°",
            unit: "mm",
            reference: || TANG_DOWELL.read(&at(&["45", "90"]), Channel::ChordwiseDisplacement),
            tolerance: 0.1 / 1.353,
            ..PART
        },
        Quantity {
            name: "twist of the tip, 45°",
            unit: "deg",
            reference: || TANG_DOWELL.read(&at(&["45"]), Channel::Twist),
            tolerance: 0.02 / 0.12005,
            others: &[Other {
                value: "0.128",
                source: "closed form with both bending stiffnesses",
                confidence: Confidence::Derived,
            }],
            ..PART
        },
    ],
    short: Level::Coarse,
    run,
};

fn at(pitches_deg: &[&str]) -> Vec<String> {
    pitches_deg
        .iter()
        .map(|pitch| format!("gravity-{pitch}"))
        .collect()
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let tip = |pitch_deg: f64| TANG_DOWELL.tip(&[("gravity.root_pitch_deg", pitch_deg)], level, progress);
    let (level_tip, pitched, upright) = (tip(0.0)?, tip(45.0)?, tip(90.0)?);
    Ok(Answer::curves(
        format!("{} bays", level.times(20)),
        [
            vec![level_tip.deflection_mm, pitched.deflection_mm],
            vec![pitched.chordwise_mm, upright.chordwise_mm],
            vec![pitched.twist_deg],
        ],
    ))
}
