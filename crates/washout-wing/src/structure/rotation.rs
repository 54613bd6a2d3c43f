//! Finite rotations: the tangent maps that corotational elements need.
//!
//! Sources: Nour-Omid & Rankin, Comput. Methods Appl. Mech. Eng. 93 (1991) 353-384; Felippa & Haugen,
//! Comput. Methods Appl. Mech. Eng. 194 (2005) 2285-2335.

use nalgebra::{Matrix3, Vector3};

/// The matrix S(a) with S(a) b = a × b.
pub fn skew(a: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::new(0.0, -a.z, a.y, a.z, 0.0, -a.x, -a.y, a.x, 0.0)
}

/// Rotation vector (rad) of a rotation matrix; its length is at most π.
pub fn rotation_vector(r: &Matrix3<f64>) -> Vector3<f64> {
    let axial = Vector3::new(r.m32 - r.m23, r.m13 - r.m31, r.m21 - r.m12) * 0.5;
    let sine = axial.norm();
    let cosine = 0.5 * (r.trace() - 1.0);
    if cosine > 0.0 && sine < 0.03 {
        // asin(s)/s up to s¹⁰: what is left out is below 1e-20
        let s2 = sine * sine;
        let high = 15.0 / 336.0 + s2 * (105.0 / 3456.0 + s2 * (945.0 / 42240.0));
        return axial * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * high)));
    }
    if cosine > -0.99 {
        return axial * (sine.atan2(cosine) / sine);
    }
    nalgebra::UnitQuaternion::from_matrix(r).scaled_axis()
}

/// The map H from a spin of the rotation exp(θ) (acting from the left) to the change of its rotation vector θ:
/// (1 − η θ²) 1 − skew(θ)/2 + η θ θᵀ.
pub fn spin_to_vector(theta: &Vector3<f64>) -> Matrix3<f64> {
    let square = theta.norm_squared();
    let eta = curvature_factors(square).0;
    let (half, scaled, diagonal) = (0.5 * theta, eta * theta, 1.0 - eta * square);
    let (xy, yz, zx) = (scaled.x * theta.y, scaled.y * theta.z, scaled.z * theta.x);
    Matrix3::new(
        diagonal + scaled.x * theta.x,
        xy + half.z,
        zx - half.y,
        xy - half.z,
        diagonal + scaled.y * theta.y,
        yz + half.x,
        zx + half.y,
        yz - half.x,
        diagonal + scaled.z * theta.z,
    )
}

/// Derivative of H(θ)ᵀ m with respect to a spin: ∂(Hᵀ m)/∂θ · H; H of [`spin_to_vector`].
pub fn moment_correction(theta: &Vector3<f64>, m: &Vector3<f64>, h: &Matrix3<f64>) -> Matrix3<f64> {
    let square = theta.norm_squared();
    let (eta, mu) = curvature_factors(square);
    let along = theta.dot(m);
    let by_vector = m * theta.transpose() * (-2.0 * eta - mu * square)
        + theta * (eta * m + mu * along * theta).transpose()
        + Matrix3::from_diagonal_element(eta * along)
        - skew(&(0.5 * m));
    by_vector * h
}

/// η = (1 − (θ/2) cot(θ/2))/θ² and μ = (dη/dθ)/θ as functions of θ².
fn curvature_factors(theta2: f64) -> (f64, f64) {
    if theta2 < 0.01 {
        let eta = 1.0 / 12.0 + theta2 * (1.0 / 720.0 + theta2 * (1.0 / 30240.0 + theta2 / 1_209_600.0));
        let mu = 1.0 / 360.0 + theta2 * (1.0 / 7560.0 + theta2 * (1.0 / 201_600.0 + theta2 / 5_987_520.0));
        return (eta, mu);
    }
    let theta = theta2.sqrt();
    let (half_sine, half_cosine) = (0.5 * theta).sin_cos();
    let eta = (1.0 - 0.5 * theta * half_cosine / half_sine) / theta2;
    let mu = (theta2 + 4.0 * theta.cos() + theta * theta.sin() - 4.0)
        / (4.0 * theta2 * theta2 * half_sine * half_sine);
    (eta, mu)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, UnitQuaternion};

    fn vectors() -> Vec<Vector3<f64>> {
        vec![
            Vector3::new(1e-9, 2e-9, -1e-9),
            Vector3::new(0.01, -0.05, 0.02),
            Vector3::new(0.0999, 0.0, 0.001),
            Vector3::new(0.4, 1.1, -0.7),
            Vector3::new(1.9, 1.5, -1.6),
        ]
    }

    #[test]
    fn rotation_vector_inverts_the_exponential() {
        for v in vectors() {
            let back = rotation_vector(Rotation3::new(v).matrix());
            assert!((back - v).norm() <= 1e-14 + 1e-12 * v.norm(), "{v} {back}");
        }
    }

    #[test]
    fn the_series_of_small_rotations_goes_on_where_the_closed_form_begins() {
        let [below, above] = [0.01 * (1.0 - 1e-12), 0.01].map(|square| curvature_factors(square).0);
        assert!((below - above).abs() < 1e-13, "{below} {above}");
    }

    #[test]
    fn spin_map_agrees_with_differences() {
        let h = 1e-6;
        for v in vectors() {
            let map = spin_to_vector(&v);
            for axis in 0..3 {
                let spin = Vector3::ith(axis, h);
                let plus = (UnitQuaternion::new(spin) * UnitQuaternion::new(v)).scaled_axis();
                let minus = (UnitQuaternion::new(-spin) * UnitQuaternion::new(v)).scaled_axis();
                let difference = (plus - minus) / (2.0 * h);
                assert!((difference - map.column(axis)).norm() < 1e-8, "{v}");
            }
        }
    }

    #[test]
    fn moment_correction_agrees_with_differences() {
        let h = 1e-6;
        let m = Vector3::new(0.3, -2.0, 1.1);
        for v in vectors() {
            let map = moment_correction(&v, &m, &spin_to_vector(&v));
            for axis in 0..3 {
                let spin = Vector3::ith(axis, h);
                let at = |spin: Vector3<f64>| {
                    let theta = rotation_vector((Rotation3::new(spin) * Rotation3::new(v)).matrix());
                    spin_to_vector(&theta).transpose() * m
                };
                let difference = (at(spin) - at(-spin)) / (2.0 * h);
                assert!((difference - map.column(axis)).norm() < 1e-8, "{v} {axis}");
            }
        }
    }
}
