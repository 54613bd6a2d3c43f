//! Natural frequencies of a cantilevered plate.
//!
//! ```text
//!  |‾‾‾‾‾| b   λ = ω a² √(ρ t/D), a from the clamp to the free edge, ν = 0.3; modes 1 to 4
//!  |_____|     own Ritz solution with 16 × 16 Legendre polynomials, which moves by less than 1e-4 from 14 × 14
//!     a
//! ```

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::frequencies;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// a/b and λ of four modes.
const TABLE: [(f64, [f64; 4]); 5] = [
    (0.5, [3.4928, 5.3511, 10.181, 19.075]),
    (1.0, [3.4710, 8.5065, 21.285, 27.199]),
    (2.0, [3.4393, 14.802, 21.434, 48.179]),
    (3.0, [3.4192, 21.138, 21.363, 60.021]),
    (5.0, [3.3976, 21.267, 33.916, 59.674]),
];

const PART: Quantity = Quantity {
    unit: "√(D/(ρ t a⁴))",
    source: "Ritz, 16 × 16 Legendre polynomials",
    tolerance: 0.01,
    order: Order::Exempt("singular corners at the clamp"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "cantilever-plate-frequencies",
    title: "Natural frequencies of cantilevered plates, a/b = 0.5 to 5",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "modes 1 to 4, a/b = 0.5",
            reference: || TABLE[0].1.to_vec(),
            ..PART
        },
        Quantity {
            name: "modes 1 to 4, a/b = 1",
            reference: || TABLE[1].1.to_vec(),
            others: &[Other {
                value: "3.4917, 8.5246, 21.429, 27.331",
                source: "Leissa 1973",
                confidence: Confidence::Memory,
            }],
            ..PART
        },
        Quantity {
            name: "modes 1 to 4, a/b = 2",
            reference: || TABLE[2].1.to_vec(),
            ..PART
        },
        Quantity {
            name: "modes 1 to 4, a/b = 3",
            reference: || TABLE[3].1.to_vec(),
            ..PART
        },
        Quantity {
            name: "modes 1 to 4, a/b = 5",
            reference: || TABLE[4].1.to_vec(),
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    let mut found: [Vec<f64>; 5] = Default::default();
    for (found, (ratio, _)) in found.iter_mut().zip(TABLE) {
        let sheet = plate(70e9, 0.3, 1e-3);
        let mut grid = Grid::new([cells, cells], sheet, |xi, eta| {
            Vector3::new(0.4 * xi, 0.4 / ratio * eta, 0.0)
        })?;
        grid.hold(&grid.side(false), [true; 6]);
        let bending = sheet.e_pa * sheet.thickness_m.powi(3) / (12.0 * (1.0 - sheet.poisson.powi(2)));
        let unit = (bending / (sheet.density_kg_m3 * sheet.thickness_m)).sqrt() / (0.4 * 0.4);
        *found = frequencies(&grid.model, 4, progress)?;
        found.iter_mut().for_each(|frequency| *frequency *= TAU / unit);
    }
    Ok(Answer::curves(format!("{cells} × {cells}"), found))
}
