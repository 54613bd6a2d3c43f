//! Changes of sections and sheets: compliance in series, stiffness side by side, coupling.
//!
//! All are of low rank on the compliance (Sherman-Morrison-Woodbury), so that shears that are rigid stay so.

use std::sync::Arc;

use nalgebra::{Matrix2, Matrix6, Matrix6x2, SymmetricEigen, Vector6};

use super::StructureError;
use super::beam::Beam;
use super::finite::{at, numbers_of_section, refuse_not_finite};
use super::model::Model;
use super::section::Section;
use super::sheet::Sheet;
use super::shell::Shell;

/// Place of the axial strain in a section's compliance.
const AXIAL: usize = 0;
/// Place of the twist.
const TWIST: usize = 3;
/// Place of flapwise bending.
const FLAP: usize = 4;
/// Place of edgewise bending.
const EDGE: usize = 5;

impl Section {
    /// Adds torsional compliance, `share` times its own, about the shear centre, which keeps its place.
    pub fn soften_torsion(&mut self, share: f64) {
        let about = self.shear_centre();
        self.compliance += about * about.transpose() * (share * self.compliance[(TWIST, TWIST)]);
    }

    /// Adds compliance of flapwise and edgewise bending, as shares of its own.
    pub fn soften_bending(&mut self, flap_share: f64, edge_share: f64) {
        self.compliance[(FLAP, FLAP)] *= 1.0 + flap_share;
        self.compliance[(EDGE, EDGE)] *= 1.0 + edge_share;
    }

    /// Divides all stiffnesses by 1 + `share`.
    pub fn soften(&mut self, share: f64) {
        self.compliance *= 1.0 + share;
    }

    /// Adds stiffness side by side: EA (N), GJ, EI flap and EI edge (N·m²) about the reference axis.
    pub fn stiffen(&mut self, ea_n: f64, gj_n_m2: f64, ei_flap_n_m2: f64, ei_edge_n_m2: f64) {
        let more = [
            (AXIAL, ea_n),
            (TWIST, gj_n_m2),
            (FLAP, ei_flap_n_m2),
            (EDGE, ei_edge_n_m2),
        ];
        for (place, stiffness) in more {
            let column: Vector6<f64> = self.compliance.column(place).into();
            self.compliance -= column * column.transpose() * (stiffness / (1.0 + stiffness * column[place]));
        }
    }

    /// Scales the distance of the shear centre from the reference axis.
    pub fn scale_shear_centre(&mut self, factor: f64) {
        let twist = self.compliance[(TWIST, TWIST)];
        let old = self.shear_centre();
        let mut new = old * factor;
        new[TWIST] = 1.0;
        self.compliance += (new * new.transpose() - old * old.transpose()) * twist;
    }

    /// Couples twist and flapwise bending by a stiffness of `share` √(GJ EI).
    pub fn couple_bend_twist(&mut self, share: f64) {
        let (twist, flap) = (self.compliance[(TWIST, TWIST)], self.compliance[(FLAP, FLAP)]);
        let stiffness = share / (twist * flap).sqrt();
        if stiffness == 0.0 {
            return;
        }
        let columns = Matrix6x2::from_columns(&[
            self.compliance.column(TWIST).into_owned(),
            self.compliance.column(FLAP).into_owned(),
        ]);
        let cross = self.compliance[(TWIST, FLAP)] + 1.0 / stiffness;
        if let Some(inner) = Matrix2::new(twist, cross, cross, flap).try_inverse() {
            self.compliance -= columns * inner * columns.transpose();
        }
    }

    /// Strains per unit twist about the shear centre: 1 in the place of twist, its distances in those of the shears.
    fn shear_centre(&self) -> Vector6<f64> {
        let twist = self.compliance[(TWIST, TWIST)];
        let mut about = Vector6::zeros();
        about[TWIST] = 1.0;
        if twist > 0.0 {
            about[1] = self.compliance[(1, TWIST)] / twist;
            about[2] = self.compliance[(2, TWIST)] / twist;
        }
        about
    }

    /// Whether it has a compliance that is none, where all of it is finite: no strain may give back energy.
    fn check(&self) -> Result<(), StructureError> {
        let scale = self
            .compliance
            .diagonal()
            .map(|c| if c > 0.0 { 1.0 / c.sqrt() } else { 1.0 });
        let scale = Matrix6::from_diagonal(&scale);
        let scaled = scale * self.compliance * scale;
        let lowest = SymmetricEigen::new(scaled).eigenvalues.min();
        // a shear that is rigid leaves a zero
        if lowest < -1e-12 {
            return Err(StructureError::SectionNotPositive { lowest });
        }
        Ok(())
    }
}

