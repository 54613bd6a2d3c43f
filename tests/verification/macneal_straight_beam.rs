//! MacNeal & Harder's straight cantilever as a plate: extension, in-plane and out-of-plane shear on distorted meshes.
//!
//! MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
//!
//! ```text
//!  |__/__\__/__\__/__| 0.2 deep, t = 0.1, L = 6, E = 1e7, ν = 0.3; unit load at the end; 6 cells along, each
//!   regular, trapezoids, parallelograms (45°); also the same cut finer
//! ```
//!
//! Known weakness of the optimal triangle, here recorded: its in-plane bending is exact on right angles only; slanted cells
//! lose a quarter (trapezoids) to a half (parallelograms) of the in-plane deflection.
//!
//! Beam theory with shear: extension 3.0e-5, in-plane 0.1080936, out-of-plane 0.4320936.

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{Grid, line_shares, linear, plate};

/// Tip displacements over the exact ones: along, in the plane, across it.
fn ratios(cells: [usize; 2], slant: impl Fn(f64) -> f64) -> [f64; 3] {
    let mut grid = Grid::new(cells, plate(1e7, 0.3, 0.1), |xi, eta| {
        let inner = xi > 1e-9 && xi < 1.0 - 1e-9;
        let shift = if inner {
            slant(6.0 * xi) * (eta - 0.5) * 0.2
        } else {
            0.0
        };
        Vector3::new(6.0 * xi + shift, 0.2 * eta, 0.0)
    });
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let end = grid.side(true);
    let exact = [3e-5, 0.1080936, 0.4320936];
    std::array::from_fn(|axis| {
        let mut loads = Loads::none(grid.model.nodes.len());
        for (&node, share) in end.iter().zip(line_shares(&grid.model, &end)) {
            loads.force_n[node][axis] = share / 0.2;
        }
        let moved = linear(&grid.model, &loads);
        end.iter().map(|&node| moved[node][0][axis]).sum::<f64>() / end.len() as f64 / exact[axis]
    })
}

#[test]
fn straight_beam_on_regular_trapezoidal_and_slanted_cells() {
    let trapezoid = |x: f64| if (x.round() as i64) % 2 == 0 { 1.0 } else { -1.0 };
    // bounds as measured: along, in the plane, across
    for (name, cells, slant, bound) in [
        ("regular", [6, 1], 0, [0.01, 0.07, 0.03]),
        ("trapezoids", [6, 1], 1, [0.01, 0.27, 0.03]),
        ("parallelograms", [6, 1], 2, [0.01, 0.47, 0.03]),
        ("regular, fine", [24, 4], 0, [0.003, 0.001, 0.01]),
        ("parallelograms, fine", [24, 4], 2, [0.003, 0.38, 0.01]),
    ] {
        let ratio = ratios(cells, |x| match slant {
            0 => 0.0,
            1 => trapezoid(x),
            _ => 1.0,
        });
        println!("straight beam, {name}: {ratio:.4?}");
        for (ratio, bound) in ratio.iter().zip(bound) {
            assert!((ratio - 1.0).abs() < bound, "{name}: {ratio}");
        }
    }
}
