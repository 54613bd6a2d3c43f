//! Cross-sections and materials: possible shapes, stable stiffness.

use nalgebra::DMatrix;

use super::refusal::{material_is_known, refuse};
use crate::input::design::{CouplingTerm, Design, Section, SectionStrain};
use crate::input::document::Node;
use crate::input::error::{InputError, Number};

pub(super) fn check_section(
    design: &Design,
    root: &Node,
    section: &Section,
    key: &str,
) -> Result<(), InputError> {
    match section {
        Section::Tube {
            outer_diameter_mm,
            inner_diameter_mm,
        } => {
            let (outer, inner) = (outer_diameter_mm.value(), inner_diameter_mm.value());
            if inner >= outer {
                let message = format!("must be smaller than outer_diameter_mm = {}", Number(outer));
                let cure = "A tube has a wall; for a solid rod write shape = \"round\" with diameter_mm";
                let with = format!("{key}.outer_diameter_mm");
                return refuse(root, &format!("{key}.inner_diameter_mm"), message, &[&with], cure);
            }
        }
        Section::Laminate { plies, .. } => {
            if plies.is_empty() {
                let cure =
                    "Give plies = [{ material = \"...\", thickness_mm = ... }, ...] from bottom to top";
                return refuse(root, &format!("{key}.plies"), "there is no ply", &[], cure);
            }
            for (number, ply) in plies.iter().enumerate() {
                material_is_known(
                    design,
                    root,
                    &ply.material,
                    &format!("{key}.plies[{number}].material"),
                )?;
            }
        }
        Section::Given { coupling, .. } => given(root, section, coupling, key)?,
        Section::Round { .. } | Section::HalfRound { .. } | Section::Rectangle { .. } => {}
    }
    Ok(())
}

/// Couplings name two strains that the section has, once each, and leave the matrix positive definite.
fn given(root: &Node, section: &Section, coupling: &[CouplingTerm], key: &str) -> Result<(), InputError> {
    let Some(diagonal) = diagonal(section) else {
        return Ok(());
    };
    let mut matrix = DMatrix::<f64>::identity(6, 6);
    let mut size = 0.0_f64;
    for (number, term) in coupling.iter().enumerate() {
        let term_key = format!("{key}.coupling[{number}]");
        let [i, j] = term.between.map(index);
        let between = format!("{term_key}.between");
        if i == j {
            let cure =
                "Name two different strains; a diagonal term is ea_n, gj_n_m2, ei_flap_n_m2 or ei_edge_n_m2";
            return refuse(root, &between, "couples a strain with itself", &[], cure);
        }
        for strain in term.between {
            if diagonal[index(strain)].is_none() {
                let needed = if strain == SectionStrain::ShearEdge {
                    "ga_edge_n"
                } else {
                    "ga_flap_n"
                };
                let message =
                    format!("couples a shear that the section does not have, because {needed} is absent");
                let cure = format!("Give {needed}, or leave the coupling out");
                return refuse(root, &between, message, &[&format!("{key}.{needed}")], cure);
            }
        }
        if matrix[(i, j)] != 0.0 {
            let cure = "The matrix is symmetric: give each pair once";
            return refuse(
                root,
                &between,
                "couples a pair that an earlier term couples already",
                &[],
                cure,
            );
        }
        let scale = (diagonal[i].unwrap_or(1.0) * diagonal[j].unwrap_or(1.0)).sqrt();
        let scaled = term.value.value() / scale;
        size = size.max(scaled.abs());
        matrix[(i, j)] = scaled;
        matrix[(j, i)] = scaled;
    }
    // The matrix is scaled to a unit diagonal, so its eigenvalues have no unit and lie near 1.
    let smallest = match size {
        size if size >= 1.0 => 1.0 - size,
        _ => matrix.symmetric_eigenvalues().min(),
    };
    if smallest > 1e-9 {
        return Ok(());
    }
    let message = format!(
        "makes the stiffness matrix indefinite (scaled to a diagonal of 1, its smallest eigenvalue is {smallest:.3})"
    );
    let cure = "A coupling must be smaller than the square root of the product of its two diagonal terms";
    refuse(root, &format!("{key}.coupling"), message, &[], cure)
}

/// EA, GA edge, GA flap, GJ, EI flap, EI edge of a given section.
fn diagonal(section: &Section) -> Option<[Option<f64>; 6]> {
    match section {
        Section::Given {
            ea_n,
            gj_n_m2,
            ei_flap_n_m2,
            ei_edge_n_m2,
            ga_edge_n,
            ga_flap_n,
            ..
        } => Some([
            Some(ea_n.value()),
            ga_edge_n.as_ref().map(|ga| ga.value()),
            ga_flap_n.as_ref().map(|ga| ga.value()),
            Some(gj_n_m2.value()),
            Some(ei_flap_n_m2.value()),
            Some(ei_edge_n_m2.value()),
        ]),
        _ => None,
    }
}

fn index(strain: SectionStrain) -> usize {
    match strain {
        SectionStrain::Axial => 0,
        SectionStrain::ShearEdge => 1,
        SectionStrain::ShearFlap => 2,
        SectionStrain::Twist => 3,
        SectionStrain::BendingFlap => 4,
        SectionStrain::BendingEdge => 5,
    }
}

/// Orthotropic materials have all their moduli, and a Poisson's ratio that leaves them stable.
pub(super) fn check_materials(design: &Design, root: &Node) -> Result<(), InputError> {
    for (name, material) in &design.material {
        let Some(e2) = &material.e2_gpa else {
            continue;
        };
        let key = |part: &str| format!("material.{name}.{part}");
        if material.g_gpa.is_none() {
            let cure = "Give the shear modulus in gigapascals, e.g. g_gpa = 4.5, or leave e2_gpa out";
            let message = "is needed where e2_gpa makes the material orthotropic";
            return refuse(root, &key("g_gpa"), message, &[&key("e2_gpa")], cure);
        }
        let largest = (material.e_gpa.value() / e2.value()).sqrt();
        if material.poisson.value().abs() >= largest {
            let message = format!("must be smaller than √(e_gpa / e2_gpa) = {largest:.4} in size");
            let cure = "Give the strain across per strain along the fibre, and e_gpa along it";
            return refuse(
                root,
                &key("poisson"),
                message,
                &[&key("e_gpa"), &key("e2_gpa")],
                cure,
            );
        }
    }
    Ok(())
}
