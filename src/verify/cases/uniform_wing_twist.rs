//! The clamped uniform wing in strip theory: twist along the span and lift, up to nine tenths of divergence.
//!
//! Bisplinghoff, Ashley & Halfman, Aeroelasticity (1955), section 8-2: with λ² = q c e a/GJ the nose-up twist is
//! α₀ (cos λ(L−y)/cos λL − 1) and the lift grows by tan λL/(λL).
//!
//! ```text
//!   |=========   GJ = 10, L = 1, c = 0.2, e = 0.05, a = 2π: q_D = 392.699 Pa
//!   |_________   set-up of AeroBeams' torsional divergence example
//! ```

use crate::progress::Progress;
use crate::verify::strip_wing::StripWing;
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// q/q_D.
const RATIOS: [f64; 5] = [0.1, 0.25, 0.5, 0.75, 0.9];

/// y/L.
const STATIONS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

const PART: Quantity = Quantity {
    source: "closed form (Bisplinghoff, Ashley & Halfman 1955)",
    tolerance: 0.005,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "uniform-wing-twist",
    title: "Uniform wing in strip theory: twist and lift at 0.1 to 0.9 of the divergence pressure",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "twist over root angle, along the span",
            reference: || {
                let at = |ratio: f64| STATIONS.map(|y| twist(ratio, y));
                RATIOS.map(at).concat()
            },
            ..PART
        },
        Quantity {
            name: "lift over that of the rigid wing",
            reference: || RATIOS.map(|ratio| lambda(ratio).tan() / lambda(ratio)).to_vec(),
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

/// λ L.
fn lambda(ratio: f64) -> f64 {
    0.5 * std::f64::consts::PI * ratio.sqrt()
}

fn twist(ratio: f64, y: f64) -> f64 {
    (lambda(ratio) * (1.0 - y)).cos() / lambda(ratio).cos() - 1.0
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let columns = level.times(8);
    let (mut twists, mut lifts) = (Vec::new(), Vec::new());
    for ratio in RATIOS {
        let wing = StripWing {
            columns,
            q_pa: ratio * StripWing::WORKED.divergence_pa(),
            ..StripWing::WORKED
        };
        let solution = wing.solve(progress)?;
        let found = wing.nose_up(&solution);
        twists.extend(STATIONS.map(|y| found[(y * columns as f64).round() as usize]));
        let lift: f64 = solution.air_force_n.iter().map(|force| force[2]).sum();
        let rigid =
            std::f64::consts::TAU * wing.root_deg.to_radians() * wing.q_pa * wing.length_m * wing.chord_m;
        lifts.push(lift / rigid);
    }
    Ok(Answer::curves(
        format!("{columns} beams and strips"),
        [twists, lifts],
    ))
}
