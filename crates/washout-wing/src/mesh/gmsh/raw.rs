//! What a mesh file says, before it is a mesh.

use std::collections::BTreeMap;

use super::error::{FileDefect, GmshError};
use super::lines::{Line, Lines, shorten};

/// What the four sections hold that a wing needs.
#[derive(Debug, Default)]
pub struct Sections {
    /// $PhysicalNames: name and line by dimension and tag.
    pub names: BTreeMap<(usize, i64), (String, usize)>,
    /// $Entities: physical tags and line by dimension and tag.
    pub entities: BTreeMap<(usize, i64), (Vec<i64>, usize)>,
    /// $Nodes, in the file's order.
    pub nodes: Vec<RawNode>,
    /// $Elements, in the file's order.
    pub elements: Vec<RawElement>,
}

/// A node as it stands in the file.
#[derive(Debug, Clone, Copy)]
pub struct RawNode {
    /// Its tag.
    pub tag: u64,
    /// Its place.
    pub position: [f64; 3],
    /// The line with its coordinates.
    pub line: usize,
}

/// An element as it stands in the file.
#[derive(Debug, Clone, Copy)]
pub struct RawElement {
    /// Its tag.
    pub tag: u64,
    /// Dimension and tag of its entity.
    pub entity: (usize, i64),
    /// Tags of its nodes; the first `dimension + 1` count.
    pub nodes: [u64; 3],
    /// Number of its nodes.
    pub count: usize,
    /// Its line.
    pub line: usize,
}

/// The first three numbers of `words`, which stand in `line`.
pub fn coordinates(
    lines: &Lines,
    line: Line,
    words: &str,
    expected: &'static str,
) -> Result<[f64; 3], GmshError> {
    let words: Vec<&str> = words.split_whitespace().collect();
    let mut position = [0.0; 3];
    if words.len() < 3 {
        return Err(lines.record(line, expected));
    }
    for (value, word) in position.iter_mut().zip(&words) {
        *value = match word.parse::<f64>() {
            Ok(number) if number.is_finite() => number,
            Ok(_) => {
                let found = shorten(word);
                return Err(lines.error(Some(line.number), FileDefect::Coordinate { found }));
            }
            Err(_) => return Err(lines.record(line, expected)),
        };
    }
    Ok(position)
}

/// Dimension and number of nodes of an element type, which stands in line `number`.
pub fn shape_of(lines: &Lines, number: usize, kind: i64) -> Result<(usize, usize), GmshError> {
    let kind = u64::try_from(kind).unwrap_or(0);
    let shapes = [(15, (0, 1)), (1, (1, 2)), (2, (2, 3))];
    let found = shapes
        .into_iter()
        .find_map(|(known, shape)| (known == kind).then_some(shape));
    found.ok_or_else(|| {
        let name = type_name(kind);
        lines.error(Some(number), FileDefect::ElementType { kind, name })
    })
}

/// Names of the element types that Gmsh writes most.
fn type_name(kind: u64) -> &'static str {
    match kind {
        3 => "4-node quadrangle",
        4 => "4-node tetrahedron",
        5 => "8-node hexahedron",
        6 => "6-node prism",
        8 => "3-node line",
        9 => "6-node triangle",
        10 => "9-node quadrangle",
        11 => "10-node tetrahedron",
        16 => "8-node quadrangle",
        _ => "unknown",
    }
}
