//! CSV tables with named columns, `#` comments, and a place for every fault.

use std::rc::Rc;

use super::error::{InputError, Place, Problem, Range};
use super::nearest::nearest;

/// A table as read: all wanted columns are there, every record is whole.
#[derive(Debug)]
pub(crate) struct Table {
    /// Comment lines at the head, without `#`.
    pub comments: Vec<String>,
    /// Records in the order of the file.
    pub records: Vec<Record>,
}

/// One record of a table.
#[derive(Debug)]
pub(crate) struct Record {
    file: Rc<str>,
    /// Line on which it starts.
    pub line: usize,
    fields: Vec<(&'static str, String)>,
}

impl Table {
    /// Reads a table that must have these columns, in any order, and may have the optional ones, and no other.
    pub fn parse(
        file: &str,
        text: &str,
        columns: &[&'static str],
        optional: &[&'static str],
    ) -> Result<Table, InputError> {
        let name: Rc<str> = file.into();
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let headers = reader
            .headers()
            .map_err(|error| broken(file, text, &error))?
            .clone();
        let line = line_of_row(text, headers.position());
        check_header(file, line, &headers, columns, optional)?;
        let mut records = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| broken(file, text, &error))?;
            let fields = headers.iter().zip(record.iter()).filter_map(|(header, field)| {
                let mut known = columns.iter().chain(optional);
                let column = known.find(|column| **column == header)?;
                Some((*column, field.to_string()))
            });
            records.push(Record {
                file: name.clone(),
                line: line_of_row(text, record.position()),
                fields: fields.collect(),
            });
        }
        if records.is_empty() {
            let message = "has a header but no rows";
            return Err(InputError::about_file(
                file,
                message,
                format!("Give rows with {}", columns.join(",")),
            ));
        }
        let comments = text.lines().map_while(|line| line.trim_start().strip_prefix('#'));
        Ok(Table {
            comments: comments.map(|comment| comment.trim().to_string()).collect(),
            records,
        })
    }
}

impl Record {
    /// The text of a column.
    pub fn text(&self, column: &str) -> &str {
        let field = self.fields.iter().find(|(name, _)| *name == column);
        field.map_or("", |(_, text)| text)
    }

    /// A finite number.
    pub fn number(&self, column: &str, cure: &str) -> Result<f64, InputError> {
        let text = self.text(column);
        if text.is_empty() {
            return Err(self.fault(column, Problem::Missing, cure));
        }
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(self.fault(column, Problem::NotFinite, cure)),
            Err(_) => {
                let problem = Problem::WrongType {
                    expected: "a number".to_string(),
                    found: "text".to_string(),
                };
                Err(self.fault(column, problem, cure))
            }
        }
    }

    /// A finite number in a range.
    pub fn number_in(&self, column: &str, range: Range, cure: &str) -> Result<f64, InputError> {
        let number = self.number(column, cure)?;
        match range.contains(number) {
            true => Ok(number),
            false => Err(self.fault(column, Problem::OutOfRange { range }, cure)),
        }
    }

    /// One of some words.
    pub fn word<T: Copy>(&self, column: &str, words: &[(&str, T)], cure: &str) -> Result<T, InputError> {
        let text = self.text(column);
        if text.is_empty() {
            return Err(self.fault(column, Problem::Missing, cure));
        }
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == text) {
            return Ok(*value);
        }
        let near = nearest(text, words.iter().map(|(word, _)| *word));
        let allowed = words.iter().map(|(word, _)| word.to_string()).collect();
        let cure = match near {
            Some(near) => format!("Did you mean {near}? {cure}"),
            None => cure.to_string(),
        };
        Err(self.fault(column, Problem::UnknownValue { allowed }, &cure))
    }

    /// An error about a column of this record.
    pub fn fault(&self, column: &str, problem: Problem, cure: &str) -> InputError {
        InputError::new(self.place(), column, self.text(column), problem, cure)
    }

    /// An error about a column that contradicts another.
    pub fn conflict(
        &self,
        column: &str,
        message: impl Into<String>,
        with: &[&str],
        cure: &str,
    ) -> InputError {
        let problem = Problem::Conflict {
            message: message.into(),
            with: with.iter().map(|column| column.to_string()).collect(),
        };
        self.fault(column, problem, cure)
    }

    fn place(&self) -> Place {
        Place {
            file: self.file.to_string(),
            line: Some(self.line),
            column: None,
        }
    }
}

/// The line of the row that starts at or after a position, which may lie before comments and blank lines.
pub(super) fn line_of_row(text: &str, position: Option<&csv::Position>) -> usize {
    let start = position.map_or(0, |position| position.byte() as usize);
    let line = position.map_or(1, |position| position.line() as usize);
    let lines = text.get(start..).unwrap_or_default().lines();
    let skipped = lines
        .take_while(|line| line.is_empty() || line.starts_with('#'))
        .count();
    line + skipped
}

fn check_header(
    file: &str,
    line: usize,
    headers: &csv::StringRecord,
    columns: &[&'static str],
    optional: &[&'static str],
) -> Result<(), InputError> {
    let fail = |column: &str, problem: Problem, cure: String| {
        let place = Place {
            file: file.to_string(),
            line: Some(line),
            column: None,
        };
        Err(InputError::new(
            place,
            &format!("column {column}"),
            "",
            problem,
            cure,
        ))
    };
    let mut all = format!("The columns are {}", columns.join(","));
    if !optional.is_empty() {
        all.push_str(&format!(", and if wanted {}", optional.join(",")));
    }
    let known: Vec<&'static str> = columns.iter().chain(optional).copied().collect();
    for (number, header) in headers.iter().enumerate() {
        if !known.contains(&header) {
            let cure = instead_of(header, &known, all);
            let message = "is not known".to_string();
            let with = columns.iter().map(|column| column.to_string()).collect();
            return fail(
                &format!("\"{header}\""),
                Problem::Conflict { message, with },
                cure,
            );
        }
        if headers.iter().take(number).any(|other| other == header) {
            let message = "stands twice".to_string();
            return fail(
                header,
                Problem::Conflict {
                    message,
                    with: Vec::new(),
                },
                all,
            );
        }
    }
    match columns
        .iter()
        .find(|column| !headers.iter().any(|header| header == **column))
    {
        Some(column) => fail(column, Problem::Missing, all),
        None => Ok(()),
    }
}

/// What to write instead of a column that is not known; `all`: the columns there are, in words.
fn instead_of(header: &str, known: &[&'static str], all: String) -> String {
    match nearest(header, known.iter().copied()) {
        Some(near) => format!("Did you mean {near}? {all}"),
        None if header.contains([';', '\t']) => {
            format!("Columns are separated by commas, not by semicolons or tabs. {all}")
        }
        None => all,
    }
}

fn broken(file: &str, text: &str, error: &csv::Error) -> InputError {
    let place = Place {
        file: file.to_string(),
        line: error.position().map(|position| line_of_row(text, Some(position))),
        column: None,
    };
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => {
            format!("the row has {len} values, the header {expected_len}")
        }
        _ => format!("is not a CSV table: {error}"),
    };
    let cure =
        "Separate values by commas, leave a value empty where there is none, quote text that has a comma";
    InputError::new(place, "", "", Problem::Syntax { message }, cure)
}
