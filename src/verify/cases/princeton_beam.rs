//! The Princeton beam: a strip cantilever under a tip weight at an angle to its stiff plane twists.
//!
//! Dowell & Traybar, AMS reports 1194 and 1257 (NASA CR-137968 and -137969, 1975).
//!
//! ```text
//!        z flap            L = 508 mm, 12.377 × 3.2024 mm, E = 71.7 GPa, ν = 0.31
//!        |    β            tip weights 4.448, 8.896, 13.345 N, dead
//!  ======|======  y edge   β = 0: in the stiff plane
//! ```
//!
//! The measured reports could not be had, so this is verification: own geometrically exact rod solution (rotation-vector
//! component of the tip about the beam's axis at rest), and ANSYS beams (Obrezkov et al., Nonlinear Dyn. 109 (2022), as
//! listed in Exudyn's tests).

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::equilibrium;
use crate::verify::chain::{chain, section, straight};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Quantity, Scale, VerifyError};

/// Weight (N), angle (°), tip displacement in the stiff and across the soft plane (m), twist (°).
const ROD: [[f64; 5]; 15] = [
    [4.448, 15.0, 0.005210161673, 0.020801088315, 0.195869336659],
    [4.448, 30.0, 0.004751074792, 0.039949401311, 0.336422390494],
    [4.448, 45.0, 0.003965163327, 0.056055192880, 0.384129723986],
    [4.448, 60.0, 0.002862206705, 0.068129122365, 0.329034353659],
    [4.448, 75.0, 0.001502994632, 0.075571496971, 0.188476297563],
    [8.896, 15.0, 0.010625771186, 0.042125218621, 0.797532854263],
    [8.896, 30.0, 0.010147240763, 0.079456076079, 1.335067140689],
    [8.896, 45.0, 0.008888857594, 0.109041567661, 1.476674763194],
    [8.896, 60.0, 0.006654361326, 0.129923512428, 1.229177812250],
    [8.896, 75.0, 0.003568890610, 0.142214416674, 0.690658011931],
    [13.345, 15.0, 0.016502892035, 0.064496309470, 1.847219002774],
    [13.345, 30.0, 0.016777987617, 0.117902263429, 2.958157477999],
    [13.345, 45.0, 0.015342257577, 0.156587823329, 3.121333249524],
    [13.345, 60.0, 0.011716415438, 0.181921186361, 2.503908524395],
    [13.345, 75.0, 0.006328438282, 0.196124707341, 1.375496212347],
];

/// Weight (N), angle (°), tip displacement in the stiff and across the soft plane (m): ANSYS.
const ANSYS: [[f64; 4]; 10] = [
    [8.896, 15.0, 0.01061328706, 0.04208232124],
    [8.896, 30.0, 0.01011169630, 0.07939482948],
    [8.896, 45.0, 0.008837226265, 0.108987937],
    [8.896, 60.0, 0.006604665004, 0.129887616],
    [8.896, 75.0, 0.003538889001, 0.142194370],
    [13.345, 15.0, 0.01645825752, 0.06435812858],
    [13.345, 30.0, 0.01665873206, 0.117735994],
    [13.345, 45.0, 0.01518618440, 0.156467239],
    [13.345, 60.0, 0.01157837500, 0.181861627],
    [13.345, 75.0, 0.006248967384, 0.196097131],
];

const PART: Quantity = Quantity {
    unit: "m",
    source: "geometrically exact rod",
    tolerance: 0.01,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

const OTHER: Quantity = Quantity {
    source: "ANSYS beams, in Exudyn",
    confidence: Confidence::Seen,
    scale: Scale::Largest,
    ..PART
};

/// The case.
pub const CASE: Case = Case {
    name: "princeton-beam",
    title: "Princeton beam: strip under a tip weight at an angle, bending and twist",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip in the stiff plane",
            reference: || ROD.map(|row| row[2]).to_vec(),
            ..PART
        },
        Quantity {
            name: "tip across the soft plane",
            reference: || ROD.map(|row| row[3]).to_vec(),
            ..PART
        },
        Quantity {
            name: "twist of the tip",
            unit: "deg",
            reference: || ROD.map(|row| row[4]).to_vec(),
            ..PART
        },
        Quantity {
            name: "tip in the stiff plane, other code",
            reference: || ANSYS.map(|row| row[2]).to_vec(),
            ..OTHER
        },
        Quantity {
            name: "tip across the soft plane, other code",
            reference: || ANSYS.map(|row| row[3]).to_vec(),
            ..OTHER
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let elements = level.times(8);
    let mut tips = Vec::new();
    for row in ROD {
        tips.push(tip(elements, row[0], row[1], progress)?);
    }
    let curve = |k: usize| -> Vec<f64> { tips.iter().map(|tip| tip[k]).collect() };
    let of_ansys = |k: usize| -> Vec<f64> {
        let heavier = tips.iter().zip(ROD).filter(|(_, row)| row[0] > 5.0);
        heavier.map(|(tip, _)| tip[k]).collect()
    };
    Ok(Answer::curves(
        format!("{elements} beams"),
        [curve(0), curve(1), curve(2), of_ansys(0), of_ansys(1)],
    ))
}

/// Displacement of the tip in the stiff and across the soft plane (m), twist (°).
fn tip(elements: usize, weight_n: f64, angle_deg: f64, progress: &Progress) -> Result<[f64; 3], VerifyError> {
    let shear = 5.0 / 6.0 * 2_841_909.0 / (2.0 * 1.31);
    let stiffness = [2_841_909.0, shear, shear, 3.103338, 2.428734, 36.27936];
    let model = chain(straight(0.508, elements), &Vector3::z(), section(stiffness)?)?;
    let (sine, cosine) = angle_deg.to_radians().sin_cos();
    let mut loads = Loads::none(elements + 1);
    loads.force_n[elements] = weight_n * Vector3::new(0.0, -cosine, sine);
    let state = equilibrium(&model, &loads, progress)?;
    let moved = state.displacement[elements];
    let turn = state.rotation[elements].scaled_axis().x.to_degrees();
    Ok([-moved.y, moved.z, turn.abs()])
}
