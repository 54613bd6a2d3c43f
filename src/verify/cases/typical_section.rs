//! The typical section: a rigid wing on a pitch spring.
//!
//! Bisplinghoff, Ashley & Halfman (1955), section 8-1: θ_e = θ₀ (q/q_D)/(1 − q/q_D) with q_D = K/(S e a). Here the
//! spring stands on the leading edge, ahead of the centre of pressure: e and q_D are negative and the section washes out.
//!
//! ```text
//!    spring ○──────────   K = 0.05 N·m/rad, S = 0.2 m², e = −c/4 = −0.05 m, a = 2π: q_D = −0.7958 Pa; GJ = 100 N·m²
//!               ↑ lift at c/4
//! ```

use crate::progress::Progress;
use crate::verify::strip_wing::StripWing;
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// q/|q_D|.
const RATIOS: [f64; 5] = [0.1, 0.25, 0.5, 1.0, 2.0];

const STIFFNESS_N_M_PER_RAD: f64 = 0.05;

/// The case.
pub const CASE: Case = Case {
    name: "typical-section",
    title: "Typical section: rigid wing on a pitch spring",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "elastic over root angle",
        reference: || RATIOS.map(|ratio| -ratio / (1.0 + ratio)).to_vec(),
        source: "closed form (Bisplinghoff, Ashley & Halfman 1955)",
        tolerance: 1e-3,
        order: Order::Exempt("rigid: exact for any mesh"),
        ..Quantity::BLANK
    }],
    short: Level::Coarse,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let columns = level.times(4);
    let rigid = StripWing {
        columns,
        gj_n_m2: 100.0,
        rib_n_m2: 1e3,
        axis_m: 0.0,
        pitch_stiffness_n_m_per_rad: Some(STIFFNESS_N_M_PER_RAD),
        ..StripWing::WORKED
    };
    let area = rigid.length_m * rigid.chord_m;
    let unit = STIFFNESS_N_M_PER_RAD / (area * rigid.centre * rigid.chord_m * std::f64::consts::TAU);
    let mut found = Vec::new();
    for ratio in RATIOS {
        let wing = StripWing {
            q_pa: ratio * unit,
            ..rigid
        };
        let twist = wing.nose_up(&wing.solve(progress)?);
        found.push(twist[columns / 2]);
    }
    Ok(Answer::curves(format!("{columns} beams and strips"), [found]))
}
