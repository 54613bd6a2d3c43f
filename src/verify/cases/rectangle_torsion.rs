//! The torsion constant of rectangles from square to strip.
//!
//! Timoshenko & Goodier, Theory of Elasticity, §109: the exact series.

use crate::progress::Progress;
use crate::structure::Section;
use crate::structure::section::BeamMaterial;
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// b/t, J/(b t³).
const TABLE: [[f64; 2]; 9] = [
    [1.0, 0.140577],
    [1.5, 0.195761],
    [2.0, 0.228682],
    [3.0, 0.263317],
    [5.0, 0.291317],
    [10.0, 0.312325],
    [20.0, 0.322829],
    [50.0, 0.329132],
    [100.0, 0.331233],
];

/// The case.
pub const CASE: Case = Case {
    name: "rectangle-torsion",
    title: "Torsion constant of rectangular sections, b/t = 1 to 100",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "torsion constant J",
        unit: "b t³",
        reference: || TABLE.map(|row| row[1]).to_vec(),
        source: "exact series",
        tolerance: 5e-6,
        order: Order::Exempt("no mesh"),
        ..Quantity::BLANK
    }],
    short: Level::Coarse,
    run,
};

fn run(_: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let material = BeamMaterial {
        e_pa: 200e9,
        g_pa: 80e9,
        density_kg_m3: 1.0,
    };
    let thickness = 1e-4_f64;
    let found = TABLE.map(|[ratio, _]| {
        let section = Section::rectangle(ratio * thickness, thickness, &material);
        section.gj_n_m2() / material.g_pa / (ratio * thickness.powi(4))
    });
    Ok(Answer::curves("no mesh", [found.to_vec()]))
}
