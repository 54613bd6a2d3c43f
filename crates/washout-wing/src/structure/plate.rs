//! Plate bending with transverse shear: the discrete Kirchhoff-Mindlin triangle (DKMT).
//!
//! Katili, Int. J. Numer. Methods Eng. 36 (1993) 1859-1883; for a thin plate it becomes the discrete Kirchhoff triangle of
//! Batoz, Bathe & Ho, ibid. 15 (1980) 1771-1812. Rotations β of the normal are quadratic: linear between the corners, and
//! along each side a bulge Δβ that the equilibrium of a beam sets, γ = −⅔ φ Δβ with φ = 12 D/(κ G t l²), so that the
//! mean of w' + β − γ vanishes on every side. The sides' shears give the shear at each corner, linear in between.

use nalgebra::{Matrix3, SMatrix, Vector2};

/// Share of the section that carries transverse shear.
const SHEAR_SHARE: f64 = 5.0 / 6.0;

/// Matrices per freedom (w, θ_x, θ_y at each node) at the three middles of the sides.
///
/// w along the normal, θ_x and θ_y rotations of the normal about the element's axes (∂w/∂y and −∂w/∂x where there is no
/// shear).
pub struct Strains {
    /// Curvatures κ_x = ∂θ_y/∂x, κ_y = −∂θ_x/∂y, 2κ_xy = ∂θ_y/∂y − ∂θ_x/∂x, 1/m.
    pub curvature: [SMatrix<f64, 3, 9>; 3],
    /// Transverse shear strains γ_x, γ_y.
    pub shear: [SMatrix<f64, 2, 9>; 3],
}

/// Strains of a triangle; `corner`: positions in its plane, m; `softness_m2`: 12 D/(κ G t), see [`softness_m2`].
pub fn strains(corner: &[Vector2<f64>; 3], softness_m2: f64) -> Strains {
    // rotations β_x = θ_y, β_y = −θ_x at the corners and at the middles of sides 12, 23, 31
    let mut beta = [SMatrix::<f64, 2, 9>::zeros(); 6];
    for (node, row) in beta.iter_mut().take(3).enumerate() {
        row[(0, 3 * node + 2)] = 1.0;
        row[(1, 3 * node + 1)] = -1.0;
    }
    let mut tangent = [Vector2::<f64>::zeros(); 3];
    let mut side_shear = [SMatrix::<f64, 1, 9>::zeros(); 3];
    for side in 0..3 {
        let (i, j) = (side, (side + 1) % 3);
        let edge = corner[j] - corner[i];
        let length = edge.norm();
        tangent[side] = edge / length;
        let along = tangent[side].transpose();
        let mean = 0.5 * (beta[i] + beta[j]);
        let phi = softness_m2 / (length * length);
        let mut bulge = -1.5 * along * mean;
        bulge[3 * i] += 1.5 / length;
        bulge[3 * j] -= 1.5 / length;
        bulge /= 1.0 + phi;
        side_shear[side] = -2.0 / 3.0 * phi * bulge;
        beta[3 + side] = mean + tangent[side] * bulge;
    }
    let corner_shear: [SMatrix<f64, 2, 9>; 3] = std::array::from_fn(|i| {
        // the vector whose parts along the two sides that meet here are theirs
        let (next, last) = (i, (i + 2) % 3);
        let (a, b) = (tangent[next], tangent[last]);
        let part = Vector2::new(b.y, -b.x) * side_shear[next] - Vector2::new(a.y, -a.x) * side_shear[last];
        part / a.perp(&b)
    });
    Strains {
        curvature: curvature(corner, &beta),
        shear: std::array::from_fn(|side| 0.5 * (corner_shear[side] + corner_shear[(side + 1) % 3])),
    }
}

