//! A mesh that Gmsh itself made (bay.geo, `gmsh -2 -format msh41`, version 4.8.4).

use washout::mesh::gmsh::read;
use washout::mesh::{BeamPart, ChordLines, Mesh};

fn bay() -> Mesh {
    read(include_bytes!("bay.msh"), "bay.msh").unwrap()
}

#[test]
fn the_mesh_is_turned_and_sorted_into_the_order_of_a_wing() {
    let mesh = bay();
    assert_eq!(mesh.nodes.len(), 30);
    // One of the two surfaces of bay.geo is meshed clockwise.
    assert!((0..mesh.triangles.len()).all(|index| mesh.triangle_area_m2(index) > 0.0));
    // Trapezia: 18 and 20 mm wide below and above the spar, by the shoelace formula.
    let outline = [
        [0.0, 0.0],
        [0.030, 0.0],
        [0.030, 0.008],
        [0.020, 0.012],
        [0.0, 0.015],
    ];
    let shoelace: f64 = (0..5)
        .map(|k| (outline[k], outline[(k + 1) % 5]))
        .map(|(p, q)| p[0] * q[1] - q[0] * p[1])
        .sum();
    assert!(
        (mesh.area_m2() / (0.5 * shoelace) - 1.0).abs() < 1e-9,
        "{}",
        mesh.area_m2()
    );
    let x_m = |nodes: &[usize]| nodes.iter().map(|&node| mesh.nodes[node][0]).collect::<Vec<_>>();
    assert!(x_m(&mesh.leading_edge).is_sorted() && x_m(&mesh.trailing_edge).is_sorted());
    assert_eq!(mesh.rod_nodes(), mesh.leading_edge);
    assert_eq!(mesh.root[0], mesh.rod_nodes()[0]);
    assert_eq!(
        mesh.beams
            .iter()
            .filter(|beam| beam.part == BeamPart::Rod(0))
            .count(),
        2
    );
    let spar = mesh.spar_nodes(0);
    assert_eq!(mesh.nodes[spar[0]], [0.018, 0.0, 0.0]);
    assert_eq!(mesh.nodes[spar[spar.len() - 1]], [0.020, 0.012, 0.0]);
}

#[test]
fn chord_lines_of_an_unstructured_mesh_reproduce_linear_fields_from_edge_to_edge() {
    let mesh = bay();
    let lines = ChordLines::new(&mesh);
    for step in 0..=300 {
        let r_m = 1e-4 * f64::from(step);
        let line = lines.at(r_m).unwrap();
        let chord_m = if r_m <= 0.020 {
            0.015 - 0.15 * r_m
        } else {
            0.012 - 0.4 * (r_m - 0.020)
        };
        assert!(line.points[0].y_m.abs() < 1e-12);
        assert!(
            (line.points[line.points.len() - 1].y_m - chord_m).abs() < 1e-9,
            "{r_m}"
        );
        for point in &line.points {
            let x_m: f64 = (0..2)
                .map(|k| point.weights[k] * mesh.nodes[point.nodes[k]][0])
                .sum();
            assert!((x_m - r_m).abs() < 1e-11);
        }
    }
}

#[test]
fn the_same_mesh_saved_as_msh_2_2_is_the_same_wing() {
    // gmsh -2 -format msh22: no entities, and an element of two groups stands there twice
    assert_eq!(read(include_bytes!("bay-22.msh"), "bay-22.msh").unwrap(), bay());
}
