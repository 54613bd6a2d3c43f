//! Thin plates under even pressure and point loads: square, long rectangle, circle.
//!
//! Navier's series, Ritz solutions with 20 terms a side and closed forms (Timoshenko & Woinowsky-Krieger, Theory of
//! Plates and Shells); centre deflection in q a⁴/D or P a²/D. Kirchhoff plates, simply supported (w = 0) or clamped.
//!
//! ```text
//!   a ┌──────────┐   square: 4.06235e-3 supported, 1.26532e-3 clamped; point load 1.16008e-2 supported
//!     │  quarter │   b/a = 5: 1.29708e-2 supported, 2.60423e-3 clamped (the 2.56 of 1985 is 1.7 % low)
//!     └──────────┘ b circle of radius R, clamped: q R⁴/(64 D)
//! ```

use std::f64::consts::FRAC_PI_4;

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{Grid, linear, plate};

const POISSON: f64 = 0.3;

/// Centre deflection in q a⁴/D (or P a²/D for a point load) of a quarter plate, sides 1/2 × `long`/2.
fn quarter(cells: usize, long: f64, clamped: bool, point: bool) -> f64 {
    let thickness = 1e-3;
    let mut grid = Grid::new([cells, cells], plate(1.0, POISSON, thickness), |xi, eta| {
        Vector3::new(0.5 * xi, 0.5 * long * eta, 0.0)
    });
    for node in 0..grid.model.nodes.len() {
        grid.model.hold(node, [true, true, false, false, false, true]);
    }
    for (line, slope) in [(grid.side(false), 4), (grid.edge(false), 3)] {
        for node in line {
            let mut held = [false; 6];
            held[slope] = true;
            grid.model.hold(node, held);
        }
    }
    for node in [grid.side(true), grid.edge(true)].concat() {
        grid.model
            .hold(node, [false, false, true, clamped, clamped, false]);
    }
    let mut loads = Loads::none(grid.model.nodes.len());
    if point {
        loads.force_n[grid.node([0, 0])].z = 0.25;
    } else {
        for shell in &grid.model.shells {
            for node in shell.nodes {
                loads.force_n[node].z += shell.area_m2() / 3.0;
            }
        }
    }
    let bending = thickness.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    linear(&grid.model, &loads)[grid.node([0, 0])][0].z * bending
}

#[test]
fn rectangles_come_within_half_a_percent_on_16_cells_a_quarter() {
    for (name, long, clamped, point, exact) in [
        ("square, supported, pressure", 1.0, false, false, 4.0623527e-3),
        ("square, clamped, pressure", 1.0, true, false, 1.2653191e-3),
        ("square, supported, point load", 1.0, false, true, 1.1600839e-2),
        ("b/a = 5, supported, pressure", 5.0, false, false, 1.29708320e-2),
        ("b/a = 5, clamped, pressure", 5.0, true, false, 2.604227e-3),
    ] {
        let ratio = [4, 8, 16].map(|cells| quarter(cells, long, clamped, point) / exact);
        println!("{name}: {ratio:.4?}");
        assert!((ratio[2] - 1.0).abs() < 5e-3, "{name}: {ratio:?}");
    }
}

#[test]
fn clamped_circle_comes_within_half_a_percent_on_16_cells_across() {
    let ratio = [8, 16, 32].map(|cells| {
        let thickness = 1e-3;
        let mut grid = Grid::new([cells, cells], plate(1.0, POISSON, thickness), |xi, eta| {
            let (x, y) = (2.0 * xi - 1.0, 2.0 * eta - 1.0);
            let (large, small) = if x.abs() > y.abs() { (x, y) } else { (y, x) };
            let angle = if large == 0.0 {
                0.0
            } else {
                FRAC_PI_4 * small / large
            };
            let (sine, cosine) = angle.sin_cos();
            let (x, y) = if x.abs() > y.abs() {
                (cosine, sine)
            } else {
                (sine, cosine)
            };
            Vector3::new(x, y, 0.0) * large
        });
        for node in [
            grid.side(false),
            grid.side(true),
            grid.edge(false),
            grid.edge(true),
        ]
        .concat()
        {
            grid.model.clamp(node);
        }
        let mut loads = Loads::none(grid.model.nodes.len());
        for shell in &grid.model.shells {
            for node in shell.nodes {
                loads.force_n[node].z += shell.area_m2() / 3.0;
            }
        }
        let bending = thickness.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
        linear(&grid.model, &loads)[grid.node([cells / 2, cells / 2])][0].z * bending * 64.0
    });
    println!("clamped circle: {ratio:.4?}");
    assert!((ratio[2] - 1.0).abs() < 5e-3, "{ratio:?}");
}
