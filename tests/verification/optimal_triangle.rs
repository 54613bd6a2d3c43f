//! The optimal triangle on Cook's membrane against its own published values, term by term.
//!
//! With cells cut along their shorter diagonal and rotations free at the wall: 20.56, 22.45, 23.43 and 23.80 on 2, 4, 8 and
//! 16 cells a side (Felippa, Comput. Methods Appl. Mech. Eng. 192 (2003) 2125-2168, from memory), with his β₀ = (1 − 4ν²)/2.
//! The shell has a tenth of it and comes nearer to the 23.9677 of fine elements.

use nalgebra::{DMatrix, DVector, Vector2};
use washout::structure::membrane::{isotropic, optimal};
use washout::verify::cases::cook_membrane::deflection;

/// Known values: cells a side, deflection.
const KNOWN: [(usize, f64); 4] = [(2, 20.56), (4, 22.45), (8, 23.43), (16, 23.80)];

/// Deflection at (48, 52) of the membrane of triangles alone, by a full matrix.
fn membrane_alone(cells: usize, higher_order: f64) -> f64 {
    let place = |i: usize, j: usize| {
        let (xi, eta) = (i as f64 / cells as f64, j as f64 / cells as f64);
        Vector2::new(48.0 * xi, 44.0 * xi * (1.0 - eta) + (44.0 + 16.0 * xi) * eta)
    };
    let freedom = |i: usize, j: usize| 3 * (i * (cells + 1) + j);
    let size = 3 * (cells + 1) * (cells + 1);
    let mut stiffness = DMatrix::<f64>::zeros(size, size);
    for (i, j) in (0..cells).flat_map(|i| (0..cells).map(move |j| (i, j))) {
        let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
        for corners in [[a, b, d], [b, c, d]] {
            let plane = corners.map(|(i, j)| place(i, j));
            let k = optimal(&plane, &isotropic(1.0, 1.0 / 3.0), higher_order);
            let at = corners.map(|(i, j)| freedom(i, j));
            for (row, column) in (0..9).flat_map(|r| (0..9).map(move |c| (r, c))) {
                stiffness[(at[row / 3] + row % 3, at[column / 3] + column % 3)] += k[(row, column)];
            }
        }
    }
    let mut load = DVector::<f64>::zeros(size);
    for j in 0..=cells {
        let half = if j == 0 || j == cells { 0.5 } else { 1.0 };
        load[freedom(cells, j) + 1] = half / cells as f64;
        for held in freedom(0, j)..freedom(0, j) + 2 {
            stiffness[(held, held)] += 1e12;
        }
    }
    let moved = stiffness.cholesky().expect("definite").solve(&load);
    moved[freedom(cells, cells / 2) + 1]
}

#[test]
fn cook_s_membrane_moves_as_felippa_s_triangles_do() {
    for (cells, known) in KNOWN {
        let value = membrane_alone(cells, 0.5);
        assert!((value - known).abs() < 5.1e-3, "{cells}: {value} {known}");
    }
}

#[test]
fn the_shell_s_triangles_come_nearer_than_felippa_s() {
    for (cells, known) in KNOWN {
        let value = deflection(cells).unwrap();
        assert!(value > known && value < 23.9677, "{cells}: {value} {known}");
    }
}
