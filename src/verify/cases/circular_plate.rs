//! A thin round plate under even pressure, clamped or simply supported.
//!
//! ```text
//!   ↓ ↓ q ↓ ↓     centre deflection in q R⁴/D: 1/64 clamped, (5 + ν)/(64 (1 + ν)) supported; ν = 0.3
//!  |_________| 2R
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, disc, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

const POISSON: f64 = 0.3;

const PART: Quantity = Quantity {
    unit: "q R⁴/D",
    source: "closed form (Timoshenko & Woinowsky-Krieger)",
    tolerance: 0.003,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "circular-plate",
    title: "Thin round plate under even pressure, clamped and simply supported",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "clamped",
            reference: || vec![1.0 / 64.0],
            ..PART
        },
        Quantity {
            name: "simply supported",
            reference: || vec![(5.0 + POISSON) / (64.0 * (1.0 + POISSON))],
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    Ok(Answer::new(
        format!("{cells} across"),
        [centre(cells, true)?, centre(cells, false)?],
    ))
}

fn centre(cells: usize, clamped: bool) -> Result<f64, VerifyError> {
    let thickness = 1e-3;
    let mut grid = Grid::new([cells, cells], plate(1.0, POISSON, thickness), disc)?;
    grid.hold(&grid.rim(), [true, true, true, clamped, clamped, true]);
    let bending = thickness.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    let loads = grid.pressure(Vector3::z());
    Ok(linear(&grid.model, &loads)?[grid.centre()][0].z * bending)
}
