//! Dotted paths of keys, such as `rod[0].section.diameter_mm`.

use std::fmt;

/// One step of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Step {
    /// Into a table, by key.
    Key(String),
    /// Into a list, by number from 0.
    Index(usize),
}

/// A dotted path, from the top level of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct KeyPath(pub Vec<Step>);

impl KeyPath {
    /// Reads a path; the error is a sentence that says what is wrong with it.
    pub fn parse(text: &str) -> Result<KeyPath, String> {
        let mut steps = Vec::new();
        for part in text.split('.') {
            let (name, mut rest) = part.split_at(part.find('[').unwrap_or(part.len()));
            let allowed = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
            if name.is_empty() || !name.chars().all(allowed) {
                return Err(format!("\"{name}\" is no key (letters, digits, _ and - only)"));
            }
            steps.push(Step::Key(name.to_string()));
            while !rest.is_empty() {
                let index = rest.strip_prefix('[').and_then(|inner| inner.split_once(']'));
                let Some((number, after)) = index else {
                    return Err(format!("\"{rest}\" must be a number in brackets, such as [0]"));
                };
                let number = number
                    .parse()
                    .map_err(|_| format!("\"{number}\" must be a whole number from 0"))?;
                steps.push(Step::Index(number));
                rest = after;
            }
        }
        Ok(KeyPath(steps))
    }

    /// This path and one key more.
    pub fn key(&self, key: &str) -> KeyPath {
        let mut steps = self.0.clone();
        steps.push(Step::Key(key.to_string()));
        KeyPath(steps)
    }

    /// This path and one index more.
    pub fn index(&self, index: usize) -> KeyPath {
        let mut steps = self.0.clone();
        steps.push(Step::Index(index));
        KeyPath(steps)
    }
}

impl fmt::Display for KeyPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) if number == 0 => write!(f, "{key}")?,
                Step::Key(key) => write!(f, ".{key}")?,
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_reads_and_prints_the_same() {
        for text in [
            "name",
            "rod[0].section.diameter_mm",
            "planform.outline[2][1]",
            "material.m60j-prepreg.e_gpa",
        ] {
            assert_eq!(KeyPath::parse(text).unwrap().to_string(), text);
        }
    }

    #[test]
    fn broken_paths_are_refused() {
        for text in ["", "a..b", "rod[", "rod[x].a", "rod[-1]", "rod[0]x", "a b", "[0]"] {
            assert!(KeyPath::parse(text).is_err(), "{text}");
        }
    }
}
