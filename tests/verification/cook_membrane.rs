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
//! Reference 23.9677: own quadratic elements, 8 to 128 per side, extrapolated (literature 23.91 to 23.97).

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{Grid, line_shares, linear, plate};

fn deflection(cells: usize) -> f64 {
    let mut grid = Grid::new([cells, cells], plate(1.0, 1.0 / 3.0, 1.0), |xi, eta| {
        let (low, high) = (44.0 * xi, 44.0 + 16.0 * xi);
        Vector3::new(48.0 * xi, low + (high - low) * eta, 0.0)
    });
    for node in grid.side(false) {
        grid.model.clamp(node);
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
fn optimal_triangles_come_within_1_5_per_cent_on_16_cells_and_0_6_on_32() {
    let ratio = [4, 8, 16, 32].map(|cells| deflection(cells) / 23.9677);
    println!("Cook: {ratio:.4?}");
    assert!((ratio[2] - 1.0).abs() < 1.5e-2);
    assert!((ratio[3] - 1.0).abs() < 6e-3);
}
