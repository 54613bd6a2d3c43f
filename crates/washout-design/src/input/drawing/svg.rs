//! Closed lines of an SVG, with its units, transforms and shapes resolved by usvg.

use resvg::usvg::tiny_skia_path::{PathSegment, Point};
use resvg::usvg::{Group, Node, Options, Path, Tree};

use super::chain::{Lines, closed};
use super::curve::bezier;
use crate::input::error::InputError;

/// Millimetres of a pixel: 96 of them are an inch (CSS).
const PIXEL_MM: f64 = 25.4 / 96.0;

/// The lines of an SVG, with the open ones joined where their ends meet.
pub(super) fn lines_mm(file: &str, text: &str) -> Result<Lines, InputError> {
    let tree = Tree::from_str(text, &Options::default()).map_err(|error| {
        let cure = "Save the drawing as plain SVG";
        InputError::about_file(file, format!("is no SVG that can be read: {error}"), cure)
    })?;
    let mut found = Found::default();
    found.walk(tree.root());
    let (joined, stay_open) = closed(found.open);
    found.closed.extend(joined);
    let has_unit = ["mm\"", "cm\"", "in\"", "mm'", "cm'", "in'"];
    let head = text.split_once("<svg").map_or("", |(_, rest)| rest);
    let head = head.split_once('>').map_or("", |(head, _)| head);
    let unit = match has_unit.iter().any(|unit| head.contains(unit)) {
        true => "as its width and height state",
        false => "pixels of 1/96 inch, for the file states no other unit",
    };
    Ok(Lines {
        closed: found.closed,
        unit: unit.to_string(),
        left_out: vec![
            ("line that stays open".to_string(), stay_open),
            ("picture".to_string(), found.pictures),
            ("text".to_string(), found.texts),
        ],
    })
}

/// What stands in the groups of an SVG.
#[derive(Default)]
struct Found {
    closed: Vec<Vec<[f64; 2]>>,
    open: Vec<Vec<[f64; 2]>>,
    pictures: usize,
    texts: usize,
}

impl Found {
    fn walk(&mut self, group: &Group) {
        for node in group.children() {
            match node {
                Node::Group(group) => self.walk(group),
                Node::Path(path) => self.add(path),
                Node::Image(_) => self.pictures += 1,
                Node::Text(_) => self.texts += 1,
            }
        }
    }

    fn add(&mut self, path: &Path) {
        let Some(data) = path.data().clone().transform(path.abs_transform()) else {
            return;
        };
        let mut line: Vec<[f64; 2]> = Vec::new();
        let at = |point: Point| [f64::from(point.x) * PIXEL_MM, -f64::from(point.y) * PIXEL_MM];
        for segment in data.segments() {
            let last = line.last().copied().unwrap_or_default();
            match segment {
                PathSegment::MoveTo(to) => self.open.push(std::mem::replace(&mut line, vec![at(to)])),
                PathSegment::LineTo(to) => line.push(at(to)),
                PathSegment::QuadTo(a, to) => line.extend(bezier(&[last, at(a), at(to)])),
                PathSegment::CubicTo(a, b, to) => line.extend(bezier(&[last, at(a), at(b), at(to)])),
                PathSegment::Close => self.closed.push(std::mem::take(&mut line)),
            }
        }
        self.open.push(line);
    }
}
