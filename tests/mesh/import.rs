//! A mesh file must fit the design it is given to.

use washout::geometry::Planform;
use washout::input::design::Design;
use washout::mesh::{Mesh, MeshError, MeshFile, for_design};

const SECTION: &str = "section = { shape = 'round', diameter_mm = 1.0 }";

/// The design of bay.geo, with one thing changed.
fn with_bay(from: &str, to: &str) -> Result<(Planform, Mesh), MeshError> {
    let text = format!(
        "format = 1\nname = 'bay'\n[planform]\nlength_mm = 30.0\nroot_offset_mm = 5.0\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 12.0\n{SECTION}\n[[rod]]\nfrom_mm = 12.0\nto_mm = 30.0\n{SECTION}\n\
         [[spar]]\nat_mm = 18.0\ntrailing_edge_at_mm = 20.0\n{SECTION}\n[[spar]]\nat_mm = 30.0\n{SECTION}\n\
         [film]\nmaterial = 'kapton'\nthickness_mm = 0.006\n"
    );
    assert!(
        from.is_empty() || text.matches(from).count() == 1,
        "`{from}` must stand once"
    );
    let text = if from.is_empty() {
        text
    } else {
        text.replace(from, to)
    };
    let design: Design = toml::from_str(&text).unwrap();
    let file = MeshFile {
        name: "bay.msh",
        bytes: include_bytes!("bay.msh"),
    };
    for_design(&design, Some(file))
}

#[test]
fn a_design_without_a_shape_takes_the_outline_of_the_mesh() {
    let (planform, mesh) = with_bay("", "").unwrap();
    assert!((planform.area_m2() / mesh.area_m2() - 1.0).abs() < 5e-3);
    assert!((planform.tip_m() - 0.030).abs() < 1e-12);
    assert!((planform.chord_m(0.010) - 0.0135).abs() < 1e-6);
    assert_eq!(planform.root_offset_m(), 0.005);
}

#[test]
fn a_mesh_of_another_design_is_refused() {
    let message = |from: &str, to: &str| with_bay(from, to).unwrap_err().to_string();
    assert_eq!(
        message(
            "length_mm = 30.0",
            "length_mm = 30.0\nmean_chord_mm = 12.0\nr2_hat = 0.54"
        ),
        "bay.msh: the mesh ends at r = 30.000 mm, the design at 29.700 mm; mesh files are in metres \
         (gmsh: Mesh.ScalingFactor = 0.001 if it was drawn in mm)"
    );
    assert_eq!(
        message(
            "length_mm = 30.0",
            "length_mm = 30.0\noutline = [[0.0, 15.0], [20.0, 12.0], [30.0, 9.0]]\ntip_cut = 1.0"
        ),
        "bay.msh: the chord at r = 10.000 mm is 13.500 mm in the mesh, 13.687 mm in the design; \
         mesh this design again, or take mean_chord_mm, r1_hat, r2_hat and outline out of [planform] to have the \
         outline from the mesh"
    );
    assert_eq!(
        message("length_mm = 30.0", "length_mm = 100.0"),
        "bay.msh: the mesh ends at r = 30.000 mm, the design at 100.000 mm; mesh files are in metres \
         (gmsh: Mesh.ScalingFactor = 0.001 if it was drawn in mm)"
    );
    assert_eq!(
        message("at_mm = 18.0", "at_mm = 17.0"),
        "bay.msh: spar-0 meets the leading edge at 18.000 mm in the mesh, at 17.000 mm in the design; \
         mesh this design again, or change the design"
    );
    assert_eq!(
        message("trailing_edge_at_mm = 20.0", ""),
        "bay.msh: spar-0 meets the trailing edge at 20.000 mm in the mesh, at 18.000 mm in the design; \
         mesh this design again, or change the design"
    );
    assert_eq!(
        message(
            "to_mm = 12.0\nsection = { shape = 'round', diameter_mm = 1.0 }\n[[rod]]\nfrom_mm = 12.0\n",
            ""
        ),
        "bay.msh: the mesh has 2 rod pieces, the design 1; mesh this design again"
    );
    assert_eq!(
        message(
            "[[spar]]\nat_mm = 30.0\nsection = { shape = 'round', diameter_mm = 1.0 }\n",
            ""
        ),
        "bay.msh: the mesh has 2 spars, the design 1; mesh this design again"
    );
    assert_eq!(
        message("[film]\nmaterial = 'kapton'\nthickness_mm = 0.006\n", ""),
        "bay.msh: the mesh has a membrane, but the design has no [film]; add [film]"
    );
}

#[test]
fn a_design_may_leave_its_shape_to_the_mesh_file_only() {
    let text = |file: &str| {
        format!(
            "format = 1\nname = 'bay'\n[planform]\nlength_mm = 30.0\n[mesh]\n{file}\n\
             [[rod]]\nfrom_mm = 0.0\nto_mm = 30.0\nmaterial = 'carbon'\n{SECTION}\n\
             [material.carbon]\ne_gpa = 134.0\ng_gpa = 4.0\ndensity_kg_m3 = 1500.0\n"
        )
    };
    Design::from_toml(&text("file = 'bay.msh'"), "bay.toml").unwrap_or_else(|error| panic!("{error}"));
    let error = Design::from_toml(&text(""), "bay.toml").unwrap_err();
    assert!(error.to_string().contains("planform.mean_chord_mm"), "{error}");
}
