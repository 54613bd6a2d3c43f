//! A sheared film between edges that stay as far apart: it pulls along its diagonal.
//!
//! Reissner 1938; Pipkin, IMA J. Appl. Math. 36 (1986) 85-99. The wrinkled strip in bending is a case of `verify`.
//!
//! Strains ±γ/2 at 45°, tension E t γ/2 along one diagonal, so N_xy = N_x = N_y = E t γ/4 (a plate would have
//! N_xy = E t γ/(2(1 + ν)) and no N).

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads};
use washout::verify::grid::{Grid, film, plate};

use crate::support::{big_turn, off};

const YOUNG: f64 = 2.5e9;
const THICKNESS: f64 = 6e-6;

#[test]
fn sheared_panel_pulls_along_its_diagonal() {
    let (side, shear) = (0.02, 2e-4);
    let sheet = film(plate(YOUNG, 0.34, THICKNESS), 0.0);
    let grid = Grid::new([6, 6], sheet, |xi, eta| {
        let wobble = (40.0 * xi * (1.0 - xi) * eta * (1.0 - eta)).sin();
        side * Vector3::new(xi + 0.02 * wobble, eta - 0.03 * wobble, 0.0)
    })
    .unwrap();
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
