//! The generated mesh: its lines, its shape, its area, and what it refuses.

use washout::geometry::Planform;
use washout::input::design::Design;
use washout::mesh::check::check;
use washout::mesh::{BeamPart, Mesh, MeshError, Quality, generate, gmsh};

/// The paper's planform with rods `[from, to]`, spars `[at, trailing edge at]`, and more lines of TOML.
fn design(rods: &[[f64; 2]], spars: &[[f64; 2]], refine: f64, more: &str) -> Design {
    let section = "section = { shape = 'round', diameter_mm = 1.0 }";
    let mut text = String::from("format = 1\nname = 'w'\n");
    text += "[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\nroot_offset_mm = 38.0\n";
    text += &format!("[mesh]\nrefine = {refine:?}\n{more}\n");
    for [from, to] in rods {
        text += &format!("[[rod]]\nfrom_mm = {from:?}\nto_mm = {to:?}\n{section}\n");
    }
    for [at, trailing] in spars {
        text += &format!("[[spar]]\nat_mm = {at:?}\ntrailing_edge_at_mm = {trailing:?}\n{section}\n");
    }
    toml::from_str(&text).unwrap()
}

const FILM: &str = "[film]\nmaterial = 'kapton'\nthickness_mm = 0.006";
const FULL: &[[f64; 2]] = &[[0.0, 70.0]];
const STEPPED: &[[f64; 2]] = &[[0.0, 39.9], [39.9, 70.0]];

fn straight(fractions: &[f64]) -> Vec<[f64; 2]> {
    fractions.iter().map(|f| [70.0 * f; 2]).collect()
}

