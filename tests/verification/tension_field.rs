//! The tension field: a stretched strip in bending that wrinkles on its inner side, and a sheared panel.
//!
//! Stein & Hedgepeth, NASA TN D-813 (1961); Reissner 1938; Pipkin, IMA J. Appl. Math. 36 (1986) 85-99.
//!
//! ```text
//!   |~~~~~~~~~~~~~~~~~|      strip h × L under tension P and moment M: beyond M = P h/6 a band b wrinkles,
//!   |                 |-> P  b/h = 3 M/(P h) − 1/2, its stress is nothing, the rest's is a triangle:
//!   |_________________|) M   κ = 2 P / (E t (h − b)²); before, κ = 12 M/(E t h³)
//! ```
//!
//! Sheared panel between edges that stay as far apart: strains ±γ/2 at 45°, tension E t γ/2 along one diagonal, so
//! N_xy = N_x = N_y = E t γ/4 (a plate would have N_xy = E t γ/(2(1 + ν)) and no N).

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads};

use crate::support::{Grid, big_turn, film, off, plate, section, solve};

const YOUNG: f64 = 2.5e9;
const THICKNESS: f64 = 6e-6;

/// Curvature of the strip over that of the closed form, and the Newton steps, at M/(P h).
fn curvature(cells: usize, share: f64) -> (f64, usize) {
    let (height, length) = (0.02, 0.02);
    let stretching = YOUNG * THICKNESS;
    let mut grid = Grid::new(
        [cells, cells],
        film(plate(YOUNG, 0.34, THICKNESS), 1e-4),
        |xi, eta| Vector3::new(length * xi, height * (eta - 0.5), 0.0),
    );
    // the loaded end stays straight and may contract
    let stiff = grid.model.add_section(section([1e-3, 1e7, 1e7, 1e3, 1e3, 1e3]));
    let end = grid.side(true);
    for pair in end.windows(2) {
        grid.model
            .add_beam([pair[0], pair[1]], &Vector3::z(), stiff)
            .unwrap();
    }
    for node in 0..grid.model.nodes.len() {
        grid.model.hold(node, [false, false, true, true, true, false]);
    }
    for node in grid.side(false) {
        grid.model.hold(node, [true, false, false, false, false, false]);
    }
    grid.model.clamp(grid.node([0, cells / 2]));
    let tension = 1e-5 * stretching * height;
    let mut loads = Loads::none(grid.model.nodes.len());
    let middle = end[cells / 2];
    loads.force_n[middle].x = tension;
    loads.moment_n_m[middle].z = share * tension * height;
    let (state, report) = solve(&grid.model, &loads, 1);
    let wrinkled = (3.0 * share - 0.5).max(0.0);
    let exact = if wrinkled > 0.0 {
        2.0 * tension / (stretching * (height * (1.0 - wrinkled)).powi(2))
    } else {
        12.0 * share * tension / (stretching * height * height)
    };
    (
        state.rotation[middle].scaled_axis().z / length / exact,
        report.steps,
    )
}

#[test]
fn bent_strip_has_the_curvature_of_stein_and_hedgepeth_within_a_percent() {
    for share in [0.1, 1.0 / 6.0, 0.25, 0.3, 0.35] {
        for cells in [16, 32] {
            let (ratio, steps) = curvature(cells, share);
            println!("M/(P h) = {share:.3}, {cells} cells: {ratio:.5} in {steps} steps");
            assert!(cells < 32 || off(ratio, 1.0) < 1e-2, "{share}: {ratio}");
        }
    }
}

#[test]
fn sheared_panel_pulls_along_its_diagonal() {
    let (side, shear) = (0.02, 2e-4);
    let sheet = film(plate(YOUNG, 0.34, THICKNESS), 0.0);
    let grid = Grid::new([6, 6], sheet, |xi, eta| {
        let wobble = (40.0 * xi * (1.0 - xi) * eta * (1.0 - eta)).sin();
        side * Vector3::new(xi + 0.02 * wobble, eta - 0.03 * wobble, 0.0)
    });
    // pure shear without rotation, then turned at large
    let half = Matrix3::new(0.0, 0.5 * shear, 0.0, 0.5 * shear, 0.0, 0.0, 0.0, 0.0, 0.0);
    for turn in [UnitQuaternion::identity(), big_turn()] {
        let mut state = State::at_rest(grid.model.nodes.len());
        for (node, x) in grid.model.nodes.iter().enumerate() {
            state.displacement[node] = turn * (x + half * x) - x;
            state.rotation[node] = turn;
        }
        let equilibrium = Equilibrium::new(&grid.model).unwrap();
        let none = Loads::none(grid.model.nodes.len());
        let force = grid.model.residual(&equilibrium.pattern, &state, &none);
        let at = |node: usize| {
            let at = equilibrium.pattern.freedom(node, 0);
            turn.inverse() * Vector3::from_column_slice(&force[at..at + 3])
        };
        let top: Vector3<f64> = grid.edge(true).into_iter().map(at).sum();
        let expected = YOUNG * THICKNESS * shear / 4.0 * side;
        assert!(
            off(top.x, expected) < 1e-9 && off(top.y, expected) < 1e-9,
            "{top} {expected}"
        );
        let inner = grid.node([3, 3]);
        assert!(at(inner).norm() < 1e-10 * expected);
    }
}
