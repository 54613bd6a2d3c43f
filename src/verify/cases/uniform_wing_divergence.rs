//! Torsional divergence of the clamped uniform wing, from the feedback of the air at any pressure.
//!
//! Bisplinghoff, Ashley & Halfman (1955), section 8-2: q_D = (π/2L)² GJ/(e c a) = 392.699 Pa for the set-up of
//! `uniform_wing_twist`. By hand: with the twist linear in an element and each strip cut at two places the eigenvalue is too
//! large by (λh)²/12, 0.32 % with 8 elements.

use crate::progress::Progress;
use crate::verify::strip_wing::StripWing;
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// Pressures at which the feedback is asked, over q_D.
const ASKED: [f64; 4] = [0.05, 0.5, 0.95, 2.0];

/// The case.
pub const CASE: Case = Case {
    name: "uniform-wing-divergence",
    title: "Torsional divergence of a uniform wing, asked at four pressures",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "divergence pressure",
        unit: "Pa",
        reference: || vec![StripWing::WORKED.divergence_pa(); ASKED.len()],
        source: "closed form (Bisplinghoff, Ashley & Halfman 1955)",
        tolerance: 5e-4,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let columns = level.times(8);
    let mut found = Vec::new();
    for ratio in ASKED {
        let wing = StripWing {
            columns,
            q_pa: ratio * StripWing::WORKED.divergence_pa(),
            ..StripWing::WORKED
        };
        found.push(wing.found_divergence_pa(progress)?);
    }
    Ok(Answer::curves(format!("{columns} beams and strips"), [found]))
}
