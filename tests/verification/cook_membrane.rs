//! Cook's membrane: a tapered panel in plane stress, sheared at its free end.
//!
//! Cook, J. Struct. Div. ASCE 100 (1974) 1851-1863.
//!
//! ```text
//!            __ (48, 60)   E = 1, ν = 1/3, t = 1; unit shear spread over the end x = 48
//!         _/   ↑           value: v at (48, 52)
//!  (0,44)/     | (48, 44)
//!  |clamp|   /
//!  (0, 0)|_/
//! ```
//!
//! Reference 23.9677: own quadratic elements, 8 to 128 per side, extrapolated (literature 23.91 to 23.97). With cells cut
//! along their shorter diagonal and rotations free at the wall, the optimal triangle's known values are
//! 20.56, 22.45, 23.43 and 23.80 on 2, 4, 8 and 16 cells a side (Felippa 2003, from memory): a check of the element
//! itself, term by term.

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{Grid, line_shares, linear, plate};

fn deflection(cells: usize) -> f64 {
    let place = |xi: f64, eta: f64| {
        let (low, high) = (44.0 * xi, 44.0 + 16.0 * xi);
        Vector3::new(48.0 * xi, low + (high - low) * eta, 0.0)
    };
    let mut grid = Grid::cut([cells, cells], plate(1.0, 1.0 / 3.0, 1.0), place, |_, _| false);
    for node in grid.side(false) {
        grid.model.hold(node, [true, true, true, true, true, false]);
    }
    for node in 0..grid.model.nodes.len() {
        grid.model.hold(node, [false, false, true, true, true, false]);
    }
    let end = grid.side(true);
    let mut loads = Loads::none(grid.model.nodes.len());
    for (&node, share) in end.iter().zip(line_shares(&grid.model, &end)) {
        loads.force_n[node].y = share / 16.0;
    }
    linear(&grid.model, &loads)[end[cells / 2]][0].y
}

#[test]
fn optimal_triangles_come_within_a_percent_on_16_cells_and_a_third_on_32() {
    let moved = [2, 4, 8, 16, 32].map(deflection);
    println!("Cook: {moved:.4?}");
    for (value, known) in moved.iter().zip([20.56, 22.45, 23.43, 23.80]) {
        assert!((value - known).abs() < 5.1e-3, "{value} {known}");
    }
    let ratio = moved.map(|v| v / 23.9677);
    assert!(
        (ratio[3] - 1.0).abs() < 1e-2 && (ratio[4] - 1.0).abs() < 3.4e-3,
        "{ratio:?}"
    );
}
