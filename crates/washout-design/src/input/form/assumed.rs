//! Assumed values: a number inside its own range, both inside the allowed one.

use super::range::in_range;
use crate::input::document::{Entry, Node, NodeValue};
use crate::input::error::{InputError, Number, Problem, Range};
use crate::input::keys::Key;
use crate::input::path::KeyPath;

/// The keys of an assumed value.
const KEYS: [&str; 3] = ["assumed", "range", "why"];

/// `{ assumed = NUMBER, range = [LOW, HIGH], why = "..." }`.
pub(super) fn check(
    node: &Node,
    entries: &[Entry],
    range: Option<Range>,
    key: &Key,
    path: &KeyPath,
) -> Result<(), InputError> {
    let example = key.example.as_deref().unwrap_or("1.0");
    let assumed = Assumed {
        node,
        entries,
        range,
        key,
        path,
        example,
        pattern: format!(
            "Write an assumed value as {} = {{ assumed = {example}, range = [LOW, HIGH], why = \"...\" }}",
            key.name
        ),
    };
    assumed.refuse_other_keys()?;
    assumed.refuse_missing_keys()?;
    let (value, ends) = assumed.numbers()?;
    match ends[..] {
        [low, high] => assumed.lies_in_its_own_range(value, [low, high]),
        _ => Ok(()),
    }
}

/// An assumed value as it stands in the file.
struct Assumed<'a> {
    node: &'a Node,
    entries: &'a [Entry],
    range: Option<Range>,
    key: &'a Key,
    path: &'a KeyPath,
    example: &'a str,
    /// How one is written.
    pattern: String,
}

impl Assumed<'_> {
    fn fault(&self, node: &Node, name: &str, problem: Problem, cure: &str) -> InputError {
        let full = self.path.key(name).to_string();
        InputError::new(node.place(), &full, &node.shown(), problem, cure)
    }

    fn wrong_type(&self, node: &Node, name: &str, expected: &str, found: String) -> InputError {
        let expected = expected.to_string();
        self.fault(node, name, Problem::WrongType { expected, found }, &self.pattern)
    }

    fn refuse_other_keys(&self) -> Result<(), InputError> {
        let mut entries = self.entries.iter();
        let Some(entry) = entries.find(|entry| !KEYS.contains(&entry.key.as_str())) else {
            return Ok(());
        };
        let allowed = KEYS.map(str::to_string).to_vec();
        let full = self.path.key(&entry.key).to_string();
        let (pattern, name, example) = (&self.pattern, &self.key.name, self.example);
        let cure = format!("{pattern}; or state it as {name} = {example}");
        let problem = Problem::UnknownKey { allowed };
        Err(InputError::new(
            entry.place(),
            &full,
            &entry.node.shown(),
            problem,
            cure,
        ))
    }

    fn refuse_missing_keys(&self) -> Result<(), InputError> {
        for name in ["assumed", "range"] {
            if self.node.get(name).is_none() {
                let full = self.path.key(name).to_string();
                let (place, cure) = (self.node.place(), self.pattern.as_str());
                return Err(InputError::new(place, &full, "", Problem::Missing, cure));
            }
        }
        Ok(())
    }

    fn number(&self, node: &Node, name: &str) -> Result<f64, InputError> {
        match node.number() {
            Some(number) => {
                in_range(node, number, self.range, self.key, &self.path.key(name)).map(|()| number)
            }
            None => Err(self.wrong_type(node, name, "a number", node.kind().to_string())),
        }
    }

    /// The value, and the ends of its own range.
    fn numbers(&self) -> Result<(f64, Vec<f64>), InputError> {
        let mut value = f64::NAN;
        let mut ends: Vec<f64> = Vec::new();
        for Entry { key: name, node, .. } in self.entries {
            match (name.as_str(), &node.value) {
                ("assumed", _) => value = self.number(node, name)?,
                ("range", NodeValue::List(items)) if items.len() == 2 => {
                    ends = items
                        .iter()
                        .map(|item| self.number(item, name))
                        .collect::<Result<_, _>>()?;
                }
                ("range", _) => {
                    let found = match &node.value {
                        NodeValue::List(items) => format!("a list of {}", items.len()),
                        _ => node.kind().to_string(),
                    };
                    return Err(self.wrong_type(node, name, "a list of two numbers, [LOW, HIGH]", found));
                }
                (_, NodeValue::Text(_)) => {}
                _ => return Err(self.wrong_type(node, name, "text in quotes", node.kind().to_string())),
            }
        }
        Ok((value, ends))
    }

    fn lies_in_its_own_range(&self, value: f64, [low, high]: [f64; 2]) -> Result<(), InputError> {
        let conflict = |message: String| Problem::Conflict {
            message,
            with: vec![
                self.path.key("assumed").to_string(),
                self.path.key("range").to_string(),
            ],
        };
        let (Some(value_node), Some(range_node)) = (self.node.get("assumed"), self.node.get("range")) else {
            return Ok(());
        };
        if low >= high {
            let message = "must rise from its lower to its upper end".to_string();
            let cure = match low == high {
                true => "A value without a range is stated, not assumed: write the number alone".to_string(),
                false => format!("Write range = [{high:?}, {low:?}]"),
            };
            return Err(self.fault(range_node, "range", conflict(message), &cure));
        }
        if value < low || value > high {
            let message = format!("must lie in its own range {} … {}", Number(low), Number(high));
            let cure = "Widen the range, or assume a value inside it";
            return Err(self.fault(value_node, "assumed", conflict(message), cure));
        }
        Ok(())
    }
}
