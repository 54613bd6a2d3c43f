//! A mesh as a Gmsh file, MSH 4.1 in text.

use std::fmt::Write;

use crate::mesh::names::SetName;
use crate::mesh::{BeamPart, Mesh};

/// The file of a mesh; [`super::read()`] gives back the same mesh, bit for bit.
///
/// Node tags are the indices plus 1. Each rod piece and spar is a curve; rod pieces on the leading edge belong
/// to the set `leading-edge` too. Edges without elements (a wing without film) are written as points.
pub fn write(mesh: &Mesh) -> String {
    let entities = entities(mesh);
    let mut text = String::from("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    write_sections(&mut text, mesh, &entities).expect("writing to a string cannot fail");
    text
}

/// A point, curve or surface of the file.
struct Entity {
    dimension: usize,
    sets: Vec<SetName>,
    elements: Vec<Vec<usize>>,
}

fn entities(mesh: &Mesh) -> Vec<Entity> {
    let leading: Vec<[usize; 2]> = mesh.leading_edge.windows(2).map(|w| [w[0], w[1]]).collect();
    let mut parts: Vec<BeamPart> = mesh.beams.iter().map(|beam| beam.part).collect();
    parts.sort_unstable();
    parts.dedup();
    let mut entities = Vec::new();
    let mut covered = vec![false; leading.len()];
    for part in parts {
        let edges: Vec<[usize; 2]> = mesh
            .beams
            .iter()
            .filter(|b| b.part == part)
            .map(|b| b.nodes)
            .collect();
        let mut sets = vec![SetName::Beam(part)];
        let places: Vec<_> = edges
            .iter()
            .filter_map(|edge| leading.iter().position(|e| e == edge))
            .collect();
        if places.len() == edges.len() {
            sets.push(SetName::LeadingEdge);
            places.into_iter().for_each(|place| covered[place] = true);
        }
        entities.push(Entity {
            dimension: 1,
            sets,
            elements: edges.into_iter().map(Vec::from).collect(),
        });
    }
    let bare: Vec<[usize; 2]> = leading
        .iter()
        .zip(&covered)
        .filter(|&(_, is)| !is)
        .map(|(&e, _)| e)
        .collect();
    if !bare.is_empty() || covered.is_empty() {
        entities.extend(edge_set(mesh, SetName::LeadingEdge, &bare, &mesh.leading_edge));
    }
    for (name, nodes) in [
        (SetName::TrailingEdge, &mesh.trailing_edge),
        (SetName::Root, &mesh.root),
    ] {
        let edges: Vec<[usize; 2]> = nodes.windows(2).map(|w| [w[0], w[1]]).collect();
        entities.extend(edge_set(mesh, name, &edges, nodes));
    }
    if !mesh.triangles.is_empty() {
        let elements = mesh.triangles.iter().map(|t| t.to_vec()).collect();
        entities.push(Entity {
            dimension: 2,
            sets: vec![SetName::Membrane],
            elements,
        });
    }
    entities
}

/// Lines along a film's edge, or points where there is no film or no line.
fn edge_set(mesh: &Mesh, name: SetName, edges: &[[usize; 2]], nodes: &[usize]) -> Vec<Entity> {
    if !mesh.triangles.is_empty() && !edges.is_empty() {
        let elements = edges.iter().map(|e| e.to_vec()).collect();
        return vec![Entity {
            dimension: 1,
            sets: vec![name],
            elements,
        }];
    }
    nodes
        .iter()
        .map(|&node| Entity {
            dimension: 0,
            sets: vec![name],
            elements: vec![vec![node]],
        })
        .collect()
}

fn write_sections(text: &mut String, mesh: &Mesh, entities: &[Entity]) -> std::fmt::Result {
    let names = PhysicalNames::of(entities);
    writeln!(text, "$PhysicalNames\n{}", names.0.len())?;
    for &(dimension, set) in &names.0 {
        writeln!(text, "{dimension} {} \"{set}\"", names.tag(dimension, set))?;
    }
    writeln!(text, "$EndPhysicalNames")?;

    // Tags of entities count per dimension, from 1.
    let mut counts = [0; 3];
    let tags: Vec<usize> = (entities.iter())
        .map(|entity| {
            counts[entity.dimension] += 1;
            counts[entity.dimension]
        })
        .collect();
    writeln!(text, "$Entities\n{} {} {} 0", counts[0], counts[1], counts[2])?;
    for dimension in 0..3 {
        for (entity, tag) in entities.iter().zip(&tags) {
            if entity.dimension == dimension {
                write_entity(text, mesh, (entity, *tag), &names)?;
            }
        }
    }
    writeln!(text, "$EndEntities")?;
    write_nodes(text, mesh, entities, &tags)?;
    write_elements(text, entities, &tags)
}

/// The names of sets by dimension, their tags counting from 1.
struct PhysicalNames(Vec<(usize, SetName)>);

impl PhysicalNames {
    fn of(entities: &[Entity]) -> PhysicalNames {
        let mut names: Vec<(usize, SetName)> = entities
            .iter()
            .flat_map(|e| e.sets.iter().map(|&set| (e.dimension, set)))
            .collect();
        names.sort_unstable();
        names.dedup();
        PhysicalNames(names)
    }

    fn tag(&self, dimension: usize, set: SetName) -> usize {
        self.0
            .iter()
            .position(|&name| name == (dimension, set))
            .map_or(0, |place| place + 1)
    }
}

fn write_entity(
    text: &mut String,
    mesh: &Mesh,
    (entity, tag): (&Entity, usize),
    names: &PhysicalNames,
) -> std::fmt::Result {
    let dimension = entity.dimension;
    let [low, high] = bounds(mesh, entity);
    write!(text, "{tag} {} {} {} ", low[0], low[1], low[2])?;
    if dimension > 0 {
        write!(text, "{} {} {} ", high[0], high[1], high[2])?;
    }
    write!(text, "{}", entity.sets.len())?;
    for &set in &entity.sets {
        write!(text, " {}", names.tag(dimension, set))?;
    }
    // No entity bounds another: the mesh needs no geometry.
    writeln!(text, "{}", if dimension > 0 { " 0" } else { "" })
}

fn write_elements(text: &mut String, entities: &[Entity], tags: &[usize]) -> std::fmt::Result {
    let count: usize = entities.iter().map(|entity| entity.elements.len()).sum();
    writeln!(
        text,
        "$Elements\n{} {count} {} {count}",
        entities.len(),
        count.min(1)
    )?;
    let mut element = 0;
    for (entity, tag) in entities.iter().zip(tags) {
        let kind = [15, 1, 2][entity.dimension];
        writeln!(
            text,
            "{} {tag} {kind} {}",
            entity.dimension,
            entity.elements.len()
        )?;
        for nodes in &entity.elements {
            element += 1;
            write!(text, "{element}")?;
            for node in nodes {
                write!(text, " {}", node + 1)?;
            }
            writeln!(text)?;
        }
    }
    writeln!(text, "$EndElements")
}

/// Each node stands with the first entity that has it.
fn write_nodes(text: &mut String, mesh: &Mesh, entities: &[Entity], tags: &[usize]) -> std::fmt::Result {
    let mut is_written = vec![false; mesh.nodes.len()];
    let mut blocks = Vec::new();
    for (entity, &tag) in entities.iter().zip(tags) {
        let mut own = Vec::new();
        for &node in entity.elements.iter().flatten() {
            if !std::mem::replace(&mut is_written[node], true) {
                own.push(node);
            }
        }
        own.sort_unstable();
        blocks.push((entity.dimension, tag, own));
    }
    blocks.retain(|(_, _, own)| !own.is_empty());
    let count: usize = blocks.iter().map(|(_, _, own)| own.len()).sum();
    writeln!(
        text,
        "$Nodes\n{} {count} {} {}",
        blocks.len(),
        count.min(1),
        mesh.nodes.len()
    )?;
    for (dimension, tag, own) in blocks {
        writeln!(text, "{dimension} {tag} 0 {}", own.len())?;
        for node in &own {
            writeln!(text, "{}", node + 1)?;
        }
        for &node in &own {
            let [x, y, z] = mesh.nodes[node];
            writeln!(text, "{x} {y} {z}")?;
        }
    }
    writeln!(text, "$EndNodes")
}

fn bounds(mesh: &Mesh, entity: &Entity) -> [[f64; 3]; 2] {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for &node in entity.elements.iter().flatten() {
        for (k, value) in mesh.nodes[node].into_iter().enumerate() {
            bounds[0][k] = bounds[0][k].min(value);
            bounds[1][k] = bounds[1][k].max(value);
        }
    }
    bounds
}
