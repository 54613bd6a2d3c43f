//! The lines of a mesh file, with their numbers, and the numbers that stand in them.

use super::error::{FileDefect, GmshError};

/// Reads a file line by line; blank lines do not count.
#[derive(Debug, Clone)]
pub struct Lines<'a> {
    file: &'a str,
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
}

/// One line that is not blank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line<'a> {
    /// Its number, from 1.
    pub number: usize,
    /// Its text, trimmed.
    pub text: &'a str,
}

impl<'a> Lines<'a> {
    /// The lines of `text`, which stands in `file`.
    pub fn new(text: &'a str, file: &'a str) -> Lines<'a> {
        Lines {
            file,
            lines: text.lines().enumerate(),
        }
    }

    /// The next line; `None` at the end of the file.
    pub fn next_line(&mut self) -> Option<Line<'a>> {
        self.lines
            .by_ref()
            .map(|(index, text)| Line {
                number: index + 1,
                text: text.trim(),
            })
            .find(|line| !line.text.is_empty())
    }

    /// The next line of `section`; an error at the end of the file.
    pub fn line_of(&mut self, section: &str) -> Result<Line<'a>, GmshError> {
        self.next_line().ok_or_else(|| self.truncated(section))
    }

    /// The line that closes `section`; an error if anything else stands there.
    pub fn close(&mut self, section: &str) -> Result<(), GmshError> {
        let line = self.line_of(section)?;
        let closing = closing(section);
        if line.text == closing {
            return Ok(());
        }
        let found = shorten(line.text);
        Err(self.error(
            Some(line.number),
            FileDefect::Count {
                section: section.to_string(),
                closing,
                found,
            },
        ))
    }

    /// The numbers of the next line of `section`: exactly `count` of them.
    pub fn numbers<T: std::str::FromStr>(
        &mut self,
        section: &str,
        count: usize,
        expected: &'static str,
    ) -> Result<(usize, Vec<T>), GmshError> {
        let line = self.line_of(section)?;
        match parse_all(line.text) {
            Some(numbers) if numbers.len() == count => Ok((line.number, numbers)),
            _ => Err(self.record(line, expected)),
        }
    }

    /// A line that is not what should stand there.
    pub fn record(&self, line: Line, expected: &'static str) -> GmshError {
        self.error(
            Some(line.number),
            FileDefect::Record {
                expected,
                found: shorten(line.text),
            },
        )
    }

    /// The file ends inside a section.
    pub fn truncated(&self, section: &str) -> GmshError {
        let section = section.to_string();
        let closing = closing(&section);
        self.error(None, FileDefect::Truncated { section, closing })
    }

    /// An error in this file.
    pub fn error(&self, line: Option<usize>, defect: FileDefect) -> GmshError {
        GmshError {
            file: self.file.to_string(),
            line,
            defect,
        }
    }
}

/// `$EndNodes` for `$Nodes`.
fn closing(section: &str) -> String {
    format!("$End{}", section.trim_start_matches('$'))
}

fn parse_all<T: std::str::FromStr>(text: &str) -> Option<Vec<T>> {
    text.split_whitespace().map(|word| word.parse().ok()).collect()
}

/// The first characters of a line, enough to find it again.
pub fn shorten(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut short: String = text.chars().filter(|c| !c.is_control()).take(LONGEST).collect();
    if text.chars().count() > LONGEST {
        short.push('…');
    }
    short
}
