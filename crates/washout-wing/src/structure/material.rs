//! Sections and sheets from what a design says: units and materials resolved.

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::StructureError;
use super::section::{BeamMaterial, PlyStiffness, Section};
use super::sheet::{Compression, Sheet};
use crate::input::design::{self, Design, FilmCompression, Flat, Material, SectionStrain};

/// The section of a rod segment or a spar; `material` as its key says.
///
/// # Errors
/// If a material is missing, or the stiffness is not positive definite.
pub fn section(
    design: &Design,
    section: &design::Section,
    material: Option<&String>,
) -> Result<Section, StructureError> {
    let of_one = || beam_material(find(design, material.map_or("", String::as_str))?);
    let half = |diameter_mm: f64| 0.5e-3 * diameter_mm;
    Ok(match section {
        design::Section::Round { diameter_mm } => Section::round(half(diameter_mm.value()), &of_one()?),
        design::Section::HalfRound { diameter_mm, flat } => {
            Section::half_round(half(diameter_mm.value()), *flat == Flat::InPlane, &of_one()?)
        }
        design::Section::Tube {
            outer_diameter_mm,
            inner_diameter_mm,
        } => Section::tube(
            half(outer_diameter_mm.value()),
            half(inner_diameter_mm.value()),
            &of_one()?,
        ),
        design::Section::Rectangle {
            width_mm,
            thickness_mm,
        } => Section::rectangle(1e-3 * width_mm.value(), 1e-3 * thickness_mm.value(), &of_one()?),
        design::Section::Laminate { width_mm, plies } => {
            let plies = plies.iter().map(|ply| {
                let material = find(design, &ply.material)?;
                Ok(PlyStiffness {
                    thickness_m: 1e-3 * ply.thickness_mm.value(),
                    q_pa: turned(&plane_stress(material), ply.angle_deg.value().to_radians()),
                    density_kg_m3: material.density_kg_m3.value(),
                })
            });
            Section::laminate(
                1e-3 * width_mm.value(),
                &plies.collect::<Result<Vec<_>, StructureError>>()?,
            )?
        }
        design::Section::Given { .. } => given(section)?,
    })
}

/// The film of a design as a sheet; `None` without film.
///
/// # Errors
/// If its material is missing.
pub fn film(design: &Design) -> Result<Option<Sheet>, StructureError> {
    let Some(film) = &design.film else {
        return Ok(None);
    };
    let material = find(design, &film.material)?;
    // a film that carries compression is the whole elastic law on the same element: its bending is far too weak for
    // the rotations of a plate's membrane
    let residual = match film.compression {
        FilmCompression::TensionField => film.residual_compression.value(),
        FilmCompression::Carries => 1.0,
    };
    let drilling_factor = design.structure.drilling_factor;
    Ok(Some(Sheet {
        e_pa: 1e9 * material.e_gpa.value(),
        poisson: material.poisson.value(),
        thickness_m: 1e-3 * film.thickness_mm.value(),
        density_kg_m3: material.density_kg_m3.value(),
        pretension_n_per_m: film.pretension_n_per_m.value(),
        compression: Compression::TensionField {
            residual,
            drilling_factor,
            slack: 0.0,
        },
    }))
}

fn find<'d>(design: &'d Design, name: &str) -> Result<&'d Material, StructureError> {
    design
        .material
        .get(name)
        .ok_or_else(|| StructureError::UnknownMaterial {
            name: name.to_owned(),
        })
}

/// Constants along a rod: the shear modulus as given, else that of an isotropic material.
fn beam_material(material: &Material) -> Result<BeamMaterial, StructureError> {
    let e_pa = 1e9 * material.e_gpa.value();
    let isotropic = 0.5 * e_pa / (1.0 + material.poisson.value());
    let g_pa = material.g_gpa.as_ref().map_or(isotropic, |g| 1e9 * g.value());
    Ok(BeamMaterial {
        e_pa,
        g_pa,
        density_kg_m3: material.density_kg_m3.value(),
    })
}

