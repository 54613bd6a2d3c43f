//! Does an imported mesh belong to the design? Same rod pieces and spars, a film where there is one, same outline.

use std::collections::BTreeSet;

use super::{BeamPart, Mesh};
use crate::geometry::Planform;
use crate::input::design::Design;

/// Largest difference between mesh and outline, as a share of length or area.
const SLACK: f64 = 0.02;

/// What of an imported mesh does not belong to the design. Lengths in mm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Misfit {
    /// More or fewer rod pieces or spars.
    #[error(
        "the mesh has {found} {what}, the design {expected}; name the sets {what}-0, {what}-1, … as the design \
         counts them, or change the design"
    )]
    Parts {
        /// "rod" or "spar".
        what: &'static str,
        /// In the mesh.
        found: usize,
        /// In the design.
        expected: usize,
    },
    /// A film on one side only.
    #[error("{}", if *.in_mesh { "the mesh has triangles, but the design has no [film]; add one, or take the triangles out" } else { "the design has a [film], but the mesh has no triangles; add them, or take [film] out" })]
    Film {
        /// Whether the mesh has it.
        in_mesh: bool,
    },
    /// Another length.
    #[error(
        "the mesh ends at {mesh_mm:.2} mm, the wing at {wing_mm:.2} mm; set planform.length_mm and tip_cut to the mesh"
    )]
    Length {
        /// End of the mesh.
        mesh_mm: f64,
        /// Tip as built.
        wing_mm: f64,
    },
    /// Another area.
    #[error(
        "the mesh covers {mesh_mm2:.1} mm², the outline {wing_mm2:.1} mm²; give the mesh's outline as \
         planform.outline = [[r_mm, chord_mm], …]"
    )]
    Area {
        /// Area of the triangles.
        mesh_mm2: f64,
        /// Area of the outline as built.
        wing_mm2: f64,
    },
}

/// Checks that a mesh, sound in itself, belongs to a design.
pub fn fit(mesh: &Mesh, design: &Design, planform: &Planform) -> Result<(), Misfit> {
    let indices = |pick: fn(BeamPart) -> Option<usize>| -> BTreeSet<usize> {
        mesh.beams.iter().filter_map(|beam| pick(beam.part)).collect()
    };
    let rods = indices(|part| {
        if let BeamPart::Rod(index) = part {
            Some(index)
        } else {
            None
        }
    });
    let spars = indices(|part| {
        if let BeamPart::Spar(index) = part {
            Some(index)
        } else {
            None
        }
    });
    for (what, found, expected) in [
        ("rod", rods, design.rod.len()),
        ("spar", spars, design.spar.len()),
    ] {
        if !found.iter().copied().eq(0..expected) {
            let found = found.len();
            return Err(Misfit::Parts {
                what,
                found,
                expected,
            });
        }
    }
    let in_mesh = !mesh.triangles.is_empty();
    if in_mesh != design.film.is_some() {
        return Err(Misfit::Film { in_mesh });
    }
    let (mesh_mm, wing_mm) = (mesh.bounds_m()[1][0] * 1e3, planform.tip_m() * 1e3);
    if (mesh_mm - wing_mm).abs() > SLACK * wing_mm {
        return Err(Misfit::Length { mesh_mm, wing_mm });
    }
    let (mesh_mm2, wing_mm2) = (mesh.area_m2() * 1e6, planform.area_m2() * 1e6);
    if in_mesh && (mesh_mm2 - wing_mm2).abs() > SLACK * wing_mm2 {
        return Err(Misfit::Area { mesh_mm2, wing_mm2 });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate;

    fn wing(text: &str) -> (Design, Planform) {
        let head =
            "format = 1\nname = \"w\"\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n";
        let tail = "[film]\nmaterial = \"k\"\nthickness_mm = 0.006\n[material.k]\ne_gpa = 2.5\npoisson = 0.3\n\
                    density_kg_m3 = 1420.0\n";
        let design = Design::from_toml(&format!("{head}{text}{tail}"), "w").unwrap_or_else(|e| panic!("{e}"));
        let planform = Planform::from_design(&design).expect("a planform");
        (design, planform)
    }

    const ROD: &str = "[[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\nmaterial = \"k\"\nsection = { shape = \"round\", \
                       diameter_mm = 1.0 }\n";
    const SPAR: &str =
        "[[spar]]\nat_mm = 30.0\nmaterial = \"k\"\nsection = { shape = \"round\", diameter_mm = 0.2 }\n";

    #[test]
    fn its_own_mesh_fits_and_the_mesh_of_another_layout_does_not() {
        let (design, planform) = wing(&format!("{ROD}{SPAR}"));
        let mesh = generate(&design, &planform).expect("a mesh");
        assert_eq!(fit(&mesh, &design, &planform), Ok(()));
        let (bare, _) = wing(ROD);
        let expected = Misfit::Parts {
            what: "spar",
            found: 1,
            expected: 0,
        };
        assert_eq!(fit(&mesh, &bare, &planform), Err(expected));
    }

    #[test]
    fn another_film_length_or_area_is_refused() {
        let (mut design, planform) = wing(ROD);
        let mesh = generate(&design, &planform).expect("a mesh");
        let mut longer = mesh.clone();
        longer.nodes.iter_mut().for_each(|node| node[0] *= 1.03);
        assert!(matches!(
            fit(&longer, &design, &planform),
            Err(Misfit::Length { .. })
        ));
        let mut wider = mesh.clone();
        wider.nodes.iter_mut().for_each(|node| node[1] *= 1.03);
        assert!(matches!(
            fit(&wider, &design, &planform),
            Err(Misfit::Area { .. })
        ));
        design.film = None;
        assert_eq!(
            fit(&mesh, &design, &planform),
            Err(Misfit::Film { in_mesh: true })
        );
    }
}
