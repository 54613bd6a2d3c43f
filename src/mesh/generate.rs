//! Structured triangle mesh that follows rod, spars and outline.
//!
//! Every column (see [`super::columns`]) carries the same number of elements from leading to trailing edge;
//! the quadrangles between two columns are halved along alternating diagonals, or along the better one where
//! the outline is steep. Ends of rod pieces near a spar get their node by local refinement.

use super::bisect::Refinable;
use super::columns::{Columns, lay_columns};
use super::error::MeshError;
use super::quality::smallest_angle_rad;
use super::{BeamElement, BeamPart, Mesh};
use crate::geometry::{Layout, Planform};
use crate::input::design::Design;

/// Most elements across the chord: about 2 million triangles on a wing of the paper's shape.
const MOST_CHORDWISE: usize = 512;

/// Below this angle the better diagonal is taken instead of the alternating one.
const PREFERRED_ANGLE_DEG: f64 = 25.0;

/// Meshes a design; `mesh.chordwise` × `mesh.refine` elements from leading to trailing edge.
///
/// Without a film only rod and spars are meshed. Errors: impossible layout or density, elements that fold.
pub fn generate(design: &Design, planform: &Planform) -> Result<Mesh, MeshError> {
    let layout = Layout::from_design(design, planform)?;
    let chordwise = chordwise_elements(design)?;
    let columns = lay_columns(planform, &layout, chordwise);
    let mut grid = grid(planform, &columns, chordwise);
    for &x_m in &columns.local_breaks_m {
        grid.put_node_at(LEADING_EDGE, x_m);
    }
    let mut mesh = Mesh {
        beams: beams(&grid, &columns, &layout),
        ..Mesh::default()
    };
    let mut chains = grid.chains.into_iter();
    mesh.leading_edge = chains.next().unwrap_or_default();
    mesh.trailing_edge = chains.next().unwrap_or_default();
    mesh.root = chains.next().unwrap_or_default();
    mesh.nodes = grid.nodes;
    mesh.triangles = grid.triangles;
    if let Some(folded) = first_folded(&mesh) {
        return Err(MeshError::Folded {
            at_mm: mesh.nodes[mesh.triangles[folded][0]][0] * 1000.0,
        });
    }
    if design.film.is_none() {
        refuse_loose_spars(&layout)?;
        keep_beams_only(&mut mesh);
    }
    Ok(mesh)
}

/// A triangle whose area is not positive, or not a number.
fn first_folded(mesh: &Mesh) -> Option<usize> {
    (0..mesh.triangles.len()).find(|&index| {
        let is_sound = mesh.triangle_area_m2(index) > 0.0;
        !is_sound
    })
}

fn chordwise_elements(design: &Design) -> Result<usize, MeshError> {
    let (chordwise, refine) = (design.mesh.chordwise, design.mesh.refine);
    let elements = (chordwise as f64 * refine).round();
    if !(refine > 0.0 && elements >= 2.0 && elements <= MOST_CHORDWISE as f64) {
        return Err(MeshError::Density {
            chordwise,
            refine,
            elements,
            largest: MOST_CHORDWISE,
        });
    }
    Ok(elements as usize)
}

/// Chains of the grid: leading edge, trailing edge, root, then one per column with a spar, from root to tip.
const LEADING_EDGE: usize = 0;
const FIRST_SPAR: usize = 3;

/// Nodes column by column, each from leading to trailing edge; triangles; chains.
fn grid(planform: &Planform, columns: &Columns, chordwise: usize) -> Refinable {
    let columns = &columns.columns;
    let index = |column: usize, row: usize| column * (chordwise + 1) + row;
    let mut nodes = Vec::with_capacity(columns.len() * (chordwise + 1));
    for column in columns {
        let chord_m = planform.chord_m(column.trailing_edge_m);
        for row in 0..=chordwise {
            let eta = row as f64 / chordwise as f64;
            let sweep_m = column.trailing_edge_m - column.leading_edge_m;
            nodes.push([column.leading_edge_m + eta * sweep_m, eta * chord_m, 0.0]);
        }
    }
    let mut triangles = Vec::with_capacity(2 * columns.len() * chordwise);
    for column in 0..columns.len() - 1 {
        for row in 0..chordwise {
            let [a, b] = [index(column, row), index(column + 1, row)];
            let [c, d] = [b + 1, a + 1];
            triangles.extend(halves(&nodes, [a, b, c, d], (column + row) % 2 == 0));
        }
    }
    let line = |column: usize| (0..=chordwise).map(|row| index(column, row)).collect::<Vec<_>>();
    let across = |row: usize| {
        (0..columns.len())
            .map(|column| index(column, row))
            .collect::<Vec<_>>()
    };
    let mut chains = vec![across(0), across(chordwise), line(0)];
    chains.extend(
        (0..columns.len())
            .filter(|&column| columns[column].spar.is_some())
            .map(line),
    );
    Refinable {
        nodes,
        triangles,
        chains,
    }
}

