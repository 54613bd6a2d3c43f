//! A mesh from a Gmsh file, MSH 4.1 or 2.2 in text, whoever wrote it.

use std::collections::BTreeMap;

use super::chains::chain;
use super::error::{FileDefect, GmshError};
use super::lines::Lines;
use super::raw::{RawElement, Sections};
use super::sections::sections;
use crate::mesh::check::check;
use crate::mesh::defect::Member;
use crate::mesh::names::SetName;
use crate::mesh::{BeamElement, BeamPart, Mesh, signed_area_m2};

/// Largest file that is read, in bytes.
const LARGEST: usize = 512 << 20;

/// Reads and checks the mesh in `bytes`; `file` is the name that errors show.
///
/// Coordinates in metres, wing frame. Nodes and triangles are ordered by their tags, beam elements by rod piece
/// and spar and end to end, sets outward; clockwise triangles are turned. Points and lines without a physical
/// group are passed over. Errors name file and line: see [`FileDefect`] and [`crate::mesh::Defect`].
pub fn read(bytes: &[u8], file: &str) -> Result<Mesh, GmshError> {
    let error = |defect| GmshError {
        file: file.to_string(),
        line: None,
        defect,
    };
    if bytes.len() > LARGEST {
        let (megabytes, largest_megabytes) = (bytes.len() >> 20, LARGEST >> 20);
        return Err(error(FileDefect::Huge {
            megabytes,
            largest_megabytes,
        }));
    }
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(error(FileDefect::Empty));
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) if !text.contains('\0') => text,
        _ => return Err(error(FileDefect::Binary)),
    };
    let mut lines = Lines::new(text, file);
    let sections = sections(&mut lines)?;
    let file = File {
        lines: &lines,
        sections: &sections,
        sets: entity_sets(&lines, &sections)?,
    };
    let (mesh, places) = file.assemble()?;
    check(&mesh).map_err(|defect| {
        let line = match defect.member() {
            Member::Node(index) => places.nodes.get(index).copied(),
            Member::Triangle(index) => places.triangles.get(index).copied(),
            Member::Beam(index) => places.beams.get(index).copied(),
            Member::Set(_) => None,
        };
        lines.error(line, FileDefect::Mesh(defect))
    })?;
    Ok(mesh)
}

/// The named sets of every entity.
fn entity_sets(
    lines: &Lines,
    sections: &Sections,
) -> Result<BTreeMap<(usize, i64), Vec<SetName>>, GmshError> {
    let mut names = BTreeMap::new();
    for (&(dimension, tag), (name, line)) in &sections.names {
        let set = SetName::parse(name).ok_or_else(|| {
            lines.error(
                Some(*line),
                FileDefect::UnknownSet {
                    name: super::lines::shorten(name),
                },
            )
        })?;
        let needed = match set {
            SetName::Membrane if dimension != 2 => "it must hold surfaces (2)",
            SetName::Beam(_) if dimension != 1 => "it must hold curves (1)",
            SetName::Root | SetName::LeadingEdge | SetName::TrailingEdge if dimension > 1 => {
                "it must hold curves (1) or points (0)"
            }
            _ => {
                names.insert((dimension, tag), set);
                continue;
            }
        };
        return Err(lines.error(
            Some(*line),
            FileDefect::SetDimension {
                name: set.to_string(),
                dimension,
                needed,
            },
        ));
    }
    let mut sets = BTreeMap::new();
    for (&(dimension, entity), (tags, line)) in &sections.entities {
        let mut own = Vec::new();
        for &tag in tags {
            own.push(
                *names
                    .get(&(dimension, tag))
                    .ok_or_else(|| lines.error(Some(*line), FileDefect::NamelessSet { tag, dimension }))?,
            );
        }
        sets.insert((dimension, entity), own);
    }
    Ok(sets)
}

struct File<'a> {
    lines: &'a Lines<'a>,
    sections: &'a Sections,
    sets: BTreeMap<(usize, i64), Vec<SetName>>,
}

/// Lines of the file in which the members of the mesh stand.
#[derive(Default)]
struct Places {
    nodes: Vec<usize>,
    triangles: Vec<usize>,
    beams: Vec<usize>,
}