impl Model {
    /// Gives one beam element a section of its own, made from that which it has.
    ///
    /// # Errors
    /// If the new section is none, or a number of it is not finite.
    pub fn change_section(
        &mut self,
        beam: usize,
        change: impl FnOnce(&mut Section),
    ) -> Result<(), StructureError> {
        let mut section = self.sections[self.beams[beam].section].clone();
        change(&mut section);
        let old = &self.beams[beam];
        let ends = old.nodes.map(|node| self.nodes[node]);
        let place = || format!("of the beam element {}", at((ends[0] + ends[1]) / 2.0));
        refuse_not_finite(place, numbers_of_section(&section))?;
        section.check()?;
        self.sections.push(section);
        let index = self.sections.len() - 1;
        let normal = old.axes().column(2).into_owned();
        self.beams[beam] = Beam::new(old.nodes, ends, &normal, index, &self.sections[index])?;
        Ok(())
    }

    /// Changes every sheet, and the shells made of it.
    ///
    /// # Errors
    /// If a shell has no area.
    pub fn change_sheets(&mut self, mut change: impl FnMut(&mut Sheet)) -> Result<(), StructureError> {
        self.sheets.iter_mut().for_each(&mut change);
        for shell in Arc::make_mut(&mut self.shells) {
            let corners = shell.nodes.map(|node| self.nodes[node]);
            *shell = Shell::new(shell.nodes, corners, shell.sheet, &self.sheets[shell.sheet])?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::section::BeamMaterial;
    use super::*;

    fn material(g_pa: f64) -> BeamMaterial {
        BeamMaterial {
            e_pa: 2.5,
            g_pa,
            density_kg_m3: 1.0,
        }
    }

    /// Half of the shear modulus is twice the torsional compliance about the shear centre; the shear area's part aside.
    #[test]
    fn a_half_round_of_half_the_shear_modulus_is_softened_in_torsion_about_its_shear_centre() {
        let mut softened = Section::half_round(1.0, true, &material(1.0));
        let expected = Section::half_round(1.0, true, &material(0.5)).compliance;
        softened.soften_torsion(1.0);
        let area = 1.0 / (0.85 * std::f64::consts::FRAC_PI_2);
        softened.compliance[(1, 1)] += area;
        softened.compliance[(2, 2)] += area;
        assert!((softened.compliance - expected).norm() < 1e-12 * expected.norm());
    }

    #[test]
    fn stiffness_added_is_stiffness_found() {
        let mut section = Section::uncoupled(2.0, 3.0, 5.0, 7.0);
        section.stiffen(1.0, 0.5, 0.25, 2.0);
        let found = [
            section.axial_stiffness_n(),
            section.gj_n_m2(),
            section.ei_flap_n_m2(),
            section.ei_edge_n_m2(),
        ];
        for (found, expected) in found.into_iter().zip([3.0, 3.5, 5.25, 9.0]) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn coupling_is_the_term_of_the_stiffness_matrix() {
        let mut section = Section::uncoupled(2.0, 3.0, 5.0, 7.0);
        section.couple_bend_twist(0.4);
        let block = section.compliance.fixed_view::<2, 2>(3, 3).into_owned();
        let stiffness = block.try_inverse().unwrap();
        let expected = Matrix2::new(3.0, 0.4 * 15.0_f64.sqrt(), 0.4 * 15.0_f64.sqrt(), 5.0);
        assert!((stiffness - expected).norm() < 1e-12);
        section.couple_bend_twist(0.9);
        assert!(section.check().is_err());
    }

    #[test]
    fn the_shear_centre_moves_away_and_the_axis_stays() {
        let mut section = Section::half_round(1.0, true, &material(1.0));
        let before = section.compliance;
        section.scale_shear_centre(3.0);
        let after = section.compliance;
        assert!((after[(1, 3)] / before[(1, 3)] - 3.0).abs() < 1e-12);
        assert_eq!(after[(3, 3)], before[(3, 3)]);
        let lever = before[(1, 3)] / before[(3, 3)];
        let grown = 8.0 * lever * lever * before[(3, 3)];
        assert!((after[(1, 1)] - before[(1, 1)] - grown).abs() < 1e-12);
    }
}
