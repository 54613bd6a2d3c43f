//! Closed lines of an ASCII DXF (R12 and later): polylines with their arcs, lines, arcs and splines whose ends meet.
//!
//! The crate `dxf` 0.6.2 reads all of the format, but brings 34 crates (images, calendars, big numbers) for these few pairs of lines.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

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

/// Groups whose value is a number (DXF Reference, Group Codes: 10 to 59 are double-precision values, 60 to 79 integers).
const NUMBERS: RangeInclusive<i64> = 10..=79;

/// A pair of lines: what the value is, and the value.
type Pair<'a> = (i64, &'a str);

/// The lines of a DXF, with the open ones joined where their ends meet.
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
    let mut left_out = BTreeMap::new();
    let mut entities = entities(&pairs).into_iter().peekable();
    while let Some((name, fields)) = entities.next() {
        let mut points = vertices(&fields);
        if name == "POLYLINE" {
            points.clear();
            while let Some((_, vertex)) = entities.next_if(|(name, _)| *name == "VERTEX") {
                points.extend(vertices(&vertex));
            }
            entities.next_if(|(name, _)| *name == "SEQEND");
        }
        match line(name, &fields, &points) {
            Some(Line::Closed(points)) => whole.push(points),
            Some(Line::Open(points)) => open.push(points),
            None => *left_out.entry(name.to_string()).or_insert(0) += 1,
        }
    }
    let (joined, stay_open) = closed(open);
    whole.extend(joined);
    left_out.insert("line that stays open".to_string(), stay_open);
    let scaled = |line: Vec<[f64; 2]>| line.into_iter().map(|point| point.map(|v| v * factor)).collect();
    Ok(Lines {
        closed: whole.into_iter().map(scaled).collect(),
        unit,
        left_out: left_out.into_iter().collect(),
    })
}

enum Line {
    Closed(Vec<[f64; 2]>),
    Open(Vec<[f64; 2]>),
}

/// What an entity draws; none where it is of a kind that is not read, or lacks a number.
fn line(name: &str, fields: &[Pair], points: &[([f64; 2], f64)]) -> Option<Line> {
    let round = |from: f64, turn: f64| {
        let (centre, radius) = (point(fields, [10, 20])?, number(fields, 40)?);
        let start = [centre[0] + radius * from.cos(), centre[1] + radius * from.sin()];
        Some((start, arc(centre, radius, from, turn)))
    };
    Some(match name {
        "LWPOLYLINE" | "POLYLINE" => polyline(points, is_closed(fields)),
        "LINE" => Line::Open(vec![point(fields, [10, 20])?, point(fields, [11, 21])?]),
        "ARC" => {
            let [from, to] = point(fields, [50, 51])?.map(f64::to_radians);
            let (start, rest) = round(from, (to - from).rem_euclid(2.0 * PI))?;
            Line::Open([vec![start], rest].concat())
        }
        "CIRCLE" => Line::Closed(round(0.0, 2.0 * PI)?.1),
        "SPLINE" => Line::Open(of_spline(fields, points)?),
        _ => return None,
    })
}

/// All pairs of the file; those whose value is a number by the format are checked to hold one.
fn pairs<'a>(file: &str, text: &'a str) -> Result<Vec<Pair<'a>>, InputError> {
    let refuse = |index: usize, found: &str, message: &str, cure: &'static str| {
        let place = Place {
            line: Some(index + 1),
            ..Place::file(file)
        };
        let problem = Problem::Conflict {
            message: message.to_string(),
            with: Vec::new(),
        };
        InputError::new(place, "", found, problem, cure)
    };
    let mut lines = text.trim_end().lines().enumerate();
    let mut pairs = Vec::new();
    while let Some((index, code)) = lines.next() {
        let (code, cure) = (
            code.trim(),
            "Save the drawing as ASCII DXF (R12 or later), not as binary",
        );
        let group = code.parse();
        let group = group.map_err(|_| refuse(index, code, "should be the number of a DXF group", cure))?;
        let Some((index, value)) = lines.next() else {
            let cure = "Save the drawing again, for the file is cut off";
            return Err(refuse(
                index,
                code,
                "has no value after it, and the file ends",
                cure,
            ));
        };
        let value = value.trim();
        let is_number = value.parse::<f64>().is_ok_and(f64::is_finite);
        if NUMBERS.contains(&group) && !is_number {
            let cure = "Save the drawing again from the program that made it";
            return Err(refuse(index, value, "should be a finite number", cure));
        }
        pairs.push((group, value));
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

fn point(fields: &[Pair], [x, y]: [i64; 2]) -> Option<[f64; 2]> {
    Some([number(fields, x)?, number(fields, y)?])
}

fn is_closed(fields: &[Pair]) -> bool {
    number(fields, 70).is_some_and(|flags| flags as i64 & 1 == 1)
}

/// Points with the bulge of the segment after each.
fn vertices(fields: &[Pair]) -> Vec<([f64; 2], f64)> {
    let mut found: Vec<([f64; 2], f64)> = Vec::new();
    for (code, value) in fields {
        let Ok(value) = value.parse() else { continue };
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

fn of_spline(fields: &[Pair], points: &[([f64; 2], f64)]) -> Option<Vec<[f64; 2]>> {
    let degree = number(fields, 71)? as usize;
    let weights = numbers(fields, 41);
    let control = points.iter().enumerate();
    let control = control.map(|(index, ([x, y], _))| [*x, *y, weights.get(index).copied().unwrap_or(1.0)]);
    spline(degree, &numbers(fields, 40), &control.collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: &str =
        "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n60\n20\n0\n10\n60\n20\n-20\n";

    #[test]
    fn what_is_not_read_is_counted_by_its_kind() {
        let rest = "0\nELLIPSE\n10\n1\n20\n1\n0\nINSERT\n2\nrib\n0\nINSERT\n2\nrib\n0\nLINE\n10\n0\n20\n0\n11\n9\n21\n9\n0\nCIRCLE\n10\n0\n20\n0\n";
        let lines = lines_mm("wing.dxf", &format!("{TRIANGLE}{rest}0\nENDSEC\n0\nEOF\n\n")).expect("lines");
        assert_eq!(lines.closed.len(), 1);
        let expected = [
            ("CIRCLE", 1),
            ("ELLIPSE", 1),
            ("INSERT", 2),
            ("line that stays open", 1),
        ];
        assert_eq!(
            lines.left_out,
            expected.map(|(kind, count)| (kind.to_string(), count))
        );
    }

    #[test]
    fn a_number_that_is_none_and_a_file_that_is_cut_off_are_refused_with_the_line() {
        let broken = TRIANGLE.replace("-20", "-2O");
        let error = lines_mm("wing.dxf", &broken).err().expect("refused");
        assert_eq!((error.place.line, error.value.as_str()), (Some(20), "-2O"));
        let cut = TRIANGLE.trim_end().strip_suffix("-20").expect("the last line");
        let error = lines_mm("wing.dxf", cut).err().expect("refused");
        assert!(error.to_string().contains("cut off"), "{error}");
    }
}
