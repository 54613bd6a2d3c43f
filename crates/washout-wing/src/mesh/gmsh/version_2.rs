//! Nodes and elements of a Gmsh file of MSH 2.2, which has no entities: every element names its physical group.
//!
//! An element of several groups stands there once for each. Format: Gmsh reference manual, "MSH file format version 2 (Legacy)".

use super::error::GmshError;
use super::lines::Lines;
use super::raw::{RawElement, RawNode, Sections, coordinates, shape_of};

/// Reads `$Nodes`: a count, then tag and place of each.
pub fn nodes(lines: &mut Lines, sections: &mut Sections) -> Result<(), GmshError> {
    const SECTION: &str = "$Nodes";
    const EXPECTED: &str = "tag and coordinates x y z of a node";
    let (_, count) = lines.numbers::<u64>(SECTION, 1, "the number of nodes")?;
    for _ in 0..count[0] {
        let line = lines.line_of(SECTION)?;
        let (tag, place) = line.text.split_once(char::is_whitespace).unwrap_or_default();
        let Ok(tag) = tag.parse() else {
            return Err(lines.record(line, EXPECTED));
        };
        sections.nodes.push(RawNode {
            tag,
            position: coordinates(lines, line, place, EXPECTED)?,
            line: line.number,
        });
    }
    Ok(())
}

/// Reads `$Elements`: a count, then tag, type, tags (physical group, entity, ...) and nodes of each. What belongs to one group
/// becomes an entity of the file; what belongs to none an entity by its own tag, negative.
pub fn elements(lines: &mut Lines, sections: &mut Sections) -> Result<(), GmshError> {
    const SECTION: &str = "$Elements";
    const EXPECTED: &str =
        "tag, type, number of tags, tags (physical group and entity first) and nodes of an element";
    let (_, count) = lines.numbers::<u64>(SECTION, 1, "the number of elements")?;
    for _ in 0..count[0] {
        let line = lines.line_of(SECTION)?;
        let numbers: Option<Vec<i64>> = line
            .text
            .split_whitespace()
            .map(|word| word.parse().ok())
            .collect();
        let Some([tag, kind, tags, rest @ ..]) = numbers.as_deref() else {
            return Err(lines.record(line, EXPECTED));
        };
        let (dimension, count) = shape_of(lines, line.number, *kind)?;
        let parts = usize::try_from(*tags)
            .ok()
            .and_then(|tags| rest.split_at_checked(tags));
        let Some(([physical, elementary, ..], nodes)) = parts.filter(|(_, nodes)| nodes.len() == count)
        else {
            return Err(lines.record(line, EXPECTED));
        };
        let node_tags: Option<Vec<u64>> = nodes.iter().map(|node| u64::try_from(*node).ok()).collect();
        let (Some(node_tags), Ok(tag), Some(physical)) =
            (node_tags, u64::try_from(*tag), physical.checked_abs())
        else {
            return Err(lines.record(line, EXPECTED));
        };
        let entity = match physical {
            0 => (dimension, elementary.saturating_abs().saturating_neg()),
            group => {
                let known = sections.entities.entry((dimension, group));
                known.or_insert_with(|| (vec![group], line.number));
                (dimension, group)
            }
        };
        let mut nodes = [0; 3];
        nodes[..count].copy_from_slice(&node_tags);
        sections.elements.push(RawElement {
            tag,
            entity,
            nodes,
            count,
            line: line.number,
        });
    }
    Ok(())
}

/// Whether a section must stand in a file of this version.
pub fn needs(section: &str) -> bool {
    section != "$Entities"
}