impl File<'_> {
    fn assemble(&self) -> Result<(Mesh, Places), GmshError> {
        let (mut mesh, mut places) = (Mesh::default(), Places::default());
        let index_of = self.nodes(&mut mesh, &mut places)?;
        let mut elements: Vec<&RawElement> = self.sections.elements.iter().collect();
        elements.sort_by_key(|element| element.tag);
        let mut beams: BTreeMap<BeamPart, Vec<([usize; 2], usize)>> = BTreeMap::new();
        for element in elements {
            let nodes = self.nodes_of(element, &index_of)?;
            let sets = self.sets.get(&element.entity).map_or(&[][..], Vec::as_slice);
            if element.count == 3 {
                if sets.is_empty() {
                    // without a group, MSH 2.2 names the entity by a negative tag
                    let entity = element.entity.1.abs();
                    return Err(self
                        .lines
                        .error(Some(element.line), FileDefect::SurfaceWithoutSet { entity }));
                }
                let [a, b, c] = nodes;
                let is_clockwise = signed_area_m2(nodes.map(|node| mesh.nodes[node])) < 0.0;
                mesh.triangles.push(if is_clockwise { [a, c, b] } else { nodes });
                places.triangles.push(element.line);
                continue;
            }
            for set in sets {
                match set {
                    SetName::Root => mesh.root.extend(&nodes[..element.count]),
                    SetName::LeadingEdge => mesh.leading_edge.extend(&nodes[..element.count]),
                    SetName::TrailingEdge => mesh.trailing_edge.extend(&nodes[..element.count]),
                    SetName::Beam(part) => {
                        beams
                            .entry(*part)
                            .or_default()
                            .push(([nodes[0], nodes[1]], element.line));
                    }
                    SetName::Membrane => {}
                }
            }
        }
        self.refuse_missing_parts(&beams)?;
        for (part, edges) in beams {
            self.add_beams(part, &edges, &mut mesh, &mut places)?;
        }
        let points = &mesh.nodes;
        for (set, axis) in [
            (&mut mesh.root, 1),
            (&mut mesh.leading_edge, 0),
            (&mut mesh.trailing_edge, 0),
        ] {
            set.sort_by(|&a, &b| points[a][axis].total_cmp(&points[b][axis]).then(a.cmp(&b)));
            set.dedup();
        }
        Ok((mesh, places))
    }

    /// Indices of the nodes of an element, of which it has three at most.
    fn nodes_of(
        &self,
        element: &RawElement,
        index_of: &BTreeMap<u64, usize>,
    ) -> Result<[usize; 3], GmshError> {
        let mut nodes = [0; 3];
        for (node, &tag) in nodes.iter_mut().zip(&element.nodes[..element.count]) {
            *node = *index_of.get(&tag).ok_or_else(|| {
                self.lines.error(
                    Some(element.line),
                    FileDefect::UnknownNode {
                        element: element.tag,
                        tag,
                    },
                )
            })?;
        }
        Ok(nodes)
    }

    /// Nodes in the order of their tags; the index of each tag.
    fn nodes(&self, mesh: &mut Mesh, places: &mut Places) -> Result<BTreeMap<u64, usize>, GmshError> {
        let mut nodes: Vec<_> = self.sections.nodes.iter().collect();
        nodes.sort_by_key(|node| node.tag);
        if let Some(w) = nodes.windows(2).find(|w| w[0].tag == w[1].tag) {
            let line = w[0].line.max(w[1].line);
            return Err(self
                .lines
                .error(Some(line), FileDefect::NodeTwice { tag: w[0].tag }));
        }
        mesh.nodes = nodes.iter().map(|node| node.position).collect();
        places.nodes = nodes.iter().map(|node| node.line).collect();
        Ok(nodes
            .iter()
            .enumerate()
            .map(|(index, node)| (node.tag, index))
            .collect())
    }

    /// Rod pieces and spars count from 0 without a gap, and every name has elements.
    fn refuse_missing_parts(
        &self,
        beams: &BTreeMap<BeamPart, Vec<([usize; 2], usize)>>,
    ) -> Result<(), GmshError> {
        let missing = |line: Option<usize>, part: BeamPart| {
            Err(self.lines.error(
                line,
                FileDefect::MissingSet {
                    set: part.to_string(),
                },
            ))
        };
        for (name, line) in self.sections.names.values() {
            if let Some(SetName::Beam(part)) = SetName::parse(name)
                && !beams.contains_key(&part)
            {
                return missing(Some(*line), part);
            }
        }
        for part in beams.keys() {
            let before = match *part {
                BeamPart::Rod(index) => index.checked_sub(1).map(BeamPart::Rod),
                BeamPart::Spar(index) => index.checked_sub(1).map(BeamPart::Spar),
                BeamPart::Rib(index) => index.checked_sub(1).map(BeamPart::Rib),
            };
            if let Some(before) = before.filter(|before| !beams.contains_key(before)) {
                return missing(None, before);
            }
        }
        Ok(())
    }

    fn add_beams(
        &self,
        part: BeamPart,
        edges: &[([usize; 2], usize)],
        mesh: &mut Mesh,
        places: &mut Places,
    ) -> Result<(), GmshError> {
        // A rod runs outward, a spar away from the leading edge.
        let axis = if matches!(part, BeamPart::Rod(_)) { 0 } else { 1 };
        let nodes: Vec<[usize; 2]> = edges.iter().map(|&(nodes, _)| nodes).collect();
        let ordered = chain(&nodes, |a, b| {
            mesh.nodes[a][axis]
                .total_cmp(&mesh.nodes[b][axis])
                .then(a.cmp(&b))
        });
        let ordered = ordered.map_err(|problem| {
            let line = edges.first().map(|&(_, line)| line);
            self.lines.error(
                line,
                FileDefect::NotAChain {
                    set: part.to_string(),
                    problem,
                },
            )
        })?;
        for (place, nodes) in ordered {
            mesh.beams.push(BeamElement { nodes, part });
            places.beams.push(edges[place].1);
        }
        Ok(())
    }
}