/// Curvatures at the middles of the sides from rotations β at the corners and there.
fn curvature(corner: &[Vector2<f64>; 3], beta: &[SMatrix<f64, 2, 9>; 6]) -> [SMatrix<f64, 3, 9>; 3] {
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

/// 12 D/(κ G t) of an isotropic plate, m²: what shear adds to its bending is this over the square of a length.
pub fn softness_m2(thickness_m: f64, poisson: f64) -> f64 {
    2.0 * thickness_m * thickness_m / (SHEAR_SHARE * (1.0 - poisson))
}

/// Stiffness 9×9 of a triangle against bending and transverse shear, freedoms as in [`Strains`]; D in N·m.
pub fn stiffness(
    corner: &[Vector2<f64>; 3],
    bending_n_m: &Matrix3<f64>,
    softness_m2: f64,
) -> SMatrix<f64, 9, 9> {
    let area = 0.5 * (corner[1] - corner[0]).perp(&(corner[2] - corner[0]));
    let shear_n_m = 12.0 * bending_n_m[(0, 0)] / softness_m2;
    let strains = strains(corner, softness_m2);
    let mut sum = SMatrix::<f64, 9, 9>::zeros();
    for (bent, sheared) in strains.curvature.iter().zip(&strains.shear) {
        sum += bent.transpose() * bending_n_m * bent + shear_n_m * sheared.transpose() * sheared;
    }
    sum * (area / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::membrane::isotropic;

    const CORNERS: [Vector2<f64>; 3] = [
        Vector2::new(0.1, 0.0),
        Vector2::new(1.2, 0.3),
        Vector2::new(0.4, 0.9),
    ];

    /// Freedoms of w with its slopes, and with the normals turned by `shear` besides.
    fn freedoms(w: impl Fn(Vector2<f64>) -> (f64, Vector2<f64>), shear: Vector2<f64>) -> SMatrix<f64, 9, 1> {
        let mut p = SMatrix::zeros();
        for (node, x) in CORNERS.iter().enumerate() {
            let (height, slope) = w(*x);
            p[3 * node] = height;
            // γ = w' + β with β = (θ_y, −θ_x)
            p[3 * node + 1] = slope.y - shear.y;
            p[3 * node + 2] = shear.x - slope.x;
        }
        p
    }

    #[test]
    fn constant_curvature_comes_out_exactly_at_any_softness() {
        let p = freedoms(
            |x| {
                (
                    0.5 * (x.x * x.x - 3.0 * x.x * x.y + 2.0 * x.y * x.y),
                    Vector2::new(x.x - 1.5 * x.y, 2.0 * x.y - 1.5 * x.x),
                )
            },
            Vector2::zeros(),
        );
        for softness in [0.0, 1e-4, 1.0] {
            let strains = strains(&CORNERS, softness);
            for (bent, sheared) in strains.curvature.iter().zip(&strains.shear) {
                let curvature = bent * p;
                assert!((curvature - nalgebra::Vector3::new(-1.0, -2.0, 3.0)).norm() < 1e-12);
                assert!((sheared * p).norm() < 1e-12);
            }
        }
    }

    #[test]
    fn constant_shear_comes_out_exactly_where_the_plate_is_soft_in_it() {
        let shear = Vector2::new(0.3, -0.7);
        let p = freedoms(|x| (2.0 * x.x - x.y, Vector2::new(2.0, -1.0)), shear);
        for sheared in strains(&CORNERS, 1e9).shear {
            assert!((sheared * p - shear).norm() < 1e-8, "{}", sheared * p);
        }
    }

    #[test]
    fn thin_plates_store_no_energy_in_shear() {
        let poisson = 0.3;
        let energy = |thickness: f64| {
            let bending = isotropic(1.0, poisson);
            let softness = softness_m2(thickness, poisson);
            let k = stiffness(&CORNERS, &bending, softness);
            let kirchhoff: SMatrix<f64, 9, 9> = (strains(&CORNERS, 0.0).curvature.iter())
                .map(|b| b.transpose() * bending * b)
                .sum();
            let area = 0.5 * (CORNERS[1] - CORNERS[0]).perp(&(CORNERS[2] - CORNERS[0]));
            (k - kirchhoff * (area / 3.0)).norm() / k.norm()
        };
        let (thick, thin) = (energy(0.1), energy(1e-3));
        assert!(thick > 1e-3 && thin < 2e-4 * thick, "{thick} {thin}");
    }
}
