//! A beam's section as CalculiX can have it: a rectangle of an orthotropic material.
//!
//! CalculiX has one element of given stiffnesses, U1, and it has no large rotation; its other beams are expanded into
//! solids of a circle or a rectangle. Height and width of the rectangle follow from the ratios of the bending to the axial
//! stiffness, its Young's modulus from EA, its shear modulus from GJ. One element across warps bilinearly: GJ is then
//! G b³h³/(3 (b² + h²)), which for thin strips is Saint-Venant's, for a square 18 % more.

use crate::structure::Section;

/// Rectangle with sides in the plane of the wing (width) and across it (height).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// In the plane of the wing, mm.
    pub width_mm: f64,
    /// Across it, mm.
    pub height_mm: f64,
    /// Young's modulus, MPa.
    pub e_mpa: f64,
    /// Shear modulus, MPa.
    pub g_mpa: f64,
}

impl Rectangle {
    /// With the EA, EI and GJ of a section; its couplings have no counterpart.
    pub fn of(section: &Section) -> Self {
        let stiffness = |i: usize| 1.0 / section.compliance[(i, i)];
        // N, N·mm²
        let ea = stiffness(0);
        let [gj, flap, edge] = [3, 4, 5].map(|i| 1e6 * stiffness(i));
        let (height, width) = ((12.0 * flap / ea).sqrt(), (12.0 * edge / ea).sqrt());
        let area = width * height;
        Rectangle {
            width_mm: width,
            height_mm: height,
            e_mpa: ea / area,
            g_mpa: gj * 3.0 * (width.powi(2) + height.powi(2)) / area.powi(3),
        }
    }

    /// Whether a section has couplings, which the rectangle leaves out.
    pub fn leaves_out(section: &Section) -> bool {
        let largest =
            |i: usize, j: usize| (section.compliance[(i, i)] * section.compliance[(j, j)]).sqrt() * 1e-9;
        (0..6).any(|i| (0..i).any(|j| section.compliance[(i, j)].abs() > largest(i, j)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::section::BeamMaterial;

    const CARBON: BeamMaterial = BeamMaterial {
        e_pa: 134e9,
        g_pa: 4e9,
        density_kg_m3: 1500.0,
    };

    #[test]
    fn the_rectangle_has_the_stiffnesses_of_a_half_round_rod() {
        let section = Section::half_round(5e-4, true, &CARBON);
        let Rectangle {
            width_mm: b,
            height_mm: h,
            e_mpa,
            g_mpa,
        } = Rectangle::of(&section);
        let a4 = 0.5_f64.powi(4);
        let near = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 1e-4, "{found} {exact}");
        near(e_mpa * b * h, 134e3 * std::f64::consts::FRAC_PI_2 * 0.25);
        near(e_mpa * b * h.powi(3) / 12.0, 134e3 * 0.109_757 * a4);
        near(
            e_mpa * h * b.powi(3) / 12.0,
            134e3 * std::f64::consts::FRAC_PI_8 * a4,
        );
        let torsion = g_mpa * (b * h).powi(3) / (3.0 * (b * b + h * h));
        near(torsion, 4e3 * 0.297_557 * a4);
        assert!(Rectangle::leaves_out(&section));
        assert!(!Rectangle::leaves_out(&Section::round(5e-4, &CARBON)));
    }
}
