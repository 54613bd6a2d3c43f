//! MacNeal & Harder's straight cantilever as a plate, on rectangles, trapezoids and parallelograms.
//!
//! MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
//!
//! ```text
//!  |__/__\__/__\__/__| L = 6, 0.2 deep, t = 0.1, E = 1e7, ν = 0.3; unit force or moment at the end; 6 cells
//!   along, their sides upright, slanted by ±45° in turn (trapezoids) or all by 45° (parallelograms)
//! ```
//!
//! The six cells are divided evenly, so that finer meshes keep their slant. Twist is by the shear along the edges, which
//! needs sides below the thickness: meshes twice as fine along.
//!
//! Beam theory with shear. Slanted cells in the plane are the sharp test of the membrane action.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::linear;
use crate::verify::cantilever::end_displacements;
use crate::verify::grid::{Grid, line_shares, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const DEPTH: f64 = 0.2;

const PART: Quantity = Quantity {
    source: "beam theory with shear (MacNeal & Harder 1985)",
    tolerance: 0.02,
    order: Order::Exempt("singular corners at the clamp"),
    ..Quantity::BLANK
};

const ALONG: Quantity = Quantity {
    reference: || vec![2.999_99e-5],
    ..PART
};

const IN_PLANE: Quantity = Quantity {
    reference: || vec![0.108_093_6],
    ..PART
};

const ACROSS: Quantity = Quantity {
    reference: || vec![0.432_093_6],
    ..PART
};

/// The case.
pub const CASE: Case = Case {
    name: "straight-beam",
    title: "Straight cantilever as a plate, upright and slanted cells, unit end loads",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "extension, rectangles",
            ..ALONG
        },
        Quantity {
            name: "in-plane shear, rectangles",
            ..IN_PLANE
        },
        Quantity {
            name: "out-of-plane shear, rectangles",
            ..ACROSS
        },
        Quantity {
            name: "extension, trapezoids",
            ..ALONG
        },
        Quantity {
            name: "in-plane shear, trapezoids",
            ..IN_PLANE
        },
        Quantity {
            name: "out-of-plane shear, trapezoids",
            ..ACROSS
        },
        Quantity {
            name: "extension, parallelograms",
            ..ALONG
        },
        Quantity {
            name: "in-plane shear, parallelograms",
            ..IN_PLANE
        },
        Quantity {
            name: "out-of-plane shear, parallelograms",
            ..ACROSS
        },
        Quantity {
            name: "twist, rectangles",
            unit: "rad",
            reference: || vec![0.034_108_55],
            source: "St Venant, J = 4.57363e-5",
            others: &[Other {
                value: "0.03208",
                source: "MacNeal & Harder 1985",
                confidence: Confidence::Memory,
            }],
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let count = [level.times(48), level.times(4)];
    let [a, b, c] = ends(&beam(count, |_| 0.0)?)?;
    let [d, e, f] = ends(&beam(count, |k| if k % 2 == 0 { 1.0 } else { -1.0 })?)?;
    let [g, h, i] = ends(&beam(count, |_| 1.0)?)?;
    let turned = twist(beam([2 * count[0], count[1]], |_| 0.0)?)?;
    Ok(Answer::new(
        format!("{} × {}", count[0], count[1]),
        [a, b, c, d, e, f, g, h, i, turned],
    ))
}

/// Six cells whose inner sides lean by `slant(k)` times the depth, k their number along, divided into `count`.
fn beam(count: [usize; 2], slant: impl Fn(usize) -> f64) -> Result<Grid, VerifyError> {
    let line = |k: usize, eta: f64| {
        let lean = if k == 0 || k == 6 { 0.0 } else { slant(k) };
        k as f64 + lean * (eta - 0.5) * DEPTH
    };
    let grid = Grid::new(count, plate(1e7, 0.3, 0.1), |xi, eta| {
        let cell = ((6.0 * xi) as usize).min(5);
        let within = 6.0 * xi - cell as f64;
        let along = line(cell, eta) * (1.0 - within) + line(cell + 1, eta) * within;
        Vector3::new(along, DEPTH * eta, 0.0)
    })?;
    Ok(grid)
}

/// Mean displacement of the end along a unit force along, in the plane and across it.
fn ends(grid: &Grid) -> Result<[f64; 3], VerifyError> {
    let mut found = [0.0; 3];
    for (axis, value) in found.iter_mut().enumerate() {
        let moved = end_displacements(grid, Vector3::ith(axis, 1.0))?;
        *value = moved.iter().map(|u| u[axis]).sum::<f64>() / moved.len() as f64;
    }
    Ok(found)
}

/// Turn of the end about the beam under a unit torque spread over it.
fn twist(mut grid: Grid) -> Result<f64, VerifyError> {
    let (clamp, end) = (grid.side(false), grid.side(true));
    grid.hold(&clamp, [true; 6]);
    let mut loads = grid.end_force(Vector3::zeros());
    for (&node, share) in end.iter().zip(line_shares(&grid.model, &end)) {
        loads.moment_n_m[node].x = share / DEPTH;
    }
    let moved = linear(&grid.model, &loads)?;
    let (low, high) = (end[0], end[end.len() - 1]);
    Ok((moved[high][0].z - moved[low][0].z) / DEPTH)
}
