//! Structured triangle mesh that follows rod, spars and outline.
//!
//! Every column (see [`super::columns`]) carries the same number of elements from leading to trailing edge;
//! the quadrangles between two columns are halved along alternating diagonals, or along the better one where
//! the outline is steep. Ends of rod pieces near a spar get their node by local refinement.

use super::bisect::Refinable;
use super::columns::{Columns, lay_columns};
use super::error::MeshError;
use super::quality::smallest_angle_rad;
use super::{BeamElement, BeamPart, Mesh, ribs};
use crate::geometry::{Layout, Planform};
use crate::input::design::Design;

/// Most elements across the chord: about 2 million triangles on a wing of the paper's shape.
const MOST_CHORDWISE: usize = 512;

/// Most nodes of a mesh: the factor of a structure of so many takes tens of gigabytes.
const MOST_NODES: f64 = 1.5e6;

/// Below this angle the better diagonal is taken instead of the alternating one.
const PREFERRED_ANGLE_DEG: f64 = 25.0;

/// Meshes a design; `mesh.chordwise` × `mesh.refine` elements from leading to trailing edge.
///
/// Without a film only rod and spars are meshed; with ribs, see `mesh::ribs`. Errors: impossible layout or density, elements that fold.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
/// # use std::path::Path;
/// # use washout::{geometry::Planform, input::Design};
/// let design = Design::load(Path::new("designs/twist-v2.toml"), &[])?.design;
/// let planform = Planform::from_design(&design)?;
/// let mesh = washout::mesh::generate(&design, &planform)?;
/// assert!((mesh.area_m2() / planform.area_m2() - 1.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn generate(design: &Design, planform: &Planform) -> Result<Mesh, MeshError> {
    if let Some(ribs) = &design.ribs {
        return ribs::generate(design, planform, ribs);
    }
    let layout = Layout::from_design(design, planform)?;
    let chordwise = chordwise_elements(design)?;
    refuse_too_many(design, planform, chordwise)?;
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

/// Refuses what no memory holds before anything is laid out.
fn refuse_too_many(design: &Design, planform: &Planform, chordwise: usize) -> Result<(), MeshError> {
    let across = chordwise as f64;
    let along = planform.length_m() / planform.mean_chord_m() * across;
    let nodes = along * across;
    if nodes <= MOST_NODES {
        return Ok(());
    }
    Err(MeshError::TooMany {
        nodes,
        largest: MOST_NODES,
        chordwise: design.mesh.chordwise,
        refine: design.mesh.refine,
    })
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
            nodes.push([
                rounded(column.leading_edge_m + eta * sweep_m),
                rounded(eta * chord_m),
                0.0,
            ]);
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

/// A length to the picometre: the same mesh, bit for bit, whatever the last bit of a platform's `exp`.
fn rounded(metres: f64) -> f64 {
    (metres * 1e12).round() / 1e12
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
