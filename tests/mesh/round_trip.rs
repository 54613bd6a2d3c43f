//! Written and read back, a mesh is the same bit for bit; mutated files never make the reader panic.

use proptest::prelude::*;
use washout::geometry::Planform;
use washout::input::design::Design;
use washout::mesh::check::check;
use washout::mesh::gmsh::{read, write};
use washout::mesh::{Mesh, generate};

const SECTION: &str = "section = { shape = 'round', diameter_mm = 1.0 }";

/// A wing of the paper's planform, with or without film.
fn wing(joint_mm: f64, end_mm: f64, spars: &[[f64; 2]], refine: f64, film: bool) -> Mesh {
    let mut text = format!(
        "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
         [mesh]\nrefine = {refine:?}\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = {joint_mm:?}\n{SECTION}\n\
         [[rod]]\nfrom_mm = {joint_mm:?}\nto_mm = {end_mm:?}\n{SECTION}\n"
    );
    for [at, trailing] in spars {
        text += &format!("[[spar]]\nat_mm = {at:?}\ntrailing_edge_at_mm = {trailing:?}\n{SECTION}\n");
    }
    if film {
        text += "[film]\nmaterial = 'kapton'\nthickness_mm = 0.006\n";
    }
    let design: Design = toml::from_str(&text).unwrap();
    generate(&design, &Planform::from_design(&design).unwrap()).unwrap()
}

fn bits(mesh: &Mesh) -> Vec<[u64; 3]> {
    mesh.nodes.iter().map(|p| p.map(f64::to_bits)).collect()
}

#[test]
fn a_file_reads_plainly() {
    let text = write(&wing(20.0, 40.0, &[[30.0, 30.0]], 0.2, true));
    assert!(text.starts_with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n"));
    for name in [
        "rod-0",
        "rod-1",
        "spar-0",
        "root",
        "leading-edge",
        "trailing-edge",
        "membrane",
    ] {
        assert!(text.contains(&format!("\"{name}\"")), "{name}");
    }
}

#[test]
fn sound_meshes_are_found_sound() {
    for film in [true, false] {
        check(&wing(39.9, 70.0, &[[14.0, 14.0], [49.0, 49.0]], 1.0, film)).unwrap();
        check(&wing(39.9, 60.0, &[], 1.0, film)).unwrap();
    }
    check(&wing(35.05, 70.0, &[[35.0, 33.0]], 2.0, true)).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read_back_bit_for_bit(
        joint_mm in 5.0..40.0f64,
        end_mm in 50.0..70.0f64,
        first in [8.0..20.0f64, 8.0..20.0f64],
        second in [25.0..48.0f64, 25.0..48.0f64],
        refine in 0.2..1.5f64,
        film: bool,
        wobble in proptest::collection::vec(-0.05..0.05f64, 64),
    ) {
        let mut mesh = wing(joint_mm, end_mm, &[first, second], refine, film);
        // Numbers without a short decimal form, and a nonstructured look; edges stay where they are.
        let size_m = 0.0205 / 12.0 / refine;
        let edge: Vec<usize> = [&mesh.leading_edge, &mesh.trailing_edge, &mesh.root].into_iter().flatten().copied().collect();
        for (node, p) in mesh.nodes.iter_mut().enumerate() {
            if film && p[0] < 0.06 && !edge.contains(&node) {
                p[0] += size_m * wobble[node % 64];
                p[1] *= 1.0 + 0.01 * wobble[(7 * node) % 64];
            }
        }
        // next to a joint a triangle can be so flat that the wobble turns it over
        prop_assume!(check(&mesh).is_ok());
        let text = write(&mesh);
        let back = read(text.as_bytes(), "wing.msh").unwrap();
        prop_assert_eq!(bits(&back), bits(&mesh));
        prop_assert_eq!(&back, &mesh);
        prop_assert_eq!(write(&back), text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_are_read_or_refused_but_never_panic(
        edits in proptest::collection::vec((any::<prop::sample::Index>(), 0..6usize, any::<u8>()), 1..4),
    ) {
        let mut bytes = include_bytes!("bay.msh").to_vec();
        for (place, kind, byte) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = place.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => { bytes.remove(at); }
                2 => bytes.insert(at, b"0123456789-e.$\n \""[byte as usize % 17]),
                3 => bytes.truncate(at),
                4 => bytes[at] = b"0123456789"[byte as usize % 10],
                _ => {
                    // A line moves.
                    let end = bytes[at..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |n| at + n + 1);
                    let line: Vec<u8> = bytes.drain(at..end).collect();
                    let to = if bytes.is_empty() { 0 } else { byte as usize * bytes.len() / 256 };
                    bytes.splice(to..to, line);
                }
            }
        }
        match read(&bytes, "wing.msh") {
            Ok(mesh) => prop_assert!(check(&mesh).is_ok()),
            Err(error) => prop_assert!(error.to_string().starts_with("wing.msh:")),
        }
    }
}
