//! What is wrong with an input, where, and how to cure it.

use std::fmt;
use std::ops::Deref;

/// Where in a file a thing stands. Lines and columns count from 1; a column counts characters.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// File as the user named it, or `--set`.
    pub file: String,
    /// Line, where there is one.
    pub line: Option<usize>,
    /// Column, where there is one.
    pub column: Option<usize>,
}

impl Place {
    /// A file as a whole.
    pub fn file(file: &str) -> Self {
        Place {
            file: file.to_string(),
            line: None,
            column: None,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(column) = self.column {
            write!(f, ":{column}")?;
        }
        Ok(())
    }
}

/// An input that is refused. The details are boxed, so that results stay small.
#[derive(Debug, Clone, PartialEq)]
pub struct InputError(Box<InputFault>);

/// The details of an [`InputError`].
#[derive(Debug, Clone, PartialEq)]
pub struct InputFault {
    /// Where it stands.
    pub place: Place,
    /// Dotted path of the key, such as `rod[0].section.diameter_mm`, or the column of a table; empty for a file as a whole.
    pub key: String,
    /// The value as it stands in the file, shortened; empty where there is none.
    pub value: String,
    /// What is wrong.
    pub problem: Problem,
    /// What to do.
    pub cure: String,
}

/// What is wrong with an input.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// A number outside of its range.
    #[error("must lie in {range}")]
    OutOfRange {
        /// The allowed range.
        range: Range,
    },
    /// NaN or infinity.
    #[error("must be a finite number")]
    NotFinite,
    /// Text instead of a number, and the like.
    #[error("must be {expected}, not {found}")]
    WrongType {
        /// What is expected, with its article.
        expected: String,
        /// What stands there, with its article.
        found: String,
    },
    /// A word that is not among the allowed ones.
    #[error("must be {}{}", if allowed.len() > 1 { "one of " } else { "" }, allowed.join(", "))]
    UnknownValue {
        /// The allowed words.
        allowed: Vec<String>,
    },
    /// A key that does not exist.
    #[error("unknown key")]
    UnknownKey {
        /// The allowed keys at this place.
        allowed: Vec<String>,
    },
    /// A key that exists with another unit.
    #[error("{} unit, {expected} is expected", if *.absent { "missing" } else { "wrong" })]
    WrongUnit {
        /// True where the key has no unit at all.
        absent: bool,
        /// The key with the unit that is expected.
        expected: String,
    },
    /// A key that must stand but does not.
    #[error("is missing")]
    Missing,
    /// Not the language it should be.
    #[error("{message}")]
    Syntax {
        /// What the parser says.
        message: String,
    },
    /// A file that cannot be read, or is not what it should be.
    #[error("{message}")]
    File {
        /// What is wrong with it.
        message: String,
    },
    /// A value that is allowed by itself but not together with another.
    #[error("{message}")]
    Conflict {
        /// What contradicts what.
        message: String,
        /// Keys of the other values, for tools.
        with: Vec<String>,
    },
}

impl Problem {
    /// Whether its sentence reads on after the key, as in "rod[0].material is missing".
    fn is_predicate(&self) -> bool {
        const VERBS: [&str; 7] = ["is", "must", "cannot", "needs", "has", "loads", "stands"];
        let sentence = self.to_string();
        VERBS.contains(&sentence.split(' ').next().unwrap_or_default())
    }
}

/// A range of numbers with its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// True where the ends themselves are not allowed.
    pub open: bool,
    /// Symbol of the unit; empty for a pure number.
    pub unit: &'static str,
}

impl Range {
    /// Whether `value` lies in the range; NaN never does.
    pub fn contains(&self, value: f64) -> bool {
        if self.open {
            self.low < value && value < self.high
        } else {
            self.low <= value && value <= self.high
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} … {}", Number(self.low), Number(self.high))?;
        if !self.unit.is_empty() {
            write!(f, " {}", self.unit)?;
        }
        if self.open {
            write!(f, " (the ends excluded)")?;
        }
        Ok(())
    }
}

/// A number as people write it: no `0.000000001`, no twelve zeros.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-4..1e7).contains(&size) {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

impl InputError {
    /// An error about `key` at `place`.
    pub fn new(place: Place, key: &str, value: &str, problem: Problem, cure: impl Into<String>) -> Self {
        InputError(Box::new(InputFault {
            place,
            key: key.to_string(),
            value: shorten(value),
            problem,
            cure: cure.into(),
        }))
    }

    /// An error about a file as a whole.
    pub fn about_file(file: &str, message: impl Into<String>, cure: impl Into<String>) -> Self {
        let message = message.into();
        InputError::new(Place::file(file), "", "", Problem::File { message }, cure)
    }
}

impl Deref for InputError {
    type Target = InputFault;

    fn deref(&self) -> &InputFault {
        &self.0
    }
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.place)?;
        if !self.key.is_empty() {
            write!(f, "{}", self.key)?;
            if !self.value.is_empty() {
                write!(f, " = {}", self.value)?;
            }
            let reads_on = self.value.is_empty() && self.problem.is_predicate();
            write!(f, "{}", if reads_on { " " } else { ": " })?;
        }
        write!(f, "{}", self.problem)?;
        if !self.cure.is_empty() {
            write!(f, ".\n  {}", self.cure)?;
        }
        Ok(())
    }
}

impl std::error::Error for InputError {}

/// One line of at most 60 characters.
fn shorten(value: &str) -> String {
    let mut line = String::new();
    for word in value.split_whitespace() {
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
        if line.len() > 400 {
            break;
        }
    }
    let line: String = line
        .chars()
        .map(|c| if c.is_control() { '�' } else { c })
        .collect();
    if line.chars().count() <= 60 {
        return line;
    }
    let mut short: String = line.chars().take(57).collect();
    short.push_str("...");
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn message_has_place_key_value_problem_and_cure() {
        let place = Place {
            file: "designs/x.toml".into(),
            line: Some(12),
            column: Some(18),
        };
        let range = Range {
            low: 0.1,
            high: 1000.0,
            open: false,
            unit: "Hz",
        };
        let error = InputError::new(
            place,
            "flapping.frequency_hz",
            "-3",
            Problem::OutOfRange { range },
            "Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
        );
        assert_eq!(
            error.to_string(),
            "designs/x.toml:12:18: flapping.frequency_hz = -3: must lie in 0.1 … 1000 Hz.\n  \
             Give the flapping frequency in hertz, e.g. frequency_hz = 23.0"
        );
    }

    #[test]
    fn long_values_are_shortened_to_one_line() {
        let long = "a\n".repeat(500);
        assert!(shorten(&long).chars().count() <= 60);
        assert!(!shorten(&long).contains('\n'));
    }

    #[test]
    fn nan_lies_in_no_range() {
        let range = Range {
            low: 0.0,
            high: 1.0,
            open: false,
            unit: "",
        };
        assert!(!range.contains(f64::NAN));
    }
}
