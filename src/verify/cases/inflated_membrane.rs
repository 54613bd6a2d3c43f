//! A round film inflated so far that pressure turns with it and strains are no longer small.
//!
//! ```text
//!   ↖ ↑ p ↗     flat at rest, radius a, held at the rim; p a/(E t) = 1e-4, 1e-3, 1e-2; ν = 0.3; St Venant-Kirchhoff
//!   (_____)     value: w₀/a
//! ```
//!
//! The pressure follows the deformed triangles by solving under dead loads again and again until they no longer change, the
//! way that wings meet their air. A film here strains as its sides do, so that at the largest load (4 % strain) its law
//! is not quite St Venant-Kirchhoff's.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Model, NewtonSettings};
use crate::verify::grid::{Grid, disc, film, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// p a/(E t), w₀/a.
const TABLE: [[f64; 2]; 3] = [[1e-4, 0.0303361], [1e-3, 0.0654044], [1e-2, 0.1413846]];

/// Rounds of load and shape at most.
const ROUNDS: usize = 60;

/// The case.
pub const CASE: Case = Case {
    name: "inflated-membrane",
    title: "Round film inflated to a seventh of its radius, pressure following",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "rise of the centre over the radius",
        reference: || TABLE.map(|row| row[1]).to_vec(),
        source: "differential equations by shooting",
        tolerance: 0.01,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let (cells, radius, sheet) = (level.times(8), 0.05, film(plate(1e9, 0.3, 1e-5), 1.0));
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| radius * disc(xi, eta))?;
    grid.hold(&grid.rim(), [true, true, true, false, false, false]);
    let mut solver = Equilibrium::new(&grid.model)?;
    let mut state = State::at_rest(grid.model.nodes.len());
    let mut loads = Loads::none(grid.model.nodes.len());
    let mut rise = Vec::new();
    for [share, _] in TABLE {
        let pressure = share * sheet.e_pa * sheet.thickness_m / radius;
        for _ in 0..ROUNDS {
            let next = following(&grid.model, &state, pressure);
            let moved: f64 = (next.force_n.iter().zip(&loads.force_n))
                .map(|(a, b)| (a - b).norm())
                .sum();
            let size: f64 = next.force_n.iter().map(Vector3::norm).sum();
            solver.solve(&mut state, &loads, &next, &NewtonSettings::default(), progress)?;
            loads = next;
            if moved < 1e-9 * size {
                break;
            }
        }
        rise.push(state.displacement[grid.centre()].z / radius);
    }
    Ok(Answer::curves(format!("{cells} across"), [rise]))
}

/// Pressure on the deformed triangles, a third of each to its nodes.
fn following(model: &Model, state: &State, pressure_pa: f64) -> Loads {
    let mut loads = Loads::none(model.nodes.len());
    for shell in model.shells.iter() {
        let [a, b, c] = shell
            .nodes
            .map(|node| model.nodes[node] + state.displacement[node]);
        let force = pressure_pa / 6.0 * (b - a).cross(&(c - a));
        for node in shell.nodes {
            loads.force_n[node] += force;
        }
    }
    loads
}
