//! The meshes in `meshes/` are those of the designs in `designs/`, byte for byte, and can be given back.

use std::path::Path;

use washout::input::Design;
use washout::mesh::check::check;
use washout::mesh::{MeshFile, Quality, for_design, gmsh};

const WINGS: [&str; 3] = ["rigid", "twist-v1", "twist-v2"];

fn design(name: &str) -> Design {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("designs/{name}.toml"));
    Design::load(&path, &[])
        .unwrap_or_else(|error| panic!("{error}"))
        .design
}

fn path(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("meshes/{name}.msh"))
}

/// Writes the files anew: `cargo test --release --test mesh -- --ignored write_the_shipped_meshes`.
#[test]
#[ignore = "writes into meshes/; run it after a change of a design or of the generator"]
fn write_the_shipped_meshes() {
    for name in WINGS {
        let (_, mesh) = for_design(&design(name), None).unwrap();
        std::fs::write(path(name), gmsh::write(&mesh)).unwrap();
    }
}

#[test]
fn meshing_the_designs_gives_the_shipped_files() {
    for name in WINGS {
        let (planform, mesh) = for_design(&design(name), None).unwrap();
        check(&mesh).unwrap_or_else(|defect| panic!("{name}: {defect}"));
        let quality = Quality::of(&mesh);
        assert!(quality.smallest_angle_deg > 15.0, "{name}: {quality:?}");
        assert!(
            (quality.area_m2 / planform.area_m2() - 1.0).abs() < 2e-3,
            "{name}: {quality:?}"
        );
        let shipped = std::fs::read_to_string(path(name)).unwrap();
        assert!(
            gmsh::write(&mesh) == shipped,
            "meshes/{name}.msh is not the mesh of designs/{name}.toml; write it anew"
        );
    }
}

#[test]
fn a_shipped_mesh_given_back_is_the_same_wing() {
    for name in WINGS {
        let bytes = std::fs::read(path(name)).unwrap();
        let given = for_design(&design(name), Some(MeshFile { name, bytes: &bytes })).unwrap();
        assert_eq!(given, for_design(&design(name), None).unwrap(), "{name}");
    }
}