/// Plane-stress stiffness in the fibre axes, Pa.
fn plane_stress(material: &Material) -> Matrix3<f64> {
    let e1 = 1e9 * material.e_gpa.value();
    let e2 = material.e2_gpa.as_ref().map_or(e1, |e| 1e9 * e.value());
    let nu12 = material.poisson.value();
    let isotropic = 0.5 * e1 / (1.0 + nu12);
    let g = material.g_gpa.as_ref().map_or(isotropic, |g| 1e9 * g.value());
    let scale = 1.0 / (1.0 - nu12 * nu12 * e2 / e1);
    Matrix3::new(
        e1 * scale,
        nu12 * e2 * scale,
        0.0,
        nu12 * e2 * scale,
        e2 * scale,
        0.0,
        0.0,
        0.0,
        g,
    )
}

/// Stiffness of a ply whose fibres stand at `angle_rad` from x: Q̄ = T⁻¹ Q T⁻ᵀ (Jones, Mechanics of Composite
/// Materials, section 2.6), strains with γ.
fn turned(q: &Matrix3<f64>, angle_rad: f64) -> Matrix3<f64> {
    let (s, c) = angle_rad.sin_cos();
    let inverse = Matrix3::new(
        c * c,
        s * s,
        -2.0 * s * c, //
        s * s,
        c * c,
        2.0 * s * c, //
        s * c,
        -s * c,
        c * c - s * s,
    );
    inverse * q * inverse.transpose()
}

fn given(section: &design::Section) -> Result<Section, StructureError> {
    let design::Section::Given {
        ea_n,
        gj_n_m2,
        ei_flap_n_m2,
        ei_edge_n_m2,
        ga_edge_n,
        ga_flap_n,
        mass_kg_m,
        polar_inertia_kg_m2_per_m,
        coupling,
    } = section
    else {
        return Err(StructureError::SectionNotPositive { lowest: 0.0 });
    };
    // A beam without shear stiffness given is rigid in shear: invert the rest and give shear no compliance.
    let shear = [ga_edge_n.as_ref(), ga_flap_n.as_ref()];
    let mut stiffness = Matrix6::zeros();
    let diagonal = [
        ea_n.value(),
        shear[0].map_or(1.0, |k| k.value()),
        shear[1].map_or(1.0, |k| k.value()),
        gj_n_m2.value(),
        ei_flap_n_m2.value(),
        ei_edge_n_m2.value(),
    ];
    for (i, k) in diagonal.into_iter().enumerate() {
        stiffness[(i, i)] = k;
    }
    for term in coupling {
        let [i, j] = term.between.map(strain_index);
        stiffness[(i, j)] = term.value.value();
        stiffness[(j, i)] = term.value.value();
    }
    let mut section = Section::from_stiffness(&stiffness, mass_kg_m.value())?;
    // as of a flat section: what turns about the axis turns about the normal too
    let polar = polar_inertia_kg_m2_per_m.value();
    section.inertia_kg_m = Vector3::new(polar, 0.0, polar);
    for (k, given) in shear.into_iter().enumerate() {
        if given.is_none() {
            section.compliance.row_mut(1 + k).fill(0.0);
            section.compliance.column_mut(1 + k).fill(0.0);
        }
    }
    Ok(section)
}

fn strain_index(strain: SectionStrain) -> usize {
    match strain {
        SectionStrain::Axial => 0,
        SectionStrain::ShearEdge => 1,
        SectionStrain::ShearFlap => 2,
        SectionStrain::Twist => 3,
        SectionStrain::BendingFlap => 4,
        SectionStrain::BendingEdge => 5,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ply of stiffness along its fibres alone has E m mᵀ, m the strain along them: (c², s², s c); one across them alone n = (s², c², −s c).
    #[test]
    fn a_turned_ply_is_stiff_along_its_fibres_and_across_them() {
        let angle: f64 = 0.4;
        let (s, c) = angle.sin_cos();
        let along = Vector3::new(c * c, s * s, s * c);
        let across = Vector3::new(s * s, c * c, -s * c);
        for (place, direction) in [(0, along), (1, across)] {
            let mut q = Matrix3::zeros();
            q[(place, place)] = 3.0;
            let found = turned(&q, angle);
            assert!(
                (found - 3.0 * direction * direction.transpose()).norm() < 1e-14,
                "{found}"
            );
        }
    }
}