/// Pieces of the rod, and ends of the spars, mm.
type RodAndSpars = (&'static [[f64; 2]], Vec<[f64; 2]>);

/// Rods and spars of the paper's three wings.
fn three_wings() -> [RodAndSpars; 3] {
    let five = straight(&[0.04, 0.27, 0.5, 0.73, 0.96]);
    [
        (FULL, straight(&[0.3, 0.7])),
        (FULL, five.clone()),
        (STEPPED, five),
    ]
}

fn mesh(design: &Design) -> (Mesh, Planform) {
    let planform = Planform::from_design(design).unwrap();
    let mesh = generate(design, &planform).unwrap();
    (mesh, planform)
}

#[test]
fn the_three_wings_have_no_slivers_and_their_area_converges() {
    for (rods, spars) in three_wings() {
        let mut errors = Vec::new();
        for refine in [0.5, 1.0, 2.0, 4.0] {
            let (mesh, planform) = mesh(&design(rods, &spars, refine, FILM));
            let quality = Quality::of(&mesh);
            assert!(
                quality.smallest_angle_deg > 15.0,
                "refine {refine}: {} deg at {:?}",
                quality.smallest_angle_deg,
                mesh.triangles[quality.worst_triangle.unwrap()].map(|node| mesh.nodes[node])
            );
            assert!(
                quality.largest_aspect < 4.0,
                "refine {refine}: {}",
                quality.largest_aspect
            );
            errors.push((quality.area_m2 / planform.area_m2() - 1.0).abs());
        }
        assert!(errors[1] < 2e-3, "{errors:?}");
        assert!(
            errors.windows(2).all(|w| w[1] < 0.4 * w[0]),
            "second order: {errors:?}"
        );
    }
}

#[test]
fn columns_are_straight_and_the_rod_changes_at_a_node() {
    let (rods, spars) = three_wings()[2].clone();
    let (mesh, planform) = mesh(&design(rods, &spars, 1.0, FILM));
    let rows = 13;
    assert_eq!(mesh.nodes.len() % rows, 0);
    for column in mesh.nodes.chunks(rows) {
        assert!(
            column.iter().all(|p| p[0] == column[0][0]),
            "not straight: {column:?}"
        );
        assert_eq!(column[0][1], 0.0);
        assert!((column[rows - 1][1] - planform.chord_m(column[0][0])).abs() < 4e-12);
    }
    let joint = mesh
        .leading_edge
        .iter()
        .find(|&&node| mesh.nodes[node][0] == 0.0399)
        .unwrap();
    let at_joint: Vec<_> = mesh
        .beams
        .iter()
        .filter(|beam| beam.nodes.contains(joint))
        .collect();
    assert_eq!(
        at_joint.iter().map(|beam| beam.part).collect::<Vec<_>>(),
        [BeamPart::Rod(0), BeamPart::Rod(1)]
    );
    assert_eq!(mesh.rod_nodes(), mesh.leading_edge);
    assert_eq!(mesh.spar_count(), 5);
    for (index, spar) in spars.iter().enumerate() {
        let nodes = mesh.spar_nodes(index);
        assert_eq!(nodes.len(), rows);
        assert!(mesh.leading_edge.contains(&nodes[0]) && mesh.trailing_edge.contains(&nodes[rows - 1]));
        assert!((mesh.nodes[nodes[4]][0] - spar[0] / 1000.0).abs() < 1e-12);
    }
    assert_eq!(mesh.root[0], mesh.leading_edge[0]);
    assert_eq!(mesh.root.len(), rows);
}

#[test]
fn neighbouring_triangles_alternate_in_the_middle_of_the_wing() {
    // In a union-jack pattern inner nodes belong to 4 and 8 triangles in turn; a one-way pattern gives 6.
    let (mesh, _) = mesh(&design(FULL, &[], 1.0, FILM));
    let mut valence = vec![0; mesh.nodes.len()];
    mesh.triangles
        .iter()
        .flatten()
        .for_each(|&node| valence[node] += 1);
    let inner = (0..mesh.nodes.len()).filter(|&node| {
        let [x, y, _] = mesh.nodes[node];
        (0.03..0.04).contains(&x) && y > 0.003 && y < 0.02
    });
    assert!(inner.clone().count() > 20);
    assert!(inner.clone().all(|node| valence[node] == 4 || valence[node] == 8));
}

#[test]
fn a_rod_joint_near_a_spar_is_refined_locally_without_slivers() {
    for joint in [35.05, 34.9, 35.3, 18.9001, 67.4, 1.5, 69.2] {
        let spars = straight(&[0.04, 0.27, 0.5, 0.73, 0.96]);
        for refine in [0.5, 1.0, 2.0] {
            let (mesh, _) = mesh(&design(&[[0.0, joint], [joint, 70.0]], &spars, refine, FILM));
            let quality = Quality::of(&mesh);
            assert!(quality.smallest_angle_deg > 9.0, "{joint} {refine}: {quality:?}");
            assert!(
                mesh.leading_edge
                    .iter()
                    .any(|&node| (mesh.nodes[node][0] - joint / 1000.0).abs() < 1e-12)
            );
            let outboard = mesh.beams.iter().filter(|beam| beam.part == BeamPart::Rod(1));
            assert!(outboard.clone().count() > 0);
            assert!(
                outboard
                    .clone()
                    .all(|beam| mesh.nodes[beam.nodes[0]][0] > joint / 1000.0 - 1e-12)
            );
            assert_eq!(mesh.rod_nodes(), mesh.leading_edge);
        }
    }
}

#[test]
fn oblique_spars_are_straight_lines_between_their_ends() {
    let spars = [[12.0, 5.0], [30.0, 30.0], [45.0, 55.0]];
    let (mesh, planform) = mesh(&design(STEPPED, &spars, 1.0, FILM));
    assert!(
        Quality::of(&mesh).smallest_angle_deg > 15.0,
        "{:?}",
        Quality::of(&mesh)
    );
    assert!((mesh.area_m2() / planform.area_m2() - 1.0).abs() < 3e-3);
    assert!(
        mesh.leading_edge
            .iter()
            .any(|&node| mesh.nodes[node][0] == 0.0399)
    );
    let nodes = mesh.spar_nodes(2);
    let (first, last) = (mesh.nodes[nodes[0]], mesh.nodes[nodes[12]]);
    assert!((first[0] - 0.045).abs() < 1e-15 && (last[0] - 0.055).abs() < 1e-15);
    for node in nodes {
        let p = mesh.nodes[node];
        assert!((p[0] - (0.045 + 0.010 * p[1] / last[1])).abs() < 2e-12);
    }
}

#[test]
fn a_rod_that_stops_early_leaves_film_beyond_it() {
    let (mesh, _) = mesh(&design(&[[0.0, 30.0]], &straight(&[0.3, 0.7]), 1.0, FILM));
    let rod = mesh.rod_nodes();
    assert_eq!(mesh.nodes[rod[rod.len() - 1]][0], 0.030);
    assert_eq!(
        mesh.nodes[mesh.leading_edge[mesh.leading_edge.len() - 1]][0],
        0.0693
    );
}

#[test]
fn without_film_only_beams_are_left_and_loose_spars_are_refused() {
    let spars = straight(&[0.3, 0.4]);
    let (mesh, planform) = mesh(&design(&[[0.0, 30.0]], &spars, 1.0, ""));
    assert!(mesh.triangles.is_empty());
    let mut used = vec![false; mesh.nodes.len()];
    mesh.beams
        .iter()
        .flat_map(|beam| beam.nodes)
        .for_each(|node| used[node] = true);
    assert!(used.into_iter().all(|is_used| is_used));
    assert_eq!(mesh.root, [mesh.rod_nodes()[0]]);
    assert_eq!(mesh.leading_edge, mesh.rod_nodes());
    assert_eq!(
        mesh.trailing_edge,
        [mesh.spar_nodes(0)[12], mesh.spar_nodes(1)[12]]
    );
    let loose = design(&[[0.0, 30.0]], &straight(&[0.3, 0.7]), 1.0, "");
    assert_eq!(
        generate(&loose, &planform).unwrap_err().to_string(),
        "spar[1] stands at 49 mm, but the rod ends at 30 mm and there is no film to hold it; \
         lengthen the rod, move the spar, or add [film]"
    );
}

#[test]
fn impossible_densities_and_folds_are_refused() {
    let mut wing = design(FULL, &[], 1.0, FILM);
    let planform = Planform::from_design(&wing).unwrap();
    for refine in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e6, 0.1] {
        wing.mesh.refine = refine;
        assert!(
            matches!(generate(&wing, &planform), Err(MeshError::Density { .. })),
            "{refine}"
        );
    }
    // a hundred metres of a tenth of a millimetre: sixteen gigabytes of columns, were it laid out
    let mut thread = design(FULL, &[], 1.0, FILM);
    thread.planform.length_mm = 1e5.into();
    thread.planform.mean_chord_mm = Some(0.1.into());
    thread.mesh.refine = 40.0;
    let planform = Planform::from_design(&thread).unwrap();
    assert!(matches!(
        generate(&thread, &planform),
        Err(MeshError::TooMany { .. })
    ));
    // The film is narrow at mid-span: a line across it runs through air, and its neighbours cross it.
    let mut waist = design(FULL, &[[5.0, 60.0]], 1.0, FILM);
    waist.planform.r2_hat = None;
    waist.planform.outline = Some(vec![[0.0, 20.0], [35.0, 2.0], [70.0, 20.0]]);
    let planform = Planform::from_design(&waist).unwrap();
    assert!(matches!(
        generate(&waist, &planform),
        Err(MeshError::Folded { .. })
    ));
}

