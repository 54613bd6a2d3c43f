//! A taut rectangular film under even pressure, small deflection: Poisson's equation.
//!
//! ```text
//!   a ┌────────────┐   w_c = c p a²/N at the centre, a the short side; c by the double sine series:
//!     │ N, p       │   0.0736714 (b/a = 1), 0.1138718 (2), 0.1249 (5)
//!     └────────────┘ b
//! ```
//!
//! One solve with the tangent at rest; both film laws give it. (A plate of a film's thickness does not: tension puts moments
//! on the rotations about its normal that so little bending cannot hold.)

use nalgebra::Vector3;
use washout::structure::{Loads, Sheet};

use crate::support::{Grid, film, linear, off, plate};

#[test]
fn deflection_is_that_of_the_series_within_half_a_percent() {
    let taut = Sheet {
        pretension_n_per_m: 100.0,
        ..plate(2.5e9, 0.34, 6e-6)
    };
    for (ratio, exact) in [(1.0, 0.073_671_35), (2.0, 0.113_871_83), (5.0, 0.124_899_84)] {
        for sheet in [film(taut, 1e-4), film(taut, 1.0)] {
            let short = 0.02;
            let cells = [(16.0 * ratio) as usize, 16];
            let mut grid = Grid::new(cells, sheet, |xi, eta| short * Vector3::new(ratio * xi, eta, 0.0));
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
            let mut loads = Loads::none(grid.model.nodes.len());
            for shell in &grid.model.shells {
                for node in shell.nodes {
                    loads.force_n[node].z += shell.area_m2() / 3.0;
                }
            }
            let centre = grid.node([cells[0] / 2, 8]);
            let value = linear(&grid.model, &loads)[centre][0].z * 100.0 / short.powi(2);
            println!("b/a = {ratio}, {:?}: {:.5}", sheet.compression, value / exact);
            assert!(off(value, exact) < 5e-3, "{ratio}: {value} {exact}");
        }
    }
}
