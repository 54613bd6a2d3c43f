//! Closed lines of an ASCII DXF (R12 and later): polylines with their arcs, lines, arcs and splines whose ends meet.
//!
//! The crate `dxf` 0.6.2 reads all of the format, but brings 34 crates (images, calendars, big numbers) for these few pairs of lines.

use super::chain::{Lines, closed};
use super::curve::{arc, bulged, spline};
use crate::input::error::{InputError, Place, Problem};

/// Millimetres of a unit by the number of `$INSUNITS`, and its name.
const UNITS: [(i64, f64, &str); 5] = [
    (1, 25.4, "inches"),
    (2, 304.8, "feet"),
    (4, 1.0, "millimetres"),
    (5, 10.0, "centimetres"),
    (6, 1000.0, "metres"),
];

/// A pair of lines: what the value is, and the value.
type Pair<'a> = (i64, &'a str);

/// Closed lines, mm, and what a unit was taken for.
pub(super) fn lines_mm(file: &str, text: &str) -> Result<Lines, InputError> {
    let pairs = pairs(file, text)?;
    let stated = pairs
        .windows(2)
        .find(|pair| pair[0] == (9, "$INSUNITS"))
        .and_then(|pair| pair[1].1.parse().ok());
    let known = UNITS.iter().find(|(number, ..)| stated == Some(*number));
    let (factor, unit) = match known {
        Some((_, factor, name)) => (*factor, format!("{name}, as the file says")),
        None => (1.0, "millimetres, for the file states no unit".to_string()),
    };
    let (mut whole, mut open) = (Vec::new(), Vec::new());
    let mut entities = entities(&pairs).into_iter().peekable();
    while let Some((name, fields)) = entities.next() {
        let line = match name {
            "LWPOLYLINE" => polyline(&vertices(&fields), is_closed(&fields)),
            "POLYLINE" => {
                let mut points = Vec::new();
                while let Some((_, vertex)) = entities.next_if(|(name, _)| *name == "VERTEX") {
                    points.extend(vertices(&vertex));
                }
                polyline(&points, is_closed(&fields))
            }
            "LINE" => Line::Open(vec![point(&fields, [10, 20]), point(&fields, [11, 21])]),
            "ARC" => Line::Open(of_arc(&fields)),
            "CIRCLE" => {
                let turn = 2.0 * std::f64::consts::PI;
                Line::Closed(arc(
                    point(&fields, [10, 20]),
                    number(&fields, 40).unwrap_or(0.0),
                    0.0,
                    turn,
                ))
            }
            "SPLINE" => match of_spline(&fields) {
                Some(points) => Line::Open(points),
                None => continue,
            },
            _ => continue,
        };
        match line {
            Line::Closed(points) => whole.push(points),
            Line::Open(points) => open.push(points),
        }
    }
    whole.extend(closed(open));
    let scaled = |line: Vec<[f64; 2]>| line.into_iter().map(|point| point.map(|v| v * factor)).collect();
    Ok((whole.into_iter().map(scaled).collect(), unit))
}

enum Line {
    Closed(Vec<[f64; 2]>),
    Open(Vec<[f64; 2]>),
}

fn pairs<'a>(file: &str, text: &'a str) -> Result<Vec<Pair<'a>>, InputError> {
    let mut lines = text.lines().enumerate();
    let mut pairs = Vec::new();
    while let Some((index, code)) = lines.next() {
        let Some((_, value)) = lines.next() else { break };
        let Ok(code) = code.trim().parse() else {
            let place = Place {
                line: Some(index + 1),
                ..Place::file(file)
            };
            let problem = Problem::Conflict {
                message: "should be the number of a DXF group".to_string(),
                with: Vec::new(),
            };
            let cure = "Save the drawing as ASCII DXF (R12 or later), not as binary";
            return Err(InputError::new(place, "", code.trim(), problem, cure));
        };
        pairs.push((code, value.trim()));
    }
    Ok(pairs)
}

/// The entities of the drawing with their pairs.
fn entities<'a>(pairs: &[Pair<'a>]) -> Vec<(&'a str, Vec<Pair<'a>>)> {
    let mut found: Vec<(&str, Vec<Pair>)> = Vec::new();
    let mut is_inside = false;
    for &(code, value) in pairs {
        match (code, value) {
            (2, "ENTITIES") if !is_inside => is_inside = true,
            (0, "ENDSEC") => is_inside = false,
            (0, name) if is_inside => found.push((name, Vec::new())),
            pair if is_inside => found.last_mut().into_iter().for_each(|last| last.1.push(pair)),
            _ => {}
        }
    }
    found
}

fn number(fields: &[Pair], code: i64) -> Option<f64> {
    let found = fields.iter().find(|(own, _)| *own == code)?;
    found.1.parse().ok()
}

fn numbers(fields: &[Pair], code: i64) -> Vec<f64> {
    let found = fields.iter().filter(|(own, _)| *own == code);
    found.filter_map(|(_, value)| value.parse().ok()).collect()
}

fn point(fields: &[Pair], codes: [i64; 2]) -> [f64; 2] {
    codes.map(|code| number(fields, code).unwrap_or(0.0))
}

fn is_closed(fields: &[Pair]) -> bool {
    number(fields, 70).is_some_and(|flags| flags as i64 & 1 == 1)
}

/// Points with the bulge of the segment after each.
fn vertices(fields: &[Pair]) -> Vec<([f64; 2], f64)> {
    let mut found: Vec<([f64; 2], f64)> = Vec::new();
    for (code, value) in fields {
        let value: f64 = value.parse().unwrap_or(0.0);
        match (code, found.last_mut()) {
            (10, _) => found.push(([value, 0.0], 0.0)),
            (20, Some(last)) => last.0[1] = value,
            (42, Some(last)) => last.1 = value,
            _ => {}
        }
    }
    found
}

fn polyline(vertices: &[([f64; 2], f64)], is_closed: bool) -> Line {
    let mut points: Vec<[f64; 2]> = vertices.first().map(|(point, _)| *point).into_iter().collect();
    for pair in vertices.windows(2) {
        points.extend(bulged(pair[0].0, pair[1].0, pair[0].1));
    }
    if let (true, Some(first), Some((last, bulge))) = (is_closed, points.first().copied(), vertices.last()) {
        let mut end = bulged(*last, first, *bulge);
        end.pop();
        points.extend(end);
        return Line::Closed(points);
    }
    Line::Open(points)
}

fn of_arc(fields: &[Pair]) -> Vec<[f64; 2]> {
    let (centre, radius) = (point(fields, [10, 20]), number(fields, 40).unwrap_or(0.0));
    let [from, to] = point(fields, [50, 51]).map(f64::to_radians);
    let turn = (to - from).rem_euclid(2.0 * std::f64::consts::PI);
    let mut points = vec![[centre[0] + radius * from.cos(), centre[1] + radius * from.sin()]];
    points.extend(arc(centre, radius, from, turn));
    points
}

fn of_spline(fields: &[Pair]) -> Option<Vec<[f64; 2]>> {
    let degree = number(fields, 71)? as usize;
    let weights = numbers(fields, 41);
    let control = vertices(fields).into_iter().enumerate();
    let control = control.map(|(index, ([x, y], _))| [x, y, weights.get(index).copied().unwrap_or(1.0)]);
    spline(degree, &numbers(fields, 40), &control.collect::<Vec<_>>())
}
