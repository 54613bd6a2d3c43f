//! The sections of a Gmsh file as they stand in it.

use super::error::{FileDefect, GmshError};
use super::lines::{Lines, shorten};
use super::raw::{RawElement, RawNode, Sections, coordinates, shape_of};
use super::version_2;

const SECTIONS: [&str; 4] = ["$PhysicalNames", "$Entities", "$Nodes", "$Elements"];

/// Splits a file into its sections; others than the four are skipped.
pub fn sections(lines: &mut Lines) -> Result<Sections, GmshError> {
    let version = header(lines)?;
    let mut sections = Sections::default();
    let mut seen = [false; 4];
    while let Some(line) = lines.next_line() {
        if !line.text.starts_with('$') {
            return Err(lines.record(line, "a section such as $Nodes"));
        }
        let Some(place) = SECTIONS.iter().position(|&name| name == line.text) else {
            skip(lines, line.text)?;
            continue;
        };
        let section = SECTIONS[place];
        if std::mem::replace(&mut seen[place], true) {
            return Err(lines.error(
                Some(line.number),
                FileDefect::SectionTwice {
                    section: section.to_string(),
                },
            ));
        }
        match (place, version) {
            (0, _) => names(lines, &mut sections)?,
            (1, Version::Four) => entities(lines, &mut sections)?,
            (2, Version::Four) => nodes(lines, &mut sections)?,
            (_, Version::Four) => elements(lines, &mut sections)?,
            (1, Version::Two) => {
                skip(lines, section)?;
                continue;
            }
            (2, Version::Two) => version_2::nodes(lines, &mut sections)?,
            (_, Version::Two) => version_2::elements(lines, &mut sections)?,
        }
        lines.close(section)?;
    }
    let is_missing =
        |place: usize| !seen[place] && (version == Version::Four || version_2::needs(SECTIONS[place]));
    match (0..SECTIONS.len()).find(|&place| is_missing(place)) {
        Some(place) => Err(lines.error(
            None,
            FileDefect::MissingSection {
                section: SECTIONS[place].to_string(),
            },
        )),
        None => Ok(sections),
    }
}

/// Formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Version {
    /// MSH 2.2.
    Two,
    /// MSH 4.1.
    Four,
}

fn header(lines: &mut Lines) -> Result<Version, GmshError> {
    let section = "$MeshFormat";
    let line = lines.line_of(section)?;
    if line.text != section {
        return Err(lines.error(
            Some(line.number),
            FileDefect::NotGmsh {
                start: shorten(line.text),
            },
        ));
    }
    let line = lines.line_of(section)?;
    let words: Vec<&str> = line.text.split_whitespace().collect();
    match words[..] {
        ["4.1", "0", _] => lines.close(section).map(|()| Version::Four),
        ["2.2", "0", _] => lines.close(section).map(|()| Version::Two),
        ["4.1" | "2.2", "1", _] => Err(lines.error(Some(line.number), FileDefect::Binary)),
        [version, _, _] => Err(lines.error(
            Some(line.number),
            FileDefect::Version {
                version: shorten(version),
            },
        )),
        _ => Err(lines.record(line, "version, file type and data size, such as `4.1 0 8`")),
    }
}

fn skip(lines: &mut Lines, section: &str) -> Result<(), GmshError> {
    let closing = format!("$End{}", section.trim_start_matches('$'));
    while lines.line_of(&shorten(section))?.text != closing {}
    Ok(())
}

fn names(lines: &mut Lines, sections: &mut Sections) -> Result<(), GmshError> {
    const EXPECTED: &str = "dimension, tag and \"name\" of a physical group";
    let (_, count) = lines.numbers::<u64>(SECTIONS[0], 1, "the number of physical names")?;
    for _ in 0..count[0] {
        let line = lines.line_of(SECTIONS[0])?;
        let parsed = line.text.split_once('"').and_then(|(numbers, rest)| {
            let mut numbers = numbers.split_whitespace();
            let key = (numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?);
            Some((key, rest.strip_suffix('"')?))
        });
        let Some((key, name)) = parsed else {
            return Err(lines.record(line, EXPECTED));
        };
        sections.names.insert(key, (name.to_string(), line.number));
    }
    Ok(())
}

fn entities(lines: &mut Lines, sections: &mut Sections) -> Result<(), GmshError> {
    const EXPECTED: &str = "tag, place or bounds, and physical tags of an entity";
    let (_, counts) = lines.numbers::<u64>(
        SECTIONS[1],
        4,
        "the numbers of points, curves, surfaces and volumes",
    )?;
    for (dimension, &count) in counts.iter().take(4).enumerate() {
        // The physical tags follow the tag and the place of a point, or the two corners of a box.
        let before = if dimension == 0 { 4 } else { 7 };
        for _ in 0..count {
            let line = lines.line_of(SECTIONS[1])?;
            let words: Vec<&str> = line.text.split_whitespace().collect();
            let number = |place: usize| words.get(place).and_then(|word| word.parse::<i64>().ok());
            let parsed = number(0).zip(number(before)).and_then(|(tag, count)| {
                let end = before.checked_add(1)?.checked_add(usize::try_from(count).ok()?)?;
                // A group of the opposite orientation has a negative tag.
                let tags: Option<Vec<i64>> = words
                    .get(before + 1..end)?
                    .iter()
                    .map(|word| word.parse::<i64>().ok()?.checked_abs())
                    .collect();
                Some((tag, tags?))
            });
            let Some((tag, tags)) = parsed else {
                return Err(lines.record(line, EXPECTED));
            };
            sections.entities.insert((dimension, tag), (tags, line.number));
        }
    }
    Ok(())
}

fn nodes(lines: &mut Lines, sections: &mut Sections) -> Result<(), GmshError> {
    let section = SECTIONS[2];
    let (_, counts) = lines.numbers::<u64>(
        section,
        4,
        "numbers of node blocks and nodes, smallest and largest tag",
    )?;
    for _ in 0..counts[0] {
        let (_, block) = lines.numbers::<i64>(
            section,
            4,
            "dimension, entity, parametric (0 or 1) and number of nodes of a block",
        )?;
        let mut tags = Vec::new();
        for _ in 0..block[3] {
            tags.push(lines.numbers::<u64>(section, 1, "a node tag")?.1[0]);
        }
        for tag in tags {
            let line = lines.line_of(section)?;
            let position = coordinates(lines, line, line.text, "the coordinates x y z of a node")?;
            sections.nodes.push(RawNode {
                tag,
                position,
                line: line.number,
            });
        }
    }
    Ok(())
}

fn elements(lines: &mut Lines, sections: &mut Sections) -> Result<(), GmshError> {
    let section = SECTIONS[3];
    let (_, counts) = lines.numbers::<u64>(
        section,
        4,
        "numbers of element blocks and elements, smallest and largest tag",
    )?;
    for _ in 0..counts[0] {
        let (number, block) = lines.numbers::<i64>(
            section,
            4,
            "dimension, entity, element type and number of elements of a block",
        )?;
        let (dimension, count) = shape_of(lines, number, block[2])?;
        for _ in 0..block[3] {
            let (line, numbers) = lines.numbers::<u64>(section, 1 + count, "tag and nodes of an element")?;
            let mut nodes = [0; 3];
            nodes[..count].copy_from_slice(&numbers[1..=count]);
            let entity = (dimension, block[1]);
            sections.elements.push(RawElement {
                tag: numbers[0],
                entity,
                nodes,
                count,
                line,
            });
        }
    }
    Ok(())
}
