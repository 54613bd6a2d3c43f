//! Rigid motion costs nothing: large rotation and translation of a curved mesh with beams, and of a taut one.
//!
//! ```text
//!      .--=====--.        panel curved both ways, 1 × 0.7, beams along its sides and through its middle
//!    /     | |    \       u = R x − x + c;  ‖f_int‖ ≤ 1e-10 ‖K‖ ‖u‖
//!   '------| |-----'      with pre-tension: f_int after the motion is R f_int at rest
//! ```

use nalgebra::Vector3;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, Model, Sheet};
use washout::verify::chain::section;
use washout::verify::grid::{Grid, film, plate};

use crate::support::big_turn;

fn panel(sheet: Sheet) -> Model {
    let count = [8, 6];
    let mut grid = Grid::new(count, sheet, |xi, eta| {
        let height = 0.2 * (3.0 * xi).sin() + 0.15 * eta * eta - 0.1 * xi * eta;
        Vector3::new(xi + 0.03 * (9.0 * eta).sin(), 0.7 * eta, height)
    })
    .unwrap();
    let stiff = grid
        .model
        .add_section(section([1e4, 1e3, 1e3, 0.02, 0.05, 0.07]).unwrap());
    let spar: Vec<usize> = (0..=count[0]).map(|i| grid.node([i, 3])).collect();
    for line in [grid.edge(false), grid.edge(true), grid.side(false), spar] {
        for pair in line.windows(2) {
            grid.model
                .add_beam([pair[0], pair[1]], &Vector3::z(), stiff)
                .unwrap();
        }
    }
    grid.model
}

fn sheets(pretension_n_per_m: f64) -> [Sheet; 2] {
    let sheet = Sheet {
        pretension_n_per_m,
        ..plate(2.5e9, 0.34, 6e-6)
    };
    [sheet, film(sheet, 1e-4)]
}

/// Internal forces at rest (turned with the motion) and after it, ‖K‖ ‖u‖.
fn moved(model: &Model) -> (Vec<f64>, Vec<f64>, f64) {
    let (turn, shift) = (big_turn(), Vector3::new(3.0, -2.0, 5.0));
    let equilibrium = Equilibrium::new(model).unwrap();
    let none = Loads::none(model.nodes.len());
    let rest = State::at_rest(model.nodes.len());
    let mut state = rest.clone();
    for (node, x) in model.nodes.iter().enumerate() {
        state.displacement[node] = turn * x - x + shift;
        state.rotation[node] = turn;
    }
    let mut values = vec![0.0; equilibrium.pattern.entries()];
    let mut before = model.tangent(&equilibrium.pattern, &rest, &none, None, &mut values);
    for part in before.chunks_exact_mut(3) {
        let turned = turn * Vector3::from_column_slice(part);
        part.copy_from_slice(turned.as_slice());
    }
    let after = model.residual(&equilibrium.pattern, &state, &none);
    let stiffness = values.iter().map(|k| k * k).sum::<f64>().sqrt();
    let moved = state
        .displacement
        .iter()
        .map(|u| u.norm_squared())
        .sum::<f64>()
        .sqrt();
    (before, after, stiffness * moved)
}

#[test]
fn a_curved_panel_with_beams_moves_rigidly_without_forces() {
    for sheet in sheets(0.0) {
        let (_, after, scale) = moved(&panel(sheet));
        let force = after.iter().map(|f| f * f).sum::<f64>().sqrt() / scale;
        println!("{:?}: {force:.1e}", sheet.compression);
        assert!(force < 1e-10, "{force}");
    }
}

#[test]
fn forces_of_a_taut_panel_turn_with_it() {
    for sheet in sheets(5.0) {
        let (before, after, scale) = moved(&panel(sheet));
        let size = before.iter().map(|f| f * f).sum::<f64>().sqrt();
        let error = (before.iter().zip(&after))
            .map(|(b, a)| (b - a).powi(2))
            .sum::<f64>()
            .sqrt();
        println!(
            "{:?}: {:.1e}, of the forces {:.1e}",
            sheet.compression,
            error / scale,
            error / size
        );
        assert!(size > 1.0, "a taut curved panel is not free of forces");
        assert!(
            error < 1e-10 * scale && error < 1e-8 * size,
            "{error} {size} {scale}"
        );
    }
}
