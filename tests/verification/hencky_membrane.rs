//! Hencky's membrane: a flat round film, held at its rim, under even pressure.
//!
//! Hencky 1915, corrected series of Fichter, NASA TP-3658 (1997).
//!
//! ```text
//!   ↑ ↑ p ↑ ↑            w₀ = C(ν) a (p a / (E t))^(1/3), no tension at rest, no bending stiffness
//!  |_________| 2a        σ_r at the centre = S(ν) (E p² a² / t²)^(1/3)
//! ```
//!
//! C(0.3) = 0.653509, S(0.3) = 0.431101: own solution of the differential equation to 10 digits (the often quoted 0.662
//! belongs to ν ≈ 0.265). Small deflection, dead pressure. Both film laws: one that wrinkles, one that carries compression.

use std::f64::consts::FRAC_PI_4;

use nalgebra::Vector3;
use washout::structure::{Loads, Sheet};

use crate::support::{Grid, film, off, plate, solve};

/// Deflection and radial stress of the centre against Hencky's, and the Newton steps taken.
fn ratios(cells: usize, sheet: Sheet) -> ([f64; 2], usize) {
    let radius = 0.05;
    // a square on the disc: the larger coordinate gives the radius, the smaller the angle
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| {
        let (x, y) = (2.0 * xi - 1.0, 2.0 * eta - 1.0);
        let (large, small) = if x.abs() > y.abs() { (x, y) } else { (y, x) };
        let angle = if large == 0.0 {
            0.0
        } else {
            FRAC_PI_4 * small / large
        };
        let (sine, cosine) = angle.sin_cos();
        let (along, across) = (radius * large * cosine, radius * large * sine);
        let (x, y) = if x.abs() > y.abs() {
            (along, across)
        } else {
            (across, along)
        };
        Vector3::new(x, y, 0.0)
    });
    for node in [
        grid.side(false),
        grid.side(true),
        grid.edge(false),
        grid.edge(true),
    ]
    .concat()
    {
        grid.model.hold(node, [true, true, true, false, false, false]);
    }
    let stretching = sheet.e_pa * sheet.thickness_m;
    let pressure = 1e-4 * stretching / radius;
    let mut loads = Loads::none(grid.model.nodes.len());
    for shell in &grid.model.shells {
        for node in shell.nodes {
            loads.force_n[node].z += pressure * shell.area_m2() / 3.0;
        }
    }
    let (state, report) = solve(&grid.model, &loads, 1);
    let centre = grid.node([cells / 2, cells / 2]);
    let deflection = 0.653509 * radius * (pressure * radius / stretching).cbrt();
    let tension = 0.431101 * (stretching * (pressure * radius).powi(2)).cbrt();
    let around: Vec<f64> = (grid
        .model
        .shells
        .iter()
        .filter(|shell| shell.nodes.contains(&centre)))
    .map(|shell| {
        let (u, q) = grid.model.shell_state(shell, &state);
        let n = shell.membrane_force(&sheet, &u, &q, &Vector3::x());
        0.5 * (n[0] + n[1])
    })
    .collect();
    let mean = around.iter().sum::<f64>() / around.len() as f64;
    (
        [state.displacement[centre].z / deflection, mean / tension],
        report.steps,
    )
}

#[test]
fn deflection_and_tension_are_hencky_s_within_a_percent_with_both_laws() {
    // so thin that bending is nothing: w₀/t is about 150
    let base = plate(1e9, 0.3, 1e-5);
    for (name, sheet) in [
        ("carries compression", film(base, 1.0)),
        ("tension field", film(base, 1e-4)),
    ] {
        for cells in [8, 16, 32] {
            let ([deflection, tension], steps) = ratios(cells, sheet);
            println!("Hencky, {name}, {cells} cells: w {deflection:.5}, N {tension:.5} in {steps} steps");
            if cells == 32 {
                assert!(off(deflection, 1.0) < 1e-2 && off(tension, 1.0) < 1e-2);
            }
        }
    }
}
