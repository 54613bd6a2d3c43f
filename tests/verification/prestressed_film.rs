//! A taut film that carries compression as a plate: its tangent is definite, and it bulges as a film without bending does.
//!
//! ```text
//!   N → |‾‾‾‾‾‾‾‾‾| ← N     30 × 30 mm, 6 µm, pretension 5 N/m, E = 2.5 GPa; border held; irregular triangles
//!       |_________|          pressure 5 Pa: w = 0.0736714 p a²/N (series for the square)
//! ```
//!
//! No negative pivot may come from the rotations about the normal: lumped on them, the pretension gave 102 on this mesh
//! before any load. Series as in `taut_rectangle`; at 5 Pa the stretch takes 6 % off it, so both laws are compared with
//! each other, and with the series at a hundredth of the pressure.

use nalgebra::Vector3;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, NewtonSettings, Sheet};
use washout::verify::grid::{Grid, film, plate};

use crate::support::off;

const SIDE: f64 = 0.03;

const PRETENSION: f64 = 5.0;

/// Rise of the centre (m) under a pressure, negative pivots at rest and under it, Newton steps.
fn rise(pressure_pa: f64, sheet: Sheet) -> (f64, [usize; 2], usize) {
    let cells = 16;
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| {
        let (i, j) = (cells as f64 * xi, cells as f64 * eta);
        let inner = [xi, eta].iter().all(|v| *v > 0.01 && *v < 0.99) && (xi, eta) != (0.5, 0.5);
        let wobble = if inner { 0.2 / cells as f64 } else { 0.0 };
        SIDE * Vector3::new(
            xi + wobble * (3.1 * i + 1.7 * j).sin(),
            eta + wobble * (2.3 * i - 1.1 * j).cos(),
            0.0,
        )
    })
    .unwrap();
    for line in [
        grid.side(false),
        grid.side(true),
        grid.edge(false),
        grid.edge(true),
    ] {
        grid.hold(&line, [true, true, true, false, false, false]);
    }
    let mut loads = Loads::none(grid.model.nodes.len());
    for shell in grid.model.shells.iter() {
        for node in shell.nodes {
            loads.force_n[node].z += pressure_pa * shell.area_m2() / 3.0;
        }
    }
    let none = Loads::none(grid.model.nodes.len());
    let mut state = State::at_rest(grid.model.nodes.len());
    let mut equilibrium = Equilibrium::new(&grid.model).unwrap();
    let at_rest = equilibrium.factorize(&state, &none).unwrap();
    let settings = NewtonSettings::default();
    let report = equilibrium
        .solve(&mut state, &none, &loads, &settings, &Progress::quiet())
        .unwrap();
    let loaded = equilibrium.factorize(&state, &loads).unwrap();
    let centre = grid.node([cells / 2, cells / 2]);
    (state.displacement[centre].z, [at_rest, loaded], report.steps)
}

#[test]
fn pretension_brings_no_negative_pivot_and_bulges_by_the_series() {
    let taut = Sheet {
        pretension_n_per_m: PRETENSION,
        ..plate(2.5e9, 0.34, 6e-6)
    };
    let (small, negative, _) = rise(0.05, taut);
    let series = 0.073_671_35 * 0.05 * SIDE * SIDE / PRETENSION;
    println!(
        "taut film: {:.4} of the series, negative pivots {negative:?}",
        small / series
    );
    assert_eq!(negative, [0, 0]);
    assert!(off(small, series) < 1e-2, "{small} {series}");
    let (carries, negative, steps) = rise(5.0, taut);
    let (constant_strain, ..) = rise(5.0, film(taut, 1.0));
    println!("under 5 Pa: {carries:.5e} against {constant_strain:.5e} in {steps} steps, {negative:?}");
    assert_eq!(negative, [0, 0]);
    assert!(
        off(carries, constant_strain) < 2e-3 && steps < 10,
        "{carries} {constant_strain} {steps}"
    );
}
