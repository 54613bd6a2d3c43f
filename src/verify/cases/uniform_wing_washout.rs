//! The uniform wing with its elastic axis on the leading edge: it washes out and never diverges.
//!
//! With μ² = q c (c/4) a/GJ the nose-up twist is α₀ (cosh μ(L−y)/cosh μL − 1): strip theory as in `uniform_wing_twist`
//! with the load behind the axis, the way of the flapping wings.

use crate::progress::Progress;
use crate::verify::strip_wing::StripWing;
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// q over the divergence pressure that the same arm would have ahead of the axis.
const RATIOS: [f64; 4] = [0.5, 1.0, 4.0, 40.0];

/// y/L.
const STATIONS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// The case.
pub const CASE: Case = Case {
    name: "uniform-wing-washout",
    title: "Uniform wing loaded behind its axis: washout along the span",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "twist over root angle, along the span",
        reference: || {
            let at = |ratio: f64| STATIONS.map(|y| twist(ratio, y));
            RATIOS.map(at).concat()
        },
        source: "closed form (strip theory)",
        tolerance: 0.005,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn twist(ratio: f64, y: f64) -> f64 {
    let mu = 0.5 * std::f64::consts::PI * ratio.sqrt();
    (mu * (1.0 - y)).cosh() / mu.cosh() - 1.0
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let columns = level.times(8);
    let mut twists = Vec::new();
    for ratio in RATIOS {
        let wing = StripWing {
            columns,
            axis_m: 0.0,
            q_pa: ratio * StripWing::WORKED.divergence_pa(),
            ..StripWing::WORKED
        };
        let found = wing.nose_up(&wing.solve(progress)?);
        twists.extend(STATIONS.map(|y| found[(y * columns as f64).round() as usize]));
    }
    Ok(Answer::curves(format!("{columns} beams and strips"), [twists]))
}
