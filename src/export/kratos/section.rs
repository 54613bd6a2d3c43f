//! A beam's section as Kratos has it: area, two moments of inertia, torsional constant and shear areas of one material.

use crate::structure::Section;

/// Properties of a `CrBeamElement3D2N`, mm and MPa, with Poisson's ratio 0 and so G = E/2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamProperties {
    /// Young's modulus over an area of 1 mm², MPa: the axial stiffness in N.
    pub e_mpa: f64,
    /// Torsional constant, mm⁴.
    pub torsion_mm4: f64,
    /// For bending across the wing's plane, mm⁴.
    pub flap_mm4: f64,
    /// For bending in it, mm⁴.
    pub edge_mm4: f64,
    /// Shear areas in the wing's plane and across it, mm²; none where the section is rigid in shear.
    pub shear_mm2: [Option<f64>; 2],
}

impl BeamProperties {
    /// With the stiffnesses of a section; its couplings have no counterpart. Shear areas are those of forces through the
    /// shear centre.
    pub fn of(section: &Section) -> Self {
        let c = &section.compliance;
        let e_mpa = 1.0 / c[(0, 0)];
        let g_mpa = 0.5 * e_mpa;
        let [torsion, flap, edge] = [3, 4, 5].map(|i| 1e6 / c[(i, i)]);
        let shear_mm2 = [1, 2].map(|i| {
            let compliance = c[(i, i)] - c[(i, 3)].powi(2) / c[(3, 3)];
            (compliance > 1e-9 * c[(0, 0)]).then(|| 1.0 / (compliance * g_mpa))
        });
        BeamProperties {
            e_mpa,
            torsion_mm4: torsion / g_mpa,
            flap_mm4: flap / e_mpa,
            edge_mm4: edge / e_mpa,
            shear_mm2,
        }
    }

    /// Lines of a block of properties.
    pub fn rows(&self) -> Vec<String> {
        let fixed = [
            ("YOUNG_MODULUS", self.e_mpa),
            ("POISSON_RATIO", 0.0),
            ("DENSITY", 1e-9),
            ("CROSS_AREA", 1.0),
            ("TORSIONAL_INERTIA", self.torsion_mm4),
            ("I22", self.flap_mm4),
            ("I33", self.edge_mm4),
        ];
        let shear = ["AREA_EFFECTIVE_Y", "AREA_EFFECTIVE_Z"]
            .into_iter()
            .zip(self.shear_mm2);
        let shear = shear.filter_map(|(name, area)| Some((name, area?)));
        let rows = fixed.into_iter().chain(shear);
        rows.map(|(name, value)| format!("{name} {value:.17e}")).collect()
    }

    /// Whether a section has couplings, which these properties leave out.
    pub fn leaves_out(section: &Section) -> bool {
        let c = &section.compliance;
        (0..6).any(|i| (0..i).any(|j| c[(i, j)].abs() > 1e-9 * (c[(i, i)] * c[(j, j)]).sqrt()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::section::BeamMaterial;

    #[test]
    fn a_round_rod_has_its_stiffnesses_and_its_shear_area() {
        let material = BeamMaterial {
            e_pa: 134e9,
            g_pa: 4e9,
            density_kg_m3: 1500.0,
        };
        let found = BeamProperties::of(&Section::round(5e-4, &material));
        let pi = std::f64::consts::PI;
        let near = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
        near(found.e_mpa, 134e3 * pi * 0.25);
        near(found.flap_mm4 * found.e_mpa, 134e3 * pi / 64.0);
        near(found.torsion_mm4 * 0.5 * found.e_mpa, 4e3 * pi / 32.0);
        // k G A with k = 0.9
        near(
            found.shear_mm2[0].unwrap() * 0.5 * found.e_mpa,
            0.9 * 4e3 * pi * 0.25,
        );
        assert_eq!(
            BeamProperties::of(&Section::uncoupled(1.0, 1.0, 1.0, 1.0)).shear_mm2,
            [None; 2]
        );
        // a half-round's shear centre is left out, and does not weaken its shear area
        let half = Section::half_round(5e-4, true, &material);
        assert!(BeamProperties::leaves_out(&half));
        near(
            BeamProperties::of(&half).shear_mm2[0].unwrap() * 0.5 * BeamProperties::of(&half).e_mpa,
            0.85 * 4e3 * pi * 0.125,
        );
    }
}
