//! Rows of a measurement file that no case of the study uses: a slip in the name of a condition, or left out on purpose.

use std::fmt;

use crate::input::measurement::Measurement;
use crate::input::nearest;

/// Names that are told of one kind.
const TOLD: usize = 6;

/// Rows of a file whose conditions are named alike, and which no case uses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnusedRows {
    /// The measurement file, as the user named it.
    pub file: String,
    /// Its lines.
    pub lines: Vec<usize>,
    /// The conditions, each once.
    pub conditions: Vec<String>,
    /// The form of a case that they may have been meant for.
    pub meant: Option<String>,
}

/// The rows of a file that are of none of the conditions `used`; `forms`: what the cases ask for, such as `bending-{mass}`.
pub(super) fn unused(file: &Measurement, used: &[&str], forms: &[&str]) -> Vec<UnusedRows> {
    let shapes: Vec<String> = forms.iter().map(|form| shape(form)).collect();
    let mut found: Vec<(String, UnusedRows)> = Vec::new();
    for row in file.rows.iter().filter(|row| !used.contains(&row.case.as_str())) {
        let own = shape(&row.case);
        let at = match found.iter().position(|(known, _)| *known == own) {
            Some(at) => at,
            None => {
                let rows = UnusedRows {
                    file: file.file.clone(),
                    lines: Vec::new(),
                    conditions: Vec::new(),
                    meant: meant(&own, &shapes).map(|at| forms[at].to_string()),
                };
                found.push((own, rows));
                found.len() - 1
            }
        };
        let rows = &mut found[at].1;
        rows.lines.push(row.line);
        if !rows.conditions.contains(&row.case) {
            rows.conditions.push(row.case.clone());
        }
    }
    found.into_iter().map(|(_, rows)| rows).collect()
}

/// Which of the shapes that cases ask for was meant; none where one differs in its numbers only, which is no slip.
fn meant(own: &str, shapes: &[String]) -> Option<usize> {
    if shapes.iter().any(|known| known == own) {
        return None;
    }
    let near = nearest(own, shapes.iter().map(String::as_str))?;
    shapes.iter().position(|known| known == near)
}

/// A name, or a form, with `#` for every number.
fn shape(name: &str) -> String {
    let mut shape = String::new();
    let mut is_inside = false;
    for letter in name.chars() {
        let is_number = letter.is_ascii_digit() || letter == '.' || is_inside || letter == '{';
        is_inside = letter == '{' || (is_inside && letter != '}');
        match is_number {
            true if shape.ends_with('#') => {}
            true => shape.push('#'),
            false => shape.push(letter),
        }
    }
    shape
}

impl fmt::Display for UnusedRows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let told: Vec<&str> = self.conditions.iter().take(TOLD).map(String::as_str).collect();
        let more = match self.conditions.len().saturating_sub(TOLD) {
            0 => String::new(),
            more => format!(" and {more} more like these"),
        };
        let lines = if self.lines.len() == 1 { "line" } else { "lines" };
        write!(
            f,
            "{}, {lines} {}, {}{more}: no case of the study has {}",
            self.file,
            ranges(&self.lines),
            told.join(", "),
            match self.conditions.len() {
                1 => "this condition",
                _ => "these conditions",
            }
        )?;
        match &self.meant {
            Some(form) => write!(f, "; did you mean {form}?"),
            None => Ok(()),
        }
    }
}

/// `3, 5–8` for 3, 5, 6, 7, 8.
fn ranges(lines: &[usize]) -> String {
    let mut ranges: Vec<[usize; 2]> = Vec::new();
    for &line in lines {
        match ranges.last_mut() {
            Some([_, last]) if *last + 1 == line => *last = line,
            _ => ranges.push([line, line]),
        }
    }
    let shown = ranges.iter().map(|[first, last]| match first == last {
        true => first.to_string(),
        false => format!("{first}–{last}"),
    });
    shown.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(conditions: &[&str], forms: &[&str]) -> Vec<String> {
        let rows = conditions.iter().map(|case| {
            format!("{case},twist,chord_rotation,deg,washout,,50,,1.0,0.1,stated,none\n")
                + &format!("{case},twist,chord_rotation,deg,washout,,60,,1.0,0.1,stated,none\n")
        });
        let head = crate::input::measurement::COLUMNS.join(",");
        let text = format!("{head}\n{}", rows.collect::<String>());
        let file = Measurement::from_csv(&text, "m.csv").unwrap();
        unused(&file, &["bending-1"], forms)
            .iter()
            .map(UnusedRows::to_string)
            .collect()
    }

    #[test]
    fn a_slip_in_a_condition_is_told_with_its_lines_and_what_was_meant() {
        let forms = ["bending-{mass}"];
        assert_eq!(told(&["bending-1"], &forms), [""; 0]);
        assert_eq!(
            told(&["bending-1", "bendng-2.5"], &forms),
            [
                "m.csv, lines 4–5, bendng-2.5: no case of the study has this condition; did you mean bending-{mass}?"
            ]
        );
        let comma = told(&["bending-1", "bending_2"], &forms);
        assert!(comma[0].contains("did you mean bending-{mass}?"), "{comma:?}");
    }

    #[test]
    fn what_is_left_out_on_purpose_is_told_in_one_line_of_its_kind() {
        let names: Vec<String> = (0..8).map(|speed| format!("aero-5-{speed}0")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let all = [&["bending-1"], &names[..], &["twist-v1"]].concat();
        assert_eq!(
            told(&all, &["bending-{mass}", "twist-v2"]),
            [
                "m.csv, lines 4–19, aero-5-00, aero-5-10, aero-5-20, aero-5-30, aero-5-40, aero-5-50 and 2 more like these: \
                 no case of the study has these conditions",
                "m.csv, lines 20–21, twist-v1: no case of the study has this condition"
            ]
        );
    }
}
