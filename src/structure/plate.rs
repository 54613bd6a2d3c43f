//! Plate bending: the discrete Kirchhoff triangle (DKT).
//!
//! Batoz, Bathe & Ho, Int. J. Numer. Methods Eng. 15 (1980) 1771-1812. The rotations β of the normal are
//! quadratic, with the Kirchhoff constraint kept at the corners and at the middles of the sides; here the
//! constraint is written out side by side instead of as the paper's tables.

use nalgebra::{Matrix3, SMatrix, Vector2};

/// Curvatures (κ_x, κ_y, 2κ_xy; 1/m) per freedom (w, θ_x, θ_y at each node) at the three middles of the sides.
///
/// w along the normal, θ_x = ∂w/∂y and θ_y = −∂w/∂x (rotations about the element's axes); curvature κ_x = ∂θ_y/∂x,
/// κ_y = −∂θ_x/∂y, 2κ_xy = ∂θ_y/∂y − ∂θ_x/∂x. `corner`: positions in the element's plane, m.
pub fn curvature(corner: &[Vector2<f64>; 3]) -> [SMatrix<f64, 3, 9>; 3] {
    // rotations β_x = θ_y, β_y = −θ_x at the corners and at the middles of sides 12, 23, 31
    let mut beta = [SMatrix::<f64, 2, 9>::zeros(); 6];
    for (node, row) in beta.iter_mut().take(3).enumerate() {
        row[(0, 3 * node + 2)] = 1.0;
        row[(1, 3 * node + 1)] = -1.0;
    }
    for side in 0..3 {
        let (i, j) = (side, (side + 1) % 3);
        let edge = corner[j] - corner[i];
        let length = edge.norm();
        let (c, s) = (edge.x / length, edge.y / length);
        // along the side w is cubic and −w' = β_s at the corners: at the middle β_s = −1.5 Δw/l − (β_si + β_sj)/4;
        // across it β_n is linear
        let mean = 0.5 * (beta[i] + beta[j]);
        let along = SMatrix::<f64, 1, 2>::new(c, s);
        let across = SMatrix::<f64, 1, 2>::new(-s, c);
        let mut beta_s = -0.5 * along * mean;
        beta_s[3 * i] += 1.5 / length;
        beta_s[3 * j] -= 1.5 / length;
        let beta_n = across * mean;
        beta[3 + side] = along.transpose() * beta_s + across.transpose() * beta_n;
    }
    let area2 = (corner[1] - corner[0]).perp(&(corner[2] - corner[0]));
    let gradient: [Vector2<f64>; 3] = std::array::from_fn(|i| {
        let opposite = corner[(i + 2) % 3] - corner[(i + 1) % 3];
        Vector2::new(-opposite.y, opposite.x) / area2
    });
    std::array::from_fn(|side| {
        let mut l = [0.5; 3];
        l[(side + 2) % 3] = 0.0;
        let mut b = SMatrix::<f64, 3, 9>::zeros();
        for node in 0..6 {
            // quadratic shape functions: corners L(2L − 1), sides 4 L_i L_j
            let slope = if node < 3 {
                gradient[node] * (4.0 * l[node] - 1.0)
            } else {
                let (i, j) = (node - 3, (node - 2) % 3);
                4.0 * (gradient[i] * l[j] + gradient[j] * l[i])
            };
            for k in 0..9 {
                let (bx, by) = (beta[node][(0, k)], beta[node][(1, k)]);
                b[(0, k)] += slope.x * bx;
                b[(1, k)] += slope.y * by;
                b[(2, k)] += slope.y * bx + slope.x * by;
            }
        }
        b
    })
}

/// Bending stiffness 9×9 of a triangle, freedoms as in [`curvature`]; D in N·m.
pub fn stiffness(corner: &[Vector2<f64>; 3], bending_n_m: &Matrix3<f64>) -> SMatrix<f64, 9, 9> {
    let area = 0.5 * (corner[1] - corner[0]).perp(&(corner[2] - corner[0]));
    let sum: SMatrix<f64, 9, 9> = curvature(corner)
        .iter()
        .map(|b| b.transpose() * bending_n_m * b)
        .sum();
    sum * (area / 3.0)
}
