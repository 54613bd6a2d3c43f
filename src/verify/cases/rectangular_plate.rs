//! Thin rectangular plates under even pressure and point loads, simply supported or clamped.
//!
//! MacNeal & Harder 1985; Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells.
//!
//! ```text
//!   a ┌──────────┐   centre deflection in q a⁴/D (pressure) or P a²/D (point load), a the short side; ν = 0.3
//!     │  quarter │   Navier's series, Ritz solutions with 20 terms a side
//!     └──────────┘ b
//! ```
//!
//! For b/a = 5, clamped, the 2.56e-3 of 1985 is 1.7 % too low: Ritz's solution bounds it from below.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const POISSON: f64 = 0.3;

const PRESSURE: Quantity = Quantity {
    unit: "q a⁴/D",
    source: "Navier's series",
    tolerance: 0.005,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

const POINT: Quantity = Quantity {
    unit: "P a²/D",
    order: Order::Exempt("point load"),
    ..PRESSURE
};

/// The case.
pub const CASE: Case = Case {
    name: "rectangular-plate",
    title: "Thin rectangular plates, simply supported and clamped, under pressure and point load",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "square, supported, pressure",
            reference: || vec![4.062_352_7e-3],
            ..PRESSURE
        },
        Quantity {
            name: "square, clamped, pressure",
            reference: || vec![1.265_319_1e-3],
            source: "Ritz, 20 terms a side",
            others: &[Other {
                value: "1.267e-3",
                source: "textbook value, in Ko 2017",
                confidence: Confidence::Seen,
            }],
            ..PRESSURE
        },
        Quantity {
            name: "square, supported, point load",
            reference: || vec![1.160_083_9e-2],
            ..POINT
        },
        Quantity {
            name: "b/a = 5, supported, pressure",
            reference: || vec![1.297_083_2e-2],
            tolerance: 0.01,
            ..PRESSURE
        },
        Quantity {
            name: "b/a = 5, clamped, pressure",
            reference: || vec![2.604_227e-3],
            source: "Ritz, 20 terms a side",
            tolerance: 0.01,
            others: &[Other {
                value: "2.56e-3",
                source: "MacNeal & Harder 1985",
                confidence: Confidence::Seen,
            }],
            ..PRESSURE
        },
        Quantity {
            name: "b/a = 5, supported, point load",
            reference: || vec![1.696_099_1e-2],
            tolerance: 0.01,
            ..POINT
        },
        Quantity {
            name: "square, clamped, point load",
            reference: || vec![5.612e-3],
            source: "textbook value; Ritz's bound from below 5.577e-3",
            confidence: Confidence::Memory,
            ..POINT
        },
        Quantity {
            name: "b/a = 5, clamped, point load",
            reference: || vec![7.23e-3],
            source: "MacNeal & Harder 1985",
            confidence: Confidence::Memory,
            ..POINT
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    let mut found = [0.0; 8];
    let set_ups = [
        (1.0, false, false),
        (1.0, true, false),
        (1.0, false, true),
        (5.0, false, false),
        (5.0, true, false),
        (5.0, false, true),
        (1.0, true, true),
        (5.0, true, true),
    ];
    for (value, (long, clamped, point)) in found.iter_mut().zip(set_ups) {
        *value = quarter(cells, long, clamped, point)?;
    }
    Ok(Answer::new(format!("{cells} × {cells} a quarter"), found))
}

/// Centre deflection of a quarter plate with sides 1/2 × `long`/2.
fn quarter(cells: usize, long: f64, clamped: bool, point: bool) -> Result<f64, VerifyError> {
    let thickness = 1e-3;
    let mut grid = Grid::new([cells, cells], plate(1.0, POISSON, thickness), |xi, eta| {
        Vector3::new(0.5 * xi, 0.5 * long * eta, 0.0)
    })?;
    let all: Vec<usize> = (0..grid.model.nodes.len()).collect();
    grid.hold(&all, [true, true, false, false, false, true]);
    grid.hold(&grid.side(false), [false, false, false, false, true, false]);
    grid.hold(&grid.edge(false), [false, false, false, true, false, false]);
    let outer = [grid.side(true), grid.edge(true)].concat();
    grid.hold(&outer, [false, false, true, clamped, clamped, false]);
    let loads = if point {
        let mut loads = Loads::none(grid.model.nodes.len());
        loads.force_n[grid.node([0, 0])].z = 0.25;
        loads
    } else {
        grid.pressure(Vector3::z())
    };
    let bending = thickness.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    Ok(linear(&grid.model, &loads)?[grid.node([0, 0])][0].z * bending)
}