/// The two triangles of a quadrangle a-b-c-d, along a-c where `rising`, unless the other diagonal is far better.
fn halves(nodes: &[[f64; 3]], [a, b, c, d]: [usize; 4], rising: bool) -> [[usize; 3]; 2] {
    let (along_ac, along_bd) = ([[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]);
    let angle = |pair: &[[usize; 3]; 2]| {
        pair.iter()
            .map(|t| smallest_angle_rad(t.map(|node| nodes[node])))
            .fold(f64::INFINITY, f64::min)
    };
    let (wanted, other) = if rising {
        (along_ac, along_bd)
    } else {
        (along_bd, along_ac)
    };
    let wanted_angle = angle(&wanted);
    if wanted_angle < PREFERRED_ANGLE_DEG.to_radians() && angle(&other) > wanted_angle {
        other
    } else {
        wanted
    }
}

/// Rod elements from base to tip, then the spars in the design's order, each from leading to trailing edge.
fn beams(grid: &Refinable, columns: &Columns, layout: &Layout) -> Vec<BeamElement> {
    let mut beams = Vec::new();
    for w in grid.chains[LEADING_EDGE].windows(2) {
        let middle_m = 0.5 * (grid.nodes[w[0]][0] + grid.nodes[w[1]][0]);
        if let Some(piece) = layout.rod_piece_at(middle_m) {
            beams.push(BeamElement {
                nodes: [w[0], w[1]],
                part: BeamPart::Rod(piece),
            });
        }
    }
    let indices = columns.columns.iter().filter_map(|column| column.spar);
    let mut spars: Vec<_> = indices.zip(&grid.chains[FIRST_SPAR..]).collect();
    spars.sort_by_key(|&(index, _)| index);
    for (index, chain) in spars {
        let part = BeamPart::Spar(index);
        beams.extend(chain.windows(2).map(|w| BeamElement {
            nodes: [w[0], w[1]],
            part,
        }));
    }
    beams
}

fn refuse_loose_spars(layout: &Layout) -> Result<(), MeshError> {
    let rod_end_m = layout.rod.last().map_or(0.0, |piece| piece.to_m);
    match layout
        .spars
        .iter()
        .find(|spar| spar.leading_edge_m > rod_end_m + 1e-9)
    {
        Some(spar) => Err(MeshError::LooseSpar {
            index: spar.index,
            at_mm: (spar.leading_edge_m * 1e9).round() / 1e6,
            rod_end_mm: (rod_end_m * 1e9).round() / 1e6,
        }),
        None => Ok(()),
    }
}

/// Drops the film, and the nodes that no beam uses.
fn keep_beams_only(mesh: &mut Mesh) {
    mesh.triangles.clear();
    let mut new_index = vec![None; mesh.nodes.len()];
    for beam in &mesh.beams {
        for node in beam.nodes {
            new_index[node] = Some(0);
        }
    }
    let mut kept = Vec::new();
    for (node, slot) in new_index
        .iter_mut()
        .enumerate()
        .filter(|(_, slot)| slot.is_some())
    {
        *slot = Some(kept.len());
        kept.push(mesh.nodes[node]);
    }
    mesh.nodes = kept;
    for beam in &mut mesh.beams {
        beam.nodes = beam.nodes.map(|node| new_index[node].unwrap_or(0));
    }
    for set in [&mut mesh.root, &mut mesh.leading_edge, &mut mesh.trailing_edge] {
        *set = set.iter().filter_map(|&node| new_index[node]).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Quality;

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
            assert_eq!(column[rows - 1][1], planform.chord_m(column[0][0]));
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
            assert_eq!(mesh.nodes[nodes[4]][0], spar[0] / 1000.0);
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
                        .any(|&node| mesh.nodes[node][0] == joint / 1000.0)
                );
                let outboard = mesh.beams.iter().filter(|beam| beam.part == BeamPart::Rod(1));
                assert!(outboard.clone().count() > 0);
                assert!(
                    outboard
                        .clone()
                        .all(|beam| mesh.nodes[beam.nodes[0]][0] >= joint / 1000.0)
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
            assert!((p[0] - (0.045 + 0.010 * p[1] / last[1])).abs() < 1e-15);
        }
    }

    #[test]
    fn a_rod_that_stops_early_leaves_film_beyond_it() {
        let (mesh, planform) = mesh(&design(&[[0.0, 30.0]], &straight(&[0.3, 0.7]), 1.0, FILM));
        let rod = mesh.rod_nodes();
        assert_eq!(mesh.nodes[rod[rod.len() - 1]][0], 0.030);
        assert_eq!(
            mesh.nodes[mesh.leading_edge[mesh.leading_edge.len() - 1]][0],
            planform.tip_m()
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
}