#[test]
fn spars_on_the_root_and_on_the_tip_close_the_wing() {
    let (mesh, _) = mesh(&design(FULL, &[[0.0, 0.0], [69.3, 69.3]], 1.0, FILM));
    assert_eq!(mesh.spar_nodes(0), mesh.root);
    assert_eq!(
        mesh.spar_nodes(1)[0],
        mesh.leading_edge[mesh.leading_edge.len() - 1]
    );
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig { cases: 300, failure_persistence: None, ..Default::default() })]

    /// Down to a few picometres: two nodes at one place would be refused by the check of the mesh.
    #[test]
    fn a_joint_ever_nearer_to_a_spar_is_meshed_soundly(at in 1.0..60.0f64, decade in -8.5..-1.0f64, beyond: bool, film: bool) {
        let joint = at + if beyond { 10f64.powf(decade) } else { -10f64.powf(decade) };
        let design = design(&[[0.0, joint], [joint, 69.3]], &[[at, at]], 0.5, if film { FILM } else { "" });
        let mesh = generate(&design, &Planform::from_design(&design).unwrap()).unwrap();
        check(&mesh).unwrap_or_else(|defect| panic!("{joint} beside {at}: {defect}"));
    }

    #[test]
    fn whatever_is_meshed_is_sound(
        places in proptest::collection::vec((0.0..69.3f64, -4.0..4.0f64), 0..8),
        straight_across: bool,
        joint in 0.1..68.0f64,
        near in proptest::option::of(-1.0..1.0f64),
        end in 68.5..70.0f64,
        refine in 0.17..1.5f64,
        film: bool,
    ) {
        let mut ends: Vec<[f64; 2]> = places
            .iter()
            .map(|&(at, sweep)| [at, if straight_across { at } else { (at + sweep).clamp(0.001, 69.299) }])
            .collect();
        ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
        ends.dedup_by(|next, kept| next[0] <= kept[0] + 0.01 || next[1] <= kept[1] + 0.01);
        // Joints at, beside and far from spars.
        let joint = match (near, ends.first()) {
            (Some(offset), Some(first)) => (first[0] + offset.powi(5)).clamp(0.1, 68.0),
            _ => joint,
        };
        let design = design(&[[0.0, joint], [joint, end]], &ends, refine, if film { FILM } else { "" });
        let planform = Planform::from_design(&design).unwrap();
        match generate(&design, &planform) {
            Ok(mesh) => {
                check(&mesh).unwrap_or_else(|defect| panic!("{defect}"));
                if film && straight_across {
                    proptest::prop_assert!((mesh.area_m2() / planform.area_m2() - 1.0).abs() < 0.05);
                }
                let again = gmsh::read(gmsh::write(&mesh).as_bytes(), "again.msh").unwrap();
                proptest::prop_assert_eq!(again, mesh);
            }
            Err(error) => proptest::prop_assert!(
                matches!(error, MeshError::Folded { .. } | MeshError::LooseSpar { .. }),
                "{}", error
            ),
        }
    }
}
